#include "certify/checker/work_done.hpp"

namespace ccdfuzz {

namespace {

thread_local std::uint64_t done_here = 0;

}  // namespace

std::uint64_t work_done_here() {
  return done_here;
}

void do_work_here(std::uint64_t work) {
  done_here += work;
}

UncountedWork::~UncountedWork() {
  done_here = before_;
}

}  // namespace ccdfuzz
