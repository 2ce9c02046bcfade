// Whole queries with a known contact: the witness is traced through all built-in methods, and those
// that are proven to lose none must not. The bytes are a case (fuzz/mutator/case_bytes.hpp);
// mutants keep their contact exactly, and how nearly each method lost it guides libFuzzer.
#include <cstdlib>
#include <iostream>
#include <numeric>

#include "eval/by_spec.hpp"
#include "fuzz/margins.hpp"
#include "fuzz/mutator/case_bytes.hpp"
#include "fuzz/mutator/mutate.hpp"
#include "query/case_json.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

using namespace ccdfuzz;  // NOLINT: a target is a file of its own

struct Traced {
  const char* method;
  bool is_sound;  ///< proven to lose no contact
};

/// Those that are sound look at every input, and one of the others, which are ten times as slow.
constexpr std::size_t kSound = 2;
constexpr std::array kTraced = {Traced{"tdibm-c", true},        Traced{"tdibm-rational", true},
                                Traced{"tdibm", false},         Traced{"tdibm-h:1e-16", false},
                                Traced{"tdibm-h:1e-12", false}, Traced{"tdibm-h-rel:1e-12", false},
                                Traced{"tdibm-e", false},       Traced{"tdibm-e-literal", false},
                                Traced{"trad", false}};
static_assert(kTraced.size() <= Margins::kMethods);

std::size_t put(const std::optional<std::vector<std::uint8_t>>& bytes, std::uint8_t* data,
                std::size_t max_size) {
  if (!bytes || bytes->size() > max_size) return 0;
  std::copy(bytes->begin(), bytes->end(), data);
  return bytes->size();
}

/// What an empty corpus begins with: a point that falls on a line.
WitnessedQuery first_query() {
  WitnessedQuery q;
  q.query.patches[0] = {Shape::point(), {{0, 0, 1}}, {{0, 0, -1}}};
  q.query.patches[1] = {Shape::curve(1), {{-1, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}};
  q.t = Dyadic(1);
  q.uv[1][0] = Dyadic(Integer(1), -1);
  return q;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned int seed) {
  Random random(seed);
  // Some of libFuzzer's own mutations too: what they break is repaired where it can be.
  if (random.below(8) == 0) return LLVMFuzzerMutate(data, size, max_size);
  const WitnessedQuery q = witnessed_query_of(std::span(data, size)).value_or(first_query());
  return put(to_bytes(mutate(q, q, random)), data, max_size);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data1, std::size_t size1,
                                                 const std::uint8_t* data2, std::size_t size2,
                                                 std::uint8_t* out, std::size_t max_size,
                                                 unsigned int seed) {
  Random random(seed);
  const auto a = witnessed_query_of(std::span(data1, size1));
  const auto b = witnessed_query_of(std::span(data2, size2));
  return a && b ? put(to_bytes(mutate(*a, *b, random)), out, max_size) : 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static TracerSet tracers;
  const auto q = witnessed_query_of(std::span(data, size));
  if (!q) return -1;  // not for the corpus
  const Witness witness = q->witness();
  const std::size_t sum = std::accumulate(data, data + size, std::size_t{0});
  const std::size_t other = kSound + sum % (kTraced.size() - kSound);
  for (std::size_t m = 0; m < kTraced.size(); ++m) {
    if (m >= kSound && m != other) continue;
    const Trace& trace = tracers[kTraced[m].method].trace(q->query, witness, {});
    Margins::note(m, trace);
    if (!trace.lost || !kTraced[m].is_sound) continue;
    std::cerr << kTraced[m].method << " loses the contact of this case; show it with"
              << " `ccdfuzz trace CASE.json`:\n"
              << to_json(case_of(*q)) << '\n';
    std::abort();
  }
  return 0;
}
