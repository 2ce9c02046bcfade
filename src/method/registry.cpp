#include <fmt/format.h>

#include <functional>

#include "method/method.hpp"

namespace ccdfuzz {

namespace {

struct Family {
  MethodInfo info;
  /// Makes the method; the argument is what stands after ':', empty if nothing does.
  std::function<Result<std::unique_ptr<Method>>(const std::string& argument)> make;
};

const std::vector<Family>& families() {
  static const std::vector<Family> all = {};
  return all;
}

}  // namespace

const std::vector<MethodInfo>& registered_methods() {
  static const std::vector<MethodInfo> infos = [] {
    std::vector<MethodInfo> out;
    for (const Family& f : families()) out.push_back(f.info);
    return out;
  }();
  return infos;
}

namespace {

/// The family whose name stands before ':' in spec, and the argument after it.
Result<std::pair<const Family*, std::string>> find_family(const std::string& spec) {
  const size_t colon = spec.find(':');
  const std::string name = spec.substr(0, colon);
  for (const Family& f : families()) {
    if (f.info.spec.substr(0, f.info.spec.find(':')) == name) {
      return std::pair(&f, colon == std::string::npos ? "" : spec.substr(colon + 1));
    }
  }
  return input_error("--methods", fmt::format("unknown method \"{}\"", spec));
}

}  // namespace

Result<MethodInfo> method_info(const std::string& spec) {
  return find_family(spec).map([](const auto& found) { return found.first->info; });
}

Result<std::unique_ptr<Method>> make_method(const std::string& spec) {
  return find_family(spec).and_then(
      [](const auto& found) { return found.first->make(found.second); });
}

Result<std::vector<std::string>> parse_method_list(const std::string& list) {
  std::vector<std::string> specs;
  for (size_t begin = 0; begin <= list.size();) {
    const size_t end = std::min(list.find(',', begin), list.size());
    specs.push_back(list.substr(begin, end - begin));
    if (auto method = make_method(specs.back()); !method) return tl::unexpected(method.error());
    begin = end + 1;
  }
  return specs;
}

}  // namespace ccdfuzz
