#include "hunt/serve.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

#include "hunt/served_claim.hpp"
#include "io/serve.hpp"
#include "method/served_method.hpp"

namespace ccdfuzz {

namespace {

[[noreturn]] void refuse(const std::string& why) {
  std::fputs(fmt::format("ccdfuzz: serve: {}\n", why).c_str(), stderr);
  std::exit(2);
}

}  // namespace

void serve_if_asked(int argc, char** argv, const Served& served) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty() || words[0] != "serve") return serve_by_this_program();
  words.erase(words.begin());
  // Help is for the command line to show.
  if (words.size() == 1 && (words[0] == "--help" || words[0] == "-h")) return;
  double cpu_seconds = 0;
  if (words.size() >= 2 && words[0] == "--cpu-seconds") {
    cpu_seconds = std::strtod(words[1].c_str(), nullptr);
    words.erase(words.begin(), words.begin() + 2);
  }
  if (words.size() != 1) refuse("needs METHOD, such as tdibm-c");
  const std::string& what = words[0];
  if (what == "--triage") serve_lines(served.errand, cpu_seconds);
  if (what == "--claims") {
    serve_lines([&](const std::string& question) { return served_check(served.claims, question); },
                cpu_seconds);
  }
  const auto method = served.make(what);
  if (!method) refuse(method.error().message());
  serve_lines([&](const std::string& question) { return served_answer(what, **method, question); },
              cpu_seconds);
}

}  // namespace ccdfuzz
