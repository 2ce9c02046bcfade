#include <fmt/format.h>

#include <algorithm>

#include "base/table.hpp"
#include "cli/command.hpp"
#include "cli/output.hpp"
#include "cli/terminal.hpp"
#include "method/method.hpp"

namespace ccdfuzz {

namespace {

struct MethodsArguments {
  std::vector<std::string> specs;
  bool json = false;
};

/// All that are registered and the two kinds of plug-ins, or those that were named.
Result<std::vector<MethodInfo>> method_infos_of(const std::vector<std::string>& specs) {
  std::vector<MethodInfo> infos;
  for (const std::string& spec : specs) {
    const auto info = admit_plugin(spec).and_then([&] { return method_info(spec); });
    if (!info) return tl::unexpected(info.error());
    infos.push_back(*info);
  }
  if (!specs.empty()) return infos;
  infos = registered_methods();
  constexpr const char* kSource = "examples/plugins/README.md";
  infos.push_back({"plugin:PATH", kSource, "yours: a shared library (ccdfuzz_plugin.h)", false});
  infos.push_back({"plugin-exec:PATH", kSource, "yours: a program, asked by lines of JSON", false});
  return infos;
}

/// What may stand behind a spec, and behind which.
std::string switches_of(const std::vector<MethodInfo>& infos) {
  Table table({{"behind a spec", Align::kLeft}, {"of", Align::kLeft}, {"reads", Align::kLeft}});
  for (const MethodSwitch& s : method_switches()) {
    std::vector<std::string> of;
    for (const MethodInfo& info : infos) {
      if (std::ranges::find(info.switches, s.name) != info.switches.end()) of.push_back(info.spec);
    }
    if (of.empty()) continue;
    table.add_row(
        {{fmt::format("@{}", s.name)}, {fmt::format("{}", fmt::join(of, " "))}, {s.meaning}});
  }
  return table.row_count() == 0 ? "" : "\n" + table.to_text(wants_colour(stdout));
}

Result<int> run_methods(const MethodsArguments& options) {
  const Result<std::vector<MethodInfo>> infos = method_infos_of(options.specs);
  if (!infos) return tl::unexpected(infos.error());
  if (options.json) {
    for (const MethodInfo& info : *infos) {
      print_json({{"method", info.spec},
                  {"source", info.source},
                  {"description", info.description},
                  {"claims_no_false_negative", info.claims_no_false_negative},
                  {"switches", info.switches}});
    }
    return kDone;
  }
  Table table({{"method", Align::kLeft},
               {"claims no FN", Align::kLeft},
               {"source", Align::kLeft},
               {"description", Align::kLeft}});
  for (const MethodInfo& info : *infos) {
    table.add_row({{info.spec},
                   {info.claims_no_false_negative ? "yes" : "no"},
                   {info.source},
                   {info.description}});
  }
  print_table(table);
  print_out(switches_of(*infos));
  return kDone;
}

}  // namespace

void add_methods(CommandLine& line) {
  auto [command, options] = line.add<MethodsArguments>(
      "methods", "List the methods that there are, with the source of each", run_methods);
  command.texts("method", options->specs, "Only these, as --methods takes them; plug-ins, too");
  command.flag("--json", options->json, "One JSON object per line");
}

}  // namespace ccdfuzz
