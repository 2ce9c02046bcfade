// libFuzzer inside of the scoreboard: its driver is a function here, which a run's process calls.
// It leaves it only by finding something or by running out of time.
#include "fuzz_drivers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>

#include "fuzz/margins.hpp"
#include "fuzz/mutator/case_bytes.hpp"
#include "fuzz/mutator/mutate.hpp"
#include "generators/draw/choice_bytes.hpp"
#include "properties/suites.hpp"
#include "property_turns.hpp"
#include "sound.hpp"

extern "C" {
int LLVMFuzzerRunDriver(int* argc, char*** argv,
                        int (*test)(const std::uint8_t* data, std::size_t size));
std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
}

namespace ccdfuzz {

namespace {

/// The one run of this process.
struct FuzzerRun {
  Driver driver = Driver::kRawFuzzer;
  double end = 0;
  std::uint64_t most = 0;
  DriverRun result;
  Heartbeat heart;
  const std::function<void(const DriverRun&)>* done = nullptr;
};

FuzzerRun& current_run() {
  static FuzzerRun run;
  return run;
}

/// Neither is right nor wrong: not for libFuzzer's corpus.
constexpr const char* kNoInput = "-";

/// Two triangles of degree 2, their numbers being the bytes; 0 where these end.
std::string check_raw(std::span<const std::uint8_t> data) {
  Query query;
  std::size_t at = 0;
  for (MovingPatch<double>& patch : query.patches) {
    patch.shape = Shape::triangle(2);
    for (Points<double>* points : {&patch.positions, &patch.velocities}) {
      points->resize(static_cast<std::size_t>(patch.shape.control_count()), Vec3<double>(0, 0, 0));
      for (Vec3<double>& p : *points) {
        for (int k = 0; k < 3 && at + sizeof(double) <= data.size(); ++k, at += sizeof(double)) {
          std::memcpy(&p[k], data.data() + at, sizeof(double));
          if (!std::isfinite(p[k])) return kNoInput;
        }
      }
    }
  }
  return contradiction(query);
}

/// The first byte says what the others are. They are a case for the project's decoder, or a byte
/// that names a property and then the choices that it draws from.
constexpr std::uint8_t kIsProperty = 128;
constexpr std::size_t kCaseHead = 1, kPropertyHead = 2;

const std::vector<Property>& fuzzed_properties() {
  static const std::vector<Property> those_that_hold = [] {
    std::vector<Property> list;
    for (const Property& p : properties()) {
      if (p.expected == Expectation::kHolds) list.push_back(p);
    }
    return list;
  }();
  return those_that_hold;
}

std::string check_decoded(std::span<const std::uint8_t> data) {
  static TracerSet tracers;
  if (data.size() < kPropertyHead) return kNoInput;
  if (data[0] >= kIsProperty) {
    const auto& list = fuzzed_properties();
    const Property& property = list[data[1] % list.size()];
    Draw choices = Draw::from_numbers(choices_of(data.subspan(kPropertyHead)));
    const Check check = run(property, choices);
    const bool fails = check.status == Check::Status::kFails;
    return fails ? fmt::format("{}: {}", property.name, check.text) : "";
  }
  const auto q = contact_of_bytes(data.subspan(kCaseHead));
  if (!q) return kNoInput;
  const Witness witness = q->witness();
  for (std::size_t m = 0; m < kSoundMethods.size(); ++m) {
    Margins::note(m, tracers[kSoundMethods[m]].trace(q->query, witness, {.precision = 0x1p-8}));
  }
  return lost_contact(case_of(*q), {.asks = data.back() % 4 == 0}, tracers);
}

int test_one(const std::uint8_t* data, std::size_t size) {
  FuzzerRun& run = current_run();
  const std::span input(data, size);
  run.heart.beat();
  std::string found;
  try {
    found = run.driver == Driver::kRawFuzzer ? check_raw(input) : check_decoded(input);
  } catch (const std::exception& error) {
    found = std::string("an exception: ") + error.what();
  }
  ++run.result.executions;
  const bool none = found == kNoInput;
  if (!none) run.result.found = found;
  const bool over = run.result.executions >= run.most || cpu_seconds_used() >= run.end;
  if (over || !run.result.found.empty()) (*run.done)(run.result);
  return none ? -1 : 0;
}

/// An input of one kind, whatever it was before.
std::size_t begin_anew(std::uint8_t* data, std::size_t max_size, Draw& random) {
  data[0] = static_cast<std::uint8_t>(random.below(256));
  if (data[0] < kIsProperty) {
    const auto bytes = to_bytes(falling_point());
    if (!bytes || bytes->size() + kCaseHead > max_size) return 0;
    std::copy(bytes->begin(), bytes->end(), data + kCaseHead);
    return kCaseHead + bytes->size();
  }
  const std::size_t size = std::min<std::size_t>(max_size, kPropertyHead + random.below(1024));
  for (std::size_t i = 1; i < size; ++i) {
    // Small choices are coincidences: half of all.
    data[i] = static_cast<std::uint8_t>(random.below(random.below(2) == 0 ? 8 : 256));
  }
  return size;
}

}  // namespace

void drive_fuzzer(Driver driver, std::uint64_t seed, const DriveLimit& limit,
                  const std::function<void(const DriverRun&)>& done) {
  current_run() = {driver, cpu_seconds_used() + limit.cpu_seconds, limit.executions, {}, {}, &done};
  if (std::freopen("/dev/null", "w", stderr) == nullptr) std::abort();
  std::vector<std::string> words = {"scoreboard",
                                    fmt::format("-seed={}", seed),
                                    driver == Driver::kRawFuzzer ? "-max_len=576" : "-max_len=4096",
                                    "-len_control=0",
                                    "-detect_leaks=0",
                                    "-rss_limit_mb=0",
                                    "-timeout=0",     // hangs are the heartbeat's, in CPU time
                                    "-handle_int=0",  // an end from outside must look like one
                                    "-handle_term=0",
                                    "-reload=0",
                                    "-exact_artifact_path=/dev/null"};
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  int argc = static_cast<int>(pointers.size());
  char** argv = pointers.data();
  LLVMFuzzerRunDriver(&argc, &argv, test_one);
  std::abort();  // it ends by itself only if it cannot begin
}

}  // namespace ccdfuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned int seed) {
  using namespace ccdfuzz;  // NOLINT: of this function alone
  if (current_run().driver == Driver::kRawFuzzer) return LLVMFuzzerMutate(data, size, max_size);
  Draw random{Random(seed)};
  if (size < kPropertyHead || random.below(8) == 0) return begin_anew(data, max_size, random);
  const std::size_t head = data[0] < kIsProperty ? kCaseHead : kPropertyHead;
  if (data[0] >= kIsProperty || random.below(8) == 0) {
    return head + LLVMFuzzerMutate(data + head, size - head, max_size - head);
  }
  const Contact q = contact_of_bytes(std::span(data + head, size - head)).value_or(falling_point());
  const auto bytes = to_bytes(mutate(q, q, random));
  if (!bytes || bytes->size() + head > max_size) return 0;
  std::copy(bytes->begin(), bytes->end(), data + head);
  return head + bytes->size();
}
