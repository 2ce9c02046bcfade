#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "generators/generate.hpp"
#include "query/case.hpp"

namespace ccdfuzz {

/// One draw of the hunt: a case with exact truth, as it is put to the methods.
struct Draw {
  /// A positive case at t* and past it (kHorizonFactors), so that late answers show; a negative one
  /// as it stands.
  std::vector<Case> asked;
};

/// Draw number `index` of a contact class. The draws go round both constructions and all stress
/// families that have the class. scale: leaves out what is not within it (is_within_scale), if need
/// be all. Depends on the arguments alone.
Draw draw(ContactClass contact, std::uint64_t seed, std::uint64_t index,
          std::optional<int> scale = std::nullopt);

/// The same of linear queries, of one of kLinearClasses.
Draw draw_of_linear(ContactClass contact, std::uint64_t seed, std::uint64_t index,
                    std::optional<int> scale = std::nullopt);

/// The latest draws of each class, kept because the methods of a class walk the same sequence and
/// most of them stay close together. Safe to call from several threads.
class DrawCache {
 public:
  explicit DrawCache(std::uint64_t seed, std::optional<int> scale = std::nullopt,
                     bool linear = false)
      : seed_(seed), scale_(scale), linear_(linear) {}

  std::shared_ptr<const Draw> get(ContactClass contact, std::uint64_t index);

 private:
  static constexpr size_t kKept = 512;  ///< a class: a few MB in all

  struct Slot {
    std::uint64_t index = 0;
    std::shared_ptr<const Draw> draw;
  };

  std::uint64_t seed_;
  std::optional<int> scale_;
  bool linear_;
  std::mutex mutex_;
  std::array<std::vector<Slot>, kContactClasses.size()> slots_;
};

}  // namespace ccdfuzz
