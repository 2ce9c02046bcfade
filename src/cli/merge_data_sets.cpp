#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "base/enum_names.hpp"
#include "case/taxonomy.hpp"
#include "cli/data_set.hpp"
#include "cli/merge.hpp"
#include "cli/output.hpp"
#include "cli/terminal.hpp"
#include "eval/generation_record.hpp"

namespace ccdfuzz {

namespace {

/// A series of cases that generate numbers from 0 on, or from --first.
using CaseSeries = std::tuple<std::string, std::string, std::string, std::uint64_t>;

CaseSeries series_of(const Case& value) {
  const Origin& o = value.origin;
  return {o.contact, o.kind, o.generator, o.seed.value_or(0)};
}

std::string text_of_series(const CaseSeries& series) {
  const auto& [contact, kind, generator, seed] = series;
  return fmt::format("{} {} {}, seed {}", contact, kind, generator, seed);
}

size_t rank_of_contact(const std::string& contact) {
  const auto known = enum_named<ContactClass>(contact);
  return known ? static_cast<size_t>(*known) : kContactClasses.size();
}

size_t rank_of_kind(const std::string& kind) {
  const auto known = enum_named<CaseKind>(kind);
  return known ? static_cast<size_t>(*known) : kCaseKinds.size();
}

/// Where a case stands in a data set: class by class, in it kind by kind, but RP and RN of an index
/// side by side.
using CasePlace = std::tuple<size_t, size_t, std::uint64_t, size_t, CaseSeries>;

Result<CasePlace> place_of(const NamedCase& named) {
  const Origin& o = named.value.origin;
  if (!o.index || o.contact.empty() || o.kind.empty()) {
    return input_error(named.id,
                       "has no origin.contact, origin.kind or origin.index to place it by");
  }
  const size_t kind = rank_of_kind(o.kind);
  const size_t block = kind == static_cast<size_t>(CaseKind::kRN) ? 0 : kind;
  return CasePlace{rank_of_contact(o.contact), block, *o.index, kind, series_of(named.value)};
}

/// One of the data sets, read case by case.
class SortedCases {
 public:
  static Result<SortedCases> open(const std::string& path) {
    Result<CaseReader> reader = CaseReader::open(path);
    if (!reader) return tl::unexpected(reader.error());
    SortedCases input(path, *std::move(reader));
    if (auto read = input.advance(); !read) return tl::unexpected(read.error());
    return input;
  }

  const std::optional<NamedCase>& current() const { return current_; }
  const CasePlace& place() const { return place_; }

  Result<void> advance() {
    auto next = reader_.next();
    if (!next) return tl::unexpected(next.error());
    const bool first = !current_;
    current_ = *std::move(next);
    if (!current_) return {};
    const Result<CasePlace> place = place_of(*current_);
    if (!place) return tl::unexpected(place.error());
    if (!first && *place <= place_) {
      return input_error(current_->id, "stands out of order, or there twice");
    }
    place_ = *place;
    return {};
  }

  /// The miss tree of the current case; empty if it has none.
  Result<std::string> tree() const {
    const auto& clearance = current_->value.truth.clearance;
    const auto* tree = clearance ? std::get_if<MissTree>(&*clearance) : nullptr;
    return tree ? read_tree(trees_path(path_), tree->tree) : std::string();
  }

 private:
  SortedCases(std::string path, CaseReader reader)
      : path_(std::move(path)), reader_(std::move(reader)) {}

  std::string path_;
  CaseReader reader_;
  std::optional<NamedCase> current_;
  CasePlace place_;
};

/// The records beside the inputs as one; nothing if one of them has none.
Result<std::optional<GenerationRecord>> merge_generation_records(
    const std::vector<std::string>& inputs) {
  GenerationRecord merged;
  std::map<std::string, std::pair<std::uint64_t, std::set<std::uint64_t>>> shares;  // of each run
  for (const std::string& input : inputs) {
    const auto record = read_generation(generation_path(input));
    if (!record) return tl::unexpected(record.error());
    if (!*record) return std::nullopt;
    const GenerationRecord& r = **record;
    if (!shares.contains(r.run)) merged.run += (merged.run.empty() ? "" : "; ") + r.run;
    auto& [of, seen] =
        shares.try_emplace(r.run, r.shard.of, std::set<std::uint64_t>()).first->second;
    if (of != r.shard.of) {
      return input_error(input,
                         fmt::format("is one of {} shares, and others are of {}", r.shard.of, of));
    }
    if (!seen.insert(r.shard.index).second) {
      return input_error(input, fmt::format("share {}/{} is there twice", r.shard.index, of));
    }
    merge_costs(merged.costs, r.costs);
  }
  for (const auto& [run, share] : shares) {
    const auto& [of, seen] = share;
    for (std::uint64_t i = 0; i < of; ++i) {
      if (!seen.contains(i)) {
        return input_error("merge", fmt::format("share {}/{} of \"{}\" is missing", i, of, run));
      }
    }
  }
  std::ranges::sort(merged.costs, {}, [](const GenerationCost& cost) {
    return std::pair(rank_of_contact(cost.contact),
                     rank_of_kind(cost.kind.substr(0, cost.kind.find('+'))));
  });
  return merged;
}

}  // namespace

Result<int> merge_data_sets(const std::vector<std::string>& inputs, const std::string& output) {
  const auto record = merge_generation_records(inputs);
  if (!record) return tl::unexpected(record.error());
  std::vector<SortedCases> readers;
  for (const std::string& input : inputs) {
    Result<SortedCases> reader = SortedCases::open(input);
    if (!reader) return tl::unexpected(reader.error());
    readers.push_back(*std::move(reader));
  }
  Result<DataSetWriter> writer = DataSetWriter::open(output);
  if (!writer) return tl::unexpected(writer.error());
  std::map<CaseSeries, std::uint64_t> last;  ///< index of each series
  std::optional<CasePlace> before;
  std::uint64_t count = 0;
  for (;;) {
    std::erase_if(readers, [](const SortedCases& r) { return !r.current(); });
    if (readers.empty()) break;
    SortedCases& next = *std::ranges::min_element(readers, {}, &SortedCases::place);
    const NamedCase& named = *next.current();
    if (before == next.place()) return input_error(named.id, "is there twice, in two of the files");
    before = next.place();
    const std::uint64_t index = *named.value.origin.index;
    const auto [known, is_first] = last.emplace(series_of(named.value), index);
    if (!is_first && index != known->second + 1) {
      return input_error(named.id, fmt::format("index {} follows {} of {}: is a share left out?",
                                               index, known->second, text_of_series(known->first)));
    }
    known->second = index;
    const Result<std::string> tree = next.tree();
    if (!tree) return tl::unexpected(tree.error());
    if (auto written = writer->write(named.value, *tree); !written) {
      return tl::unexpected(written.error());
    }
    ++count;
    if (auto read = next.advance(); !read) return tl::unexpected(read.error());
  }
  Result<void> done =
      *record ? write_generation(generation_path(output), **record) : Result<void>();
  done = done.and_then([&] { return writer->finish(); });
  if (!done) return tl::unexpected(done.error());
  if (*record) {
    print_table(generation_table((*record)->costs));
    print_out("\n");
  }
  print_out(fmt::format("{} cases of {} files in {}\n", count, inputs.size(), output));
  return 0;
}

}  // namespace ccdfuzz
