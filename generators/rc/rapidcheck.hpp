#pragma once

#include <rapidcheck.h>

#include <functional>
#include <iosfwd>
#include <string>

#include "base/enum_names.hpp"
#include "case/answer.hpp"
#include "case/case.hpp"
#include "generators/contact.hpp"
#include "generators/draw_contact.hpp"
#include "generators/generate.hpp"
#include "method/method.hpp"

namespace ccdfuzz {

/// How RapidCheck shows counterexamples: the contact, and each control point as position + t
/// velocity. Then comes all of it as one line in the format of cases, for `ccdfuzz query` and
/// `ccdfuzz trace`. Numbers are the shortest that are read as the same doubles.
void showValue(const Shape& shape, std::ostream& out);
void showValue(const Query& query, std::ostream& out);
void showValue(const Contact& contact, std::ostream& out);
void showValue(const Case& value, std::ostream& out);
/// "hit at 0.5", "miss", …
void showValue(const Answer& answer, std::ostream& out);
/// The name of a verdict, an outcome, a class.
template <NamedEnum E>
void showValue(E value, std::ostream& out) {
  out << name_of(value);
}

/// Generators for RapidCheck. Values shrink towards fewer control points, fewer numbers that are
/// not 0, fewer digits and less motion. Every shrink keeps the stated contact and truth.
namespace gen {

/// Two patches that touch: draw_contact. promised: the queries that the code promises to answer,
/// of which alone contacts are drawn and shrunk. Its pairs, if any, are the shapes, in this order.
/// Errors: throws std::invalid_argument if validate refuses the range, if both have shapes, and for
/// a promised scale below kLeastScale. For linear patches that need not be ordinary it takes
/// kLeastLinearScale, too. At smaller ones some draws found nothing, at these none of 50 to 200.
/// It refuses `plane`, and `initial_overlap` without `ordinary`. The generator throws if
/// kMostRefused contacts in a row are not promised, as in a range of another scale.
inline constexpr int kMostRefused = 2000;
inline constexpr int kLeastScale = 5, kLeastLinearScale = 3;
rc::Gen<Contact> contact(const ContactRange& range = {}, const Domain& promised = {});

/// A case of the inverse construction, Steps I–VI, and its truth. The seed of the options is not
/// used. Errors: throws std::invalid_argument if validate refuses the options.
rc::Gen<Case> inverse(const GeneratorOptions& options);

/// The same of any class, kind and shapes, and of any family of plain patches (kFamilies).
rc::Gen<Case> inverse();

/// A contact with one to four moves that keep it (mutate): towards coincidences, other parameters,
/// higher degrees, parts of a second contact. promised: the queries that the code promises to
/// answer, in which mutants of such contacts stay. Where none of those tried does, it is the
/// contact itself. Errors: throws std::invalid_argument for `plane`, and for `initial_overlap`
/// without `ordinary`. The generator does so if a contact of `of` is not promised.
rc::Gen<Contact> mutant(const rc::Gen<Contact>& of, const Domain& promised = {});

/// The spec of a registered method that the filter takes, for make_method; of "tdibm-h:F" with F
/// from 1e-16 to 1e-3. Errors: throws std::invalid_argument if the filter takes none.
rc::Gen<std::string> method(const std::function<bool(const MethodInfo&)>& filter);
rc::Gen<std::string> method();

}  // namespace gen
}  // namespace ccdfuzz

namespace rc {

/// A shape has at most degree 4.
template <>
struct Arbitrary<ccdfuzz::Shape> {
  static Gen<ccdfuzz::Shape> arbitrary();
};
/// Half of them have a contact, half any finite numbers.
template <>
struct Arbitrary<ccdfuzz::Query> {
  static Gen<ccdfuzz::Query> arbitrary();
};
/// A third of them come at times that no float is, which shows what code rounds. Half of the
/// patches touch at any place.
template <>
struct Arbitrary<ccdfuzz::Contact> {
  static Gen<ccdfuzz::Contact> arbitrary() { return ccdfuzz::gen::contact({.off_grid = true}); }
};
template <>
struct Arbitrary<ccdfuzz::Case> {
  static Gen<ccdfuzz::Case> arbitrary() { return ccdfuzz::gen::inverse(); }
};

}  // namespace rc
