#include "finds/unite.hpp"

#include <tuple>

#include "certify/checker/check_case.hpp"
#include "files/check_file.hpp"
#include "files/tree_file.hpp"

namespace ccdfuzz {

namespace {

/// How much a truth says of absence of contact: whether by a certificate, until when, whether that
/// is included.
std::tuple<bool, Rational, bool> absence_of(const Truth& truth, const Rational& t_max) {
  const bool is_clear = truth.collides == false;
  Rational until = is_clear ? t_max : Rational(0);
  if (truth.clear_until && *truth.clear_until > until) until = *truth.clear_until;
  if (truth.clearance) until = until_of(*truth.clearance);
  const bool includes = truth.clearance ? covers(*truth.clearance, until) : is_clear;
  return {truth.clearance.has_value(), until, includes};
}

/// Takes the part of another truth over if there is none, or it is earlier by `time`.
template <class Part, class Time>
void take_earlier(std::optional<Part>& part, const std::optional<Part>& other, const Time& time) {
  if (other && (!part || time(*other) < time(*part))) part = other;
}

/// is_absence_of_find: gets whether what is said of absence is what find says.
Truth united_truth(const Truth& old, const Truth& find, const Rational& t_max,
                   bool& is_absence_of_find) {
  Truth truth = old;
  take_earlier(truth.witness, find.witness, [](const Witness& w) { return w.t; });
  take_earlier(truth.contact_box, find.contact_box, [](const ContactBox& b) { return b.until(); });
  take_earlier(truth.contact_root, find.contact_root, [](const ContactRoot& r) { return r.by; });
  is_absence_of_find = absence_of(old, t_max) < absence_of(find, t_max);
  const Truth& absence = is_absence_of_find ? find : old;
  truth.clear_until = absence.clear_until;
  truth.clearance = absence.clearance;
  truth.proof = absence.proof;
  truth.collides = std::nullopt;
  const bool is_clear_to_end = !truth.clearance || covers(*truth.clearance, t_max);
  if ((old.collides == false || find.collides == false) && is_clear_to_end) truth.collides = false;
  if (old.collides == true || find.collides == true) truth.collides = true;
  if (truth.clearance) return truth;
  // A method's word falls with a contact that is proven.
  const std::optional<Rational> by = truth.contact_by();
  if (truth.clear_until && by && *by < *truth.clear_until) truth.clear_until.reset();
  if (truth.collides == true && !truth.clear_until) truth.proof.reset();
  if (truth.collides == false) truth.proof = kProofWords[2];
  return truth;
}

}  // namespace

United unite(const NamedCase& old, const Case& find, const std::string& trees,
             const AskAgain& again) {
  Case other = find;
  if (trees.empty()) drop_tree(other.truth);
  United united{old.value, trees_path(old.id)};
  Case& value = united.value;
  bool is_absence_of_find = false;
  value.truth =
      united_truth(value.truth, other.truth, exact(value.query.t_max), is_absence_of_find);
  if (is_absence_of_find) united.trees = trees;
  const bool is_of_both = value.truth != old.value.truth && value.truth != other.truth;
  if (is_of_both && !check_with_trees(value, united.trees)) {
    united = {old.value, trees_path(old.id)};
  }

  const auto stands_by = [&](const Case& entry) {
    return entry.truth == value.truth && entry.asked == value.asked;
  };
  const bool is_old_sure = stands_by(old.value), is_find_sure = stands_by(other);
  value.expect.insert(other.expect.begin(), other.expect.end());
  if (!again) return united;
  std::optional<CheckedCase> known;
  for (auto& [method, expected] : value.expect) {
    const auto by_old = old.value.expect.find(method);
    const auto by_find = other.expect.find(method);
    const bool is_of_old = by_old != old.value.expect.end();
    const bool is_of_find = by_find != other.expect.end();
    const bool is_disputed = is_of_old && is_of_find && !(by_old->second == by_find->second);
    const bool is_sure = (is_old_sure && is_of_old) || (is_find_sure && is_of_find);
    if (is_sure && !is_disputed) continue;
    if (!known) {
      known = checked_or_unknown(value, tree_of(value.truth, united.trees).value_or(""));
    }
    if (const auto shown = again(method, *known)) expected = *shown;
  }
  return united;
}

}  // namespace ccdfuzz
