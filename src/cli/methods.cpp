#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/text.hpp"
#include "cli/command.hpp"
#include "cli/common_options.hpp"
#include "cli/session.hpp"
#include "method/method.hpp"
#include "method/plugin/feature_claims.hpp"

namespace ccdfuzz {

namespace {

/// All that are registered and the two kinds of plug-ins, or those that were named. Throws BadInput
/// for one that there is not.
std::vector<MethodInfo> method_infos_of(const std::vector<std::string>& specs) {
  std::vector<MethodInfo> infos;
  for (const std::string& spec : specs) {
    infos.push_back(need(admit_plugin(spec).and_then([&] { return method_info(spec); })));
  }
  if (!specs.empty()) return infos;
  infos = registered_methods();
  constexpr const char* kSource = "examples/plugins/README.md";
  infos.push_back({"plugin:PATH", kSource, "yours: a shared library (ccdfuzz_plugin.h)", false});
  infos.push_back({"plugin-exec:PATH", kSource, "yours: a program, asked by lines of JSON", false});
  return infos;
}

/// A name with what it is of, and below it what it does.
void print_entry(const std::string& head, const std::string& text) {
  print_out(fmt::format("{}\n    {}\n", wrapped(head, 4, 0), wrapped(text, 4, 4)));
}

/// The switches that any of them takes.
void print_switches(const std::vector<MethodInfo>& infos) {
  bool is_first = true;
  for (const MethodSwitch& s : method_switches()) {
    std::vector<std::string> of;
    for (const MethodInfo& info : infos) {
      if (std::ranges::find(info.switches, s.name) != info.switches.end()) of.push_back(info.spec);
    }
    if (of.empty()) continue;
    if (is_first) print_out("\nBehind the name, as in tdibm@slip:\n");
    is_first = false;
    print_entry(fmt::format("@{} ({})", s.name, fmt::join(of, ", ")), s.meaning);
  }
}

int run_methods(const std::vector<std::string>& specs, Session& session) {
  const std::vector<MethodInfo> infos = method_infos_of(specs);
  if (session.json) {
    for (const MethodInfo& info : infos) {
      print_row([&](auto& row) {
        row("method", info.spec);
        row("source", info.source);
        row("description", info.description);
        row("claims_no_false_negative", info.claims_no_false_negative);
        row("switches", info.switches);
        row("takes", words_of(info.features));
        const std::vector<std::string> pairs = info.domain.pair_texts();
        if (!pairs.empty()) row("accepts", pairs);
      });
    }
    return kDone;
  }
  std::vector<std::string> marked;
  for (const MethodInfo& info : infos) {
    const bool claims = info.claims_no_false_negative;
    print_entry(fmt::format("{}{} ({})", info.spec, claims ? " *" : "", info.source),
                info.description);
    // With all methods, the list would be longer than a terminal.
    std::vector<std::string> words = info.domain.pair_texts();
    std::ranges::move(words_of(info.features), std::back_inserter(words));
    if (!specs.empty() && !words.empty()) {
      print_out(fmt::format("    takes {}\n",
                            wrapped(fmt::format("{}", fmt::join(words, ", ")), 10, 10)));
    }
    if (claims) marked.push_back(info.spec);
  }
  print_switches(infos);
  print_out(fmt::format("\n{}{}\n", mark_note(marked), counted(infos.size(), "method", "methods")));
  return kDone;
}

}  // namespace

void add_methods(CommandLine& line) {
  auto [command, specs] = line.add<std::vector<std::string>>(
      "methods", "List the methods and their guarantees", run_methods);
  command.example("what a plug-in says of itself", "methods plugin:./libmine.so");
  command.texts("method", *specs,
                "Only these, as --methods takes them, and what they take; plug-ins, too");
  command.json("One JSON object per line");
}

}  // namespace ccdfuzz
