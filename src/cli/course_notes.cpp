#include "cli/course_notes.hpp"

#include <utility>

namespace ccdfuzz {

namespace {

constexpr size_t kMostSamples = 400;
constexpr double kFirstStepSeconds = 0.25;
/// Half of what there is room for: a hunt by cases never comes to the halving.
constexpr double kStepShare = 2.0 / kMostSamples;

/// Every second sample, the first one included.
std::vector<HuntSample> every_second(std::vector<HuntSample> samples) {
  std::vector<HuntSample> kept;
  for (size_t i = 0; i < samples.size(); i += 2) kept.push_back(std::move(samples[i]));
  return kept;
}

}  // namespace

CourseNotes::CourseNotes(std::vector<std::string> methods, bool by_cases)
    : course_{std::move(methods), {}},
      by_cases_(by_cases),
      step_(by_cases ? kStepShare : kFirstStepSeconds) {}

void CourseNotes::note(double seconds, const HuntProgress& progress) {
  const double at = by_cases_ ? progress.share : seconds;
  if (at < next_ && progress.share < 1) return;
  std::vector<HuntSample>& samples = course_.samples;
  if (samples.size() == kMostSamples) {
    samples = every_second(std::move(samples));
    step_ *= 2;
  }
  samples.push_back(
      {seconds, progress.queries, progress.mutants, progress.finds, progress.margins});
  next_ = at + step_;
}

}  // namespace ccdfuzz
