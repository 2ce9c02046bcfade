#include "cli/common_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/number_text.hpp"
#include "base/text.hpp"
#include "cli/default_budget.hpp"
#include "cli/session.hpp"
#include "generators/draw/choice_bytes.hpp"
#include "method/method.hpp"
#include "method/plugin/plugin_spec.hpp"

namespace ccdfuzz {

namespace {

Result<double> parse_precision(const std::string& where, const std::string& text) {
  return parse_number(where, text).and_then([&](double width) -> Result<double> {
    if (Asked::admits(width)) return width;
    return input_error(where, "{} is not in [2^-50, 1]", text);
  });
}

Result<Shape> parse_shape(const std::string& where, const std::string& text) {
  if (text == "point") return Shape::point();
  for (int n = 1; n <= kMaxDegree; ++n) {
    if (text == fmt::format("curve:{}", n)) return Shape::curve(n);
    if (text == fmt::format("triangle:{}", n)) return Shape::triangle(n);
    for (int m = 1; m <= kMaxDegree; ++m) {
      if (text == fmt::format("tensor:{}x{}", n, m)) return Shape::tensor(n, m);
    }
  }
  return input_error(where,
                     "\"{}\" is not point, curve:N, triangle:N or tensor:NxM, of degrees 1..{}",
                     text, kMaxDegree);
}

}  // namespace

void refuse_input(const char* option, const std::string& output,
                  const std::vector<std::string>& inputs, const char* what) {
  for (const std::string& input : inputs) {
    std::error_code none;
    if (!std::filesystem::equivalent(input, output, none)) continue;
    throw BadInput{{option, fmt::format("{} is one of the {}", output, what)}};
  }
}

Result<std::array<Shape, 2>> parse_shapes(const std::string& where, const std::string& text) {
  const size_t comma = text.find(',');
  CCDFUZZ_TRY(const Shape first, parse_shape(where, text.substr(0, comma)));
  if (comma == std::string::npos) return std::array{first, first};
  return parse_shape(where, text.substr(comma + 1)).map([&](const Shape& second) {
    return std::array{first, second};
  });
}

std::vector<std::string> default_methods() {
  return {"tdibm",           "tdibm-h:1e-16",  "tdibm-h:1e-12", "tdibm-e",
          "tdibm-e-literal", "tdibm-rational", "tdibm-c"};
}

std::vector<Option> add_methods(Command& command, std::vector<std::string>& methods,
                                const std::string& description) {
  Option plugins = command.plugin_names();
  Option asked = command.list("--methods LIST", methods, description, &parse_method,
                              fmt::format("{}", fmt::join(methods, ",")));
  return {plugins, asked.in("Methods")};
}

std::string option_words(const char* name, const std::vector<std::string>& values) {
  if (values.empty()) return "";
  return fmt::format(" {} {}", name, shell_word(fmt::format("{}", fmt::join(values, ","))));
}

std::string plugin_words(const std::vector<std::string>& methods) {
  std::vector<std::string> names;
  for (const std::string& method : methods) {
    if (const std::string spec = spec_behind(method); !spec.empty()) {
      names.push_back(method.substr(method.find(':') + 1) + "=" + spec);
    }
  }
  return option_words("--plugin", names);
}

std::string method_words(const std::vector<std::string>& methods) {
  return plugin_words(methods) + option_words("--methods", methods);
}

std::string marked(const std::string& method) {
  return method + (claims_no_false_negative(method) ? " *" : "");
}

std::string mark_note(const std::vector<std::string>& methods) {
  return std::ranges::any_of(methods, claims_no_false_negative)
             ? "* guarantees no false negative (missed, late)\n"
             : "";
}

Table::Column method_column() {
  return {"method", Align::kLeft, 0, 17};
}

std::string counted(std::uint64_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

Option SearchFlags::add_precision_to(Command& command) {
  return command
      .parsed("--precision WIDTH", precision,
              "Parameter width at which a pair of boxes is a hit; by default 1e-4, or what the "
              "case was found at",
              &parse_precision)
      .in("Limits");
}

std::vector<Option> SearchFlags::add_to(Command& command) {
  const Option of_precision = add_precision_to(command);
  std::vector<Option> all = add_budget_to(command);
  all.push_back(of_precision);
  return all;
}

std::vector<Option> SearchFlags::add_budget_to(Command& command) {
  Option pops = command.whole("--max-pops", max_pops,
                              "End a query as undecided after this many pairs of boxes", 1);
  Option seconds = command.parsed(
      "--max-seconds SECONDS", max_seconds,
      "End a query as undecided after this wall time; answers then depend on the machine",
      &parse_seconds);
  return {pops.in("Limits"), seconds.in("Limits")};
}

SearchOptions SearchFlags::options() const {
  SearchOptions options;
  options.precision = precision.value_or(options.precision);
  options.max_pops = max_pops.value_or(options.max_pops);
  options.max_seconds = max_seconds;
  return options;
}

SearchOptions SearchFlags::options_for(const Case& value, std::uint64_t times) const {
  SearchOptions search = options();
  const Asked& own = value.asked;
  if (!precision) search.precision = own.precision;
  // A file may ask for less work than the command's limit, never for more.
  if (own.max_pops != Asked().max_pops) {
    search.max_pops = std::min(search.max_pops, own.max_pops);
  }
  if (!max_pops) DefaultBudget::limit(search, value.query, times);
  return search;
}

std::string to_text(const NotAllowed& left_out) {
  std::string specs, names;
  std::uint64_t count = 0;
  for (const auto& [spec, expectations] : left_out) {
    std::string& list = is_plugin_name(spec) ? names : specs;
    list += (list.empty() ? "" : ",") + spec;
    count += expectations;
  }
  std::string text =
      fmt::format("{} expectation{} of plug-ins not run:", count, count == 1 ? "" : "s");
  if (!specs.empty()) text += " allow them with --allow-plugins " + shell_word(specs);
  if (!names.empty()) {
    text += fmt::format("{} say with --plugin NAME=SPEC what stands behind {}",
                        specs.empty() ? "" : ";", names);
  }
  return text;
}

std::string check_command(const std::string& property, const std::string& method,
                          const std::string& on) {
  const std::string words = method.empty() ? "" : method_words(std::vector<std::string>{method});
  return fmt::format("{} check {}{} {}", shell_word(program_name()), property, words, on);
}

std::string words_of(const ChoiceNumbers& choices) {
  return "--choices " + to_word(choices);
}

std::string words_of(std::uint64_t seed, std::uint64_t index) {
  return fmt::format("--seed {} --first {} --count 1", seed, index);
}

std::string reproduction(const ClaimFind& find) {
  return find.shrunk == Shrunk::kNot
             ? find.as_found
             : check_command(find.property, find.method, words_of(find.choices));
}

Option add_shard(Command& command, std::string& shard) {
  return command.text("--shard I/N", shard,
                      "Only share I of N, from 0 to N - 1; `merge` joins the shares");
}

Result<Shard> parse_shard(const std::string& text, std::uint64_t total, const char* what) {
  if (text.empty()) return Shard{};
  const size_t slash = text.find('/');
  const auto index = parse_whole("", text.substr(0, slash));
  const auto of = parse_whole("", slash == std::string::npos ? "" : text.substr(slash + 1));
  if (!index || !of) {
    return input_error("--shard", "\"{}\" is not of the form i/n", text);
  }
  if (*index >= *of) {
    return input_error("--shard", "{}: there is no share {} of {}", text, *index, *of);
  }
  if (*of > total) {
    return input_error("--shard", "{}: more shares than there are {}, {}", text, what, total);
  }
  return Shard{*index, *of};
}

}  // namespace ccdfuzz
