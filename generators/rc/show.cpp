#include <fmt/format.h>
#include <fmt/ranges.h>

#include <ostream>

#include "files/case_json.hpp"
#include "generators/rc/rapidcheck.hpp"

namespace ccdfuzz {

namespace {

std::string point_text(const Vec3<double>& p) {
  return fmt::format("({}, {}, {})", p[0], p[1], p[2]);
}

/// With the parameters that the shapes have.
std::string witness_text(const Witness& witness, const Query& query) {
  std::string text = fmt::format("touch at t = {}", to_text(witness.t));
  for (std::size_t s = 0; s < 2; ++s) {
    const auto& [u, v] = witness.uv[s];
    const int parameters = query.patches[s].shape.parameter_count();
    text += fmt::format("{} patch {}", s == 0 ? ":" : ", and", s + 1);
    if (parameters > 0) text += " at u = " + to_text(u);
    if (parameters > 1) text += ", v = " + to_text(v);
  }
  return text + '\n';
}

std::string truth_text(const Case& value) {
  const Truth& truth = value.truth;
  if (truth.witness) return witness_text(*truth.witness, value.query);
  if (!truth.collides) return "whether they touch is not known\n";
  return *truth.collides ? "they touch\n" : "they do not touch\n";
}

void show_query(const Query& query, std::ostream& out) {
  for (std::size_t s = 0; s < 2; ++s) {
    const MovingPatch<double>& patch = query.patches[s];
    out << fmt::format("patch {}, {}:\n", s + 1, to_text(patch.shape));
    for (std::size_t i = 0; i < patch.positions.size(); ++i) {
      out << fmt::format("  {} {} {}", point_text(patch.positions[i]),
                         patch.has_ends() ? "to" : "+ t", point_text(patch.moves()[i]));
      out << (patch.weights.empty() ? "\n" : fmt::format(", weight {}\n", patch.weights[i]));
    }
  }
  for (const MovingPatch<double>& patch : query.patches) {
    if (!patch.faces.empty()) {
      out << fmt::format("{} is a mesh with {}: {}\n", to_text(patch.shape),
                         patch.one_sided ? "fronts alone" : "two sides", patch.faces);
    }
    if (!patch.turn) continue;
    const auto& [from, to, centre, spin] = *patch.turn;
    out << (spin.empty()
                ? fmt::format("{} turns from ({}) to ({}) about {}\n", to_text(patch.shape),
                              fmt::join(from, ", "), fmt::join(to, ", "), point_text(centre))
                : fmt::format("{} spins by ({}) about {}\n", to_text(patch.shape),
                              fmt::join(spin, ", "), point_text(centre)));
  }
  out << fmt::format("asked up to t = {}", query.t_max);
  if (query.separation > 0) out << fmt::format(", for distances up to {}", query.separation);
  out << '\n';
}

}  // namespace

void showValue(const Shape& shape, std::ostream& out) {
  out << to_text(shape);
}

void showValue(const Query& query, std::ostream& out) {
  Case unknown;
  unknown.query = query;
  showValue(unknown, out);
}

void showValue(const Contact& contact, std::ostream& out) {
  Case known = case_of(contact);
  known.origin.kind.clear();
  known.origin.generator.clear();
  showValue(known, out);
}

void showValue(const Answer& answer, std::ostream& out) {
  out << name_of(answer.verdict);
  if (answer.has_toi()) out << fmt::format(" at {}", *answer.toi);
  if (!answer.note.empty()) out << ": " << answer.note;
}

void showValue(const Case& value, std::ostream& out) {
  const Origin& origin = value.origin;
  for (const std::string& word : {origin.contact, origin.kind}) {
    if (!word.empty()) out << word << ' ';
  }
  out << truth_text(value);
  show_query(value.query, out);
  // RapidCheck closes a bracket after it, which is no part of the case.
  out << "as a case, for ccdfuzz query and trace:\n" << to_json(value) << '\n';
}

}  // namespace ccdfuzz
