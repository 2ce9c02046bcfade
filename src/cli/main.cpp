#include <gmp.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <new>

#include "base/fp_guard.hpp"
#include "cli/command.hpp"
#include "hunt/metamorphic.hpp"
#include "hunt/serve.hpp"
#include "properties/suites.hpp"

namespace {

void* or_throw(void* memory) {
  return memory == nullptr ? throw std::bad_alloc() : memory;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace ccdfuzz;
  // A library that was loaded into this process may have set another, which all threads inherit.
  const FpGuard guard;
  // GMP's own would abort where there is no memory left.
  mp_set_memory_functions(
      [](size_t bytes) { return or_throw(std::malloc(bytes)); },
      [](void* old, size_t, size_t bytes) { return or_throw(std::realloc(old, bytes)); }, nullptr);
  std::vector<Property> claims = properties();
  std::ranges::move(metamorphic_claims(), std::back_inserter(claims));
  serve_if_asked(argc, argv, {.claims = claims});
  CommandLine line(claims, suite_named);
  for (const auto add :
       {add_hunt, add_query, add_trace, add_generate, add_evaluate, add_import, add_export,
        add_verify, add_prove, add_merge, add_triage, add_replay, add_minimize, add_report,
        add_bench, add_methods, add_check, add_properties}) {
    add(line);
  }
  return line.parse_and_run(argc, argv);
}
