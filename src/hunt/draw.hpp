#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "case/checked_case.hpp"
#include "generators/generate.hpp"
#include "hunt/ground.hpp"
#include "method/features.hpp"

namespace ccdfuzz {

/// One draw of the hunt: a case with exact truth, as it is put to the methods.
struct HuntDraw {
  std::vector<CheckedCase> asked;  ///< forms_of
};

/// The draws of a hunt: an endless sequence for each contact class, which depends on the seed, the
/// ground and the features alone. It alternates between both constructions and all stress families
/// that have the class and the ground's shapes. Families of weights, loops, ends and separations
/// are among them where the features have these. A case is brought onto the ground where that is
/// possible (HuntGround::fitted). Else it is left out, so a draw may be empty.
class Draws {
 public:
  /// features: what any of the methods takes.
  explicit Draws(std::uint64_t seed, const HuntGround& ground = {}, const Features& features = {});

  /// Those that have draws: of shapes, those whose features they have, so VV at least.
  const std::vector<ContactClass>& classes() const { return classes_; }
  /// Requires one of these classes.
  HuntDraw at(ContactClass contact, std::uint64_t index) const;
  /// The index of draw n of those that a method of these features takes. It does not depend on what
  /// other methods take which draw that is.
  std::uint64_t index_of(ContactClass contact, const Features& taken, std::uint64_t n) const;

  /// The first draws of a class that a method of these features takes.
  struct Begun {
    Features taken;
    std::uint64_t count;
  };
  /// How many different draws are among them.
  std::uint64_t count_different(ContactClass contact, const std::vector<Begun>& begun) const;

 private:
  /// What the draws of a class go round, with the kinds of cases that are made of it. Without
  /// kinds it is draw_linear_case.
  struct Source {
    GeneratorOptions options;
    std::vector<CaseKind> kinds;
    Features needs;
  };
  /// Places of the sources of such draws.
  std::vector<size_t> places_of(ContactClass contact, const Features& taken) const;

  /// Whether patches are drawn of kLinearPairs: uniform ones; or those that are degenerate in some
  /// way, none of them ordinary.
  bool are_by_shapes() const {
    return !ground_.bodies && (ground_.uniform || (ground_.linear && !ground_.ordinary));
  }
  Case drawn_case(ContactClass contact, std::uint64_t index) const;
  void add_source(std::vector<Source>& sources, ContactClass contact,
                  const std::optional<ShapePair>& shapes, Family family, const Features& needs = {},
                  Construction construction = Construction::kOneSided) const;
  /// The families of what a query may have beyond plain patches, where features_ has that.
  void add_not_plain(std::vector<Source>& sources, ContactClass contact,
                     const std::optional<ShapePair>& shapes) const;
  std::vector<Source> linear_sources(size_t pair) const;
  std::vector<Source> sources_of(ContactClass contact) const;
  Case generated(ContactClass contact, std::uint64_t index) const;

  std::uint64_t seed_;
  HuntGround ground_;
  Features features_;
  std::vector<ContactClass> classes_;
  std::array<std::vector<Source>, kContactClasses.size()> sources_;
};

/// The latest draws of each class, kept because the methods of a class walk the same sequence and
/// most of them stay close together. Safe to call from several threads.
class DrawCache {
 public:
  /// draws must outlive it.
  explicit DrawCache(const Draws& draws) : draws_(draws) {}

  std::shared_ptr<const HuntDraw> get(ContactClass contact, std::uint64_t index);

 private:
  static constexpr size_t kKept = 512;  ///< a class: a few MB in all

  struct Slot {
    std::uint64_t index = 0;
    std::shared_ptr<const HuntDraw> draw;
  };

  const Draws& draws_;
  std::mutex mutex_;
  std::array<std::vector<Slot>, kContactClasses.size()> slots_;
};

}  // namespace ccdfuzz
