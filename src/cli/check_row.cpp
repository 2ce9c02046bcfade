#include "cli/check_row.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/output.hpp"

namespace ccdfuzz {

void print_check_json(const CheckedInputs& inputs, const CheckedProperty& checked) {
  const CheckTally& tally = checked.tally;
  nlohmann::ordered_json row = {{"property", checked.property.name},
                                {"expected_to_fail", checked.known_false()},
                                {"seed", inputs.seed},
                                {"first", inputs.first},
                                {"checked", tally.checked},
                                {"discarded", tally.discarded},
                                {"failed", tally.failed},
                                {"seconds", tally.seconds}};
  if (tally.all_discarded()) row["nothing_checked"] = true;
  if (tally.failed > 0) row.update({{"failure", tally.text}, {"reproduce", checked.reproduce}});
  if (checked.find) row["fails_again"] = checked.find->least.has_value();
  if (checked.find && checked.find->least) {
    row.update({{"shrunk", checked.find->least->check.text},
                {"cut_short", checked.find->least->is_cut_short},
                {"reproduce_shrunk", checked.find->reproduce},
                {"test", checked.find->test}});
  }
  if (!checked.saved.empty()) row["saved"] = checked.saved;
  if (!checked.not_saved.empty()) row["not_saved"] = checked.not_saved;
  print_json(row);
}

Table check_table(const std::vector<Property>& properties) {
  size_t name = 0;
  for (const Property& property : properties) name = std::max(name, property.name.size());
  return Table({{"property", Align::kLeft, name},
                {"checked", Align::kRight, 9},
                {"discarded"},
                {"failed", Align::kRight, 9},
                {"time", Align::kRight, 7},
                {"", Align::kLeft}});
}

void print_check_row(Table& table, const CheckedProperty& checked) {
  const CheckTally& tally = checked.tally;
  const TableCell note = tally.all_discarded() ? TableCell{"nothing was checked", Emphasis::kBad}
                         : checked.not_refuted()
                             ? TableCell{"known to be false, not refuted here"}
                             : TableCell{checked.known_false() ? "known to be false" : ""};
  table.add_row(
      {{std::string(checked.property.name)},
       {fmt::format("{}", tally.checked)},
       {fmt::format("{}", tally.discarded)},
       {fmt::format("{}", tally.failed), checked.is_finding() ? Emphasis::kBad : Emphasis::kPlain},
       {duration_text(tally.seconds)},
       note});
  print_next_rows(table);
}

void print_found(const CheckedProperty& checked) {
  print_out(fmt::format("\n{} fails: {}\nas found: {}\n", checked.property.name, checked.find->text,
                        checked.find->as_found));
  if (!checked.not_saved.empty()) print_out(fmt::format("not saved: {}\n", checked.not_saved));
  if (!checked.saved.empty()) print_out(fmt::format("saved as found: {}\n", checked.saved));
  print_out("\n");
}

void print_shrunk(const CheckedProperty& checked) {
  const CheckFind& find = *checked.find;
  std::string text = find.least
                         ? fmt::format("\nshrunk{}: {}\nreproduce: {}\n",
                                       find.least->is_cut_short ? " (not to the end)" : "",
                                       find.least->check.text, find.reproduce)
                         : "\nnot shrunk: the same input does not fail each time that it is run\n";
  if (!checked.not_saved.empty()) text += fmt::format("not saved: {}\n", checked.not_saved);
  if (!checked.saved.empty()) text += fmt::format("saved: {}\n", checked.saved);
  print_out(text + find.test + "\n");
}

}  // namespace ccdfuzz
