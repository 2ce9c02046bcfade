#include "cli/made_cases.hpp"

#include <fmt/format.h>

#include "cli/output.hpp"

namespace ccdfuzz {

namespace {

constexpr std::string_view kHexDigits = "0123456789abcdef";

}  // namespace

void JsonForm<HexBytes>::write(std::string& json, const HexBytes& hex) {
  json += '"';
  for (const char byte : hex.bytes) {
    const auto value = static_cast<unsigned char>(byte);
    json += kHexDigits[value / 16];
    json += kHexDigits[value % 16];
  }
  json += '"';
}

void JsonForm<HexBytes>::read(const JsonCursor& from, HexBytes& hex) {
  const std::string& digits = from.string();
  if (digits.size() % 2 != 0 || digits.find_first_not_of(kHexDigits) != std::string::npos) {
    from.refuse("is not bytes in hexadecimal digits");
  }
  hex.bytes.clear();
  for (size_t i = 0; i < digits.size(); i += 2) {
    hex.bytes +=
        static_cast<char>(kHexDigits.find(digits[i]) * 16 + kHexDigits.find(digits[i + 1]));
  }
}

Result<MadeSet> MadeSet::open(const std::string& path) {
  MadeSet set;
  if (path.empty() || path == "-") return set;
  Result<DataSetWriter> writer = DataSetWriter::open(path);
  if (!writer) return tl::unexpected(writer.error());
  set.path_ = path;
  set.writer_ = std::move(*writer);
  return set;
}

Result<void> MadeSet::add(MadeCases made) {
  add_cost(costs_, made.cost);
  for (auto& [value] : made.cases) {
    ++cases_;
    Result<void> written;
    if (!made.tree.bytes.empty()) {
      value.truth.clearance = MissTree{exact(value.query.t_max), {}};
      value.truth.proof = proof_word(*value.truth.clearance);
      ++trees_;
    }
    if (writer_) {
      written = writer_->write(std::move(value), made.tree.bytes);
    } else {
      print_out(to_json(value) + "\n");
      written = check_stdout();
    }
    if (!written) return written;
  }
  return {};
}

Result<void> MadeSet::finish() {
  if (!writer_) return flush_stdout();
  return write_costs(path_, costs_).and_then([&] { return writer_->finish(); });
}

}  // namespace ccdfuzz
