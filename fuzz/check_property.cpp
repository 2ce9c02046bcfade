// Any property, with any compiler: on the bytes of files (libFuzzer's finds and corpora), on bytes
// from the command line (what a failing test prints), or on random choices.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "base/text.hpp"
#include "properties/suites.hpp"

namespace ccdfuzz {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string program;
  std::string property;
  std::vector<std::string> paths;
  std::vector<std::string> hex;
  std::uint64_t random = 0;
  std::uint64_t seed = 1;
};

int refuse(const std::string& message) {
  std::cerr << "check_property: " << message << '\n';
  return 2;
}

/// Checks one input after the other, prints those that fail, and counts.
class Checker {
 public:
  Checker(const Property& property, std::string program)
      : property_(property), program_(std::move(program)) {}

  void check(Draw& choices, const std::string& input) {
    const Check result = run(property_, choices);
    ++checked_;
    if (result.status == Check::Status::kDiscarded) ++discarded_;
    if (result.status != Check::Status::kFails) return;
    ++failed_;
    std::cout << fmt::format("{} fails on {}: {}\nreproduce: {} {} --hex {}\n", property_.name,
                             input, result.text, shell_word(program_), property_.name,
                             to_hex_word(choices.bytes()));
  }

  int finish() const {
    if (checked_ == 0) return refuse("nothing to check: name files, --hex or --random");
    std::cout << fmt::format("{}: {} checked, {} discarded, {} failed\n", property_.name, checked_,
                             discarded_, failed_);
    if (discarded_ == checked_) std::cout << "nothing was checked: all inputs were discarded\n";
    return failed_ == 0 && discarded_ < checked_ ? 0 : 1;
  }

 private:
  Property property_;
  std::string program_;
  std::uint64_t checked_ = 0, discarded_ = 0, failed_ = 0;
};

/// The files that a path names, in the same order everywhere.
std::vector<std::string> files_at(const std::string& path) {
  if (!fs::is_directory(path)) return {path};
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(path)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

int check_all(const Options& options) {
  const auto property = property_named(options.property);
  if (!property) return refuse(property.error().message());
  Checker checker(*property, options.program);
  for (const std::string& hex : options.hex) {
    const auto bytes = parse_hex_bytes(hex);
    if (!bytes) return refuse("--hex: " + bytes.error().message());
    Draw choices = Draw::from_bytes(*bytes);
    checker.check(choices, "--hex");
  }
  for (const std::string& path : options.paths) {
    for (const std::string& file : files_at(path)) {
      std::ifstream in(file, std::ios::binary);
      if (!in) return refuse(file + ": cannot be read");
      const std::vector<char> content{std::istreambuf_iterator<char>(in), {}};
      const std::vector<std::uint8_t> bytes(content.begin(), content.end());
      Draw choices = Draw::from_bytes(bytes);
      checker.check(choices, file);
    }
  }
  for (std::uint64_t i = 0; i < options.random; ++i) {
    Draw choices = Draw::mostly_small(Random::keyed({options.seed, i}));
    checker.check(choices, fmt::format("--seed {}, case {}", options.seed, i));
  }
  return checker.finish();
}

}  // namespace
}  // namespace ccdfuzz

int main(int argc, char** argv) {
  using namespace ccdfuzz;
  CLI::App app{"Checks one property. Exits 1 if it fails on any input or discards them all."};
  Options options;
  options.program = argv[0];
  std::string names = "One of:";
  for (const Property& p : properties()) {
    names += fmt::format("\n  {:28} {}{}", p.name, p.claim,
                         p.expected == Expectation::kFails ? " (known to be false)" : "");
  }
  app.add_option("property", options.property, "Its name")->required();
  app.add_option("paths", options.paths, "Files, or folders of files, of fuzzer bytes")
      ->check(CLI::ExistingPath);
  app.add_option("--hex", options.hex, "Bytes as hex digits");
  app.add_option("--random", options.random, "Number of random inputs");
  app.add_option("--seed", options.seed, "Seed of the random inputs, default 1");
  app.footer(names);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return check_all(options);
}
