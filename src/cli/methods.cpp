#include <fmt/format.h>

#include "cli/command.hpp"
#include "cli/output.hpp"
#include "cli/terminal.hpp"
#include "eval/table.hpp"
#include "method/method.hpp"

namespace ccdfuzz {

namespace {

struct MethodsArguments {
  bool json = false;
};

Result<int> run_methods(const MethodsArguments& options) {
  if (options.json) {
    for (const MethodInfo& info : registered_methods()) {
      print_json({{"method", info.spec},
                  {"source", info.source},
                  {"description", info.description},
                  {"claims_no_false_negative", info.claims_no_false_negative}});
    }
    return kDone;
  }
  Table table({{"method", Align::kLeft},
               {"claims no FN", Align::kLeft},
               {"source", Align::kLeft},
               {"description", Align::kLeft}});
  for (const MethodInfo& info : registered_methods()) {
    table.add_row({{info.spec},
                   {info.claims_no_false_negative ? "yes" : "no"},
                   {info.source},
                   {info.description}});
  }
  print_out(table.to_text(wants_colour(stdout)));
  return kDone;
}

}  // namespace

void add_methods(CommandLine& line) {
  auto [command, options] = line.add<MethodsArguments>(
      "methods", "List the registered methods, with the source of each", run_methods);
  command.flag("--json", options->json, "One JSON object per line");
}

}  // namespace ccdfuzz
