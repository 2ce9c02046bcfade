// What every method and the checker say of the cases of a folder, to the bit.
#include <ccdfuzz/case/judge.hpp>
#include <ccdfuzz/files/check_file.hpp>
#include <ccdfuzz/method/method.hpp>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <set>

namespace {

std::uint64_t bits(double x) {
  std::uint64_t out = 0;
  std::memcpy(&out, &x, sizeof x);
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace ccdfuzz;
  if (argc != 2) return 2;
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) {
    if (entry.path().extension() == ".json") files.insert(entry.path());
  }
  SearchOptions options;
  options.max_pops = 40;
  for (const std::filesystem::path& file : files) {
    const auto c = read_case(file.string());
    if (!c) return std::cerr << c.error().message() << '\n', 1;
    const auto checked = check_case(*c);
    std::cout << c->id << (checked ? " holds\n" : " refuted\n");
    const CheckedCase known = checked.value_or(CheckedCase());
    for (const MethodInfo& info : registered_methods()) {
      std::string spec = info.spec;
      if (spec == "oracle") continue;  // takes long
      if (spec.ends_with(":F")) spec.replace(spec.size() - 1, 1, "1e-12");
      const Answer answer = (*make_method(spec))->answer(c->value.query, options);
      std::cout << spec << ' ' << static_cast<int>(answer.verdict) << ' ' << answer.pops << ' '
                << std::hex << (answer.toi ? bits(*answer.toi) : 0);
      for (const Uv<double>& uv : answer.uv) std::cout << ' ' << bits(uv[0]) << ' ' << bits(uv[1]);
      std::cout << std::dec << ' ' << name_of(judge(known, answer)) << '\n';
    }
  }
  return files.empty() ? 1 : 0;
}
