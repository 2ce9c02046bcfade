#include "base/fp_guard.hpp"
#include "cli/command.hpp"
#include "hunt/serve.hpp"
#include "properties/suites.hpp"

int main(int argc, char** argv) {
  // A library that was loaded into this process may have set another, which all threads inherit.
  const ccdfuzz::FpGuard guard;
  ccdfuzz::serve_if_asked(argc, argv, {.claims = ccdfuzz::properties()});
  ccdfuzz::CommandLine line;
  ccdfuzz::add_hunt(line);
  ccdfuzz::add_query(line);
  ccdfuzz::add_trace(line);
  ccdfuzz::add_generate(line);
  ccdfuzz::add_evaluate(line);
  ccdfuzz::add_import(line);
  ccdfuzz::add_export(line);
  ccdfuzz::add_verify(line);
  ccdfuzz::add_prove(line);
  ccdfuzz::add_merge(line, ccdfuzz::properties());
  ccdfuzz::add_triage(line, ccdfuzz::suite_named);
  ccdfuzz::add_replay(line, ccdfuzz::properties());
  ccdfuzz::add_minimize(line);
  ccdfuzz::add_report(line);
  ccdfuzz::add_bench(line);
  ccdfuzz::add_methods(line);
  ccdfuzz::add_check(line, ccdfuzz::properties());
  ccdfuzz::add_properties(line);
  return line.parse_and_run(argc, argv);
}
