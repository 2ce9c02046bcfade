#include <fmt/format.h>

#include <algorithm>

#include "cli/command.hpp"
#include "cli/session.hpp"
#include "method/method.hpp"

namespace ccdfuzz {

namespace {

struct MethodsOptions {
  std::vector<std::string> specs;
};

/// A method, as a row of the JSON output.
struct MethodRow {
  const MethodInfo& info;

  static void fields(auto& archive, auto& row) {
    archive("method", row.info.spec);
    archive("source", row.info.source);
    archive("description", row.info.description);
    archive("claims_no_false_negative", row.info.claims_no_false_negative);
    archive("switches", row.info.switches);
  }
};

/// All that are registered and the two kinds of plug-ins, or those that were named.
std::vector<MethodInfo> method_infos_of(const std::vector<std::string>& specs) {
  std::vector<MethodInfo> infos;
  for (const std::string& spec : specs) {
    need(admit_plugin(spec));
    infos.push_back(need(method_info(spec)));
  }
  if (!specs.empty()) return infos;
  infos = registered_methods();
  constexpr const char* kSource = "examples/plugins/README.md";
  infos.push_back({"plugin:PATH", kSource, "yours: a shared library (ccdfuzz_plugin.h)", false});
  infos.push_back({"plugin-exec:PATH", kSource, "yours: a program, asked by lines of JSON", false});
  return infos;
}

/// The switches, and the specs that take each.
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

int run_methods(const MethodsOptions& options, Session& session) {
  const std::vector<MethodInfo> infos = method_infos_of(options.specs);
  session.begin_table({{"method", Align::kLeft},
                       {"claims no FN", Align::kLeft},
                       {"source", Align::kLeft},
                       {"description", Align::kLeft}});
  for (const MethodInfo& info : infos) {
    session.show(MethodRow{info}, std::nullopt, [](const MethodRow& row) -> std::vector<TableCell> {
      return {{row.info.spec},
              {row.info.claims_no_false_negative ? "yes" : "no"},
              {row.info.source},
              {row.info.description}};
    });
  }
  session.end_table();
  if (!session.json) print_out(switches_of(infos));
  return kDone;
}

}  // namespace

void add_methods(CommandLine& line) {
  auto [command, options] =
      line.add<MethodsOptions>("methods", "List the methods and their guarantees", run_methods);
  command.example("what a plug-in says of itself", "methods plugin:./libmine.so");
  command.texts("method", options->specs, "Only these, as --methods takes them; plug-ins, too");
  command.json("One JSON object per line");
}

}  // namespace ccdfuzz
