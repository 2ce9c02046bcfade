// The format of cases, field by field; docs/formats.md describes it.
#include "files/case_json.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/hex_bytes.hpp"
#include "base/verify.hpp"
#include "files/body_json.hpp"
#include "files/expected_json.hpp"
#include "io/fields.hpp"

namespace ccdfuzz {

bool Asked::admits(double precision) {
  return compare(precision, 0x1p-50) >= 0 && compare(precision, 1) <= 0;
}

template <>
struct JsonForm<Rational> {
  static void write(std::string& json, const Rational& x) { json += json_string(to_text(x)); }
  static void read(const JsonCursor& from, Rational& x) {
    if (from.value().kind != JsonKind::kString)
      from.refuse_value("is not a string \"p\" or \"p/q\"");
    Result<Rational> parsed = parse_rational(from.string());
    if (!parsed) from.refuse(parsed.error().what);
    x = *std::move(parsed);
  }
};

template <>
struct JsonForm<Integer> {
  static void write(std::string& json, const Integer& x) { json += json_string(x.get_str()); }
  static void read(const JsonCursor& from, Integer& x) {
    Rational rational;
    read_json(from, rational);
    if (rational.get_den() != 1) from.refuse_value("is not a whole number");
    x = rational.get_num();
  }
};

template <class Number>
struct JsonForm<Vec3<Number>> {
  static void write(std::string& json, const Vec3<Number>& point) {
    for (int k = 0; k < 3; ++k) {
      json += k == 0 ? '[' : ',';
      write_json(json, point[k]);
    }
    json += ']';
  }
  static void read(const JsonCursor& from, Vec3<Number>& point) {
    from.array(3, "coordinates");
    for (int k = 0; k < 3; ++k) read_json(from.item(static_cast<size_t>(k)), point[k]);
  }
};

namespace {

std::string not_empty(const Points<double>& points) {
  return points.empty() ? "has none; a patch without them has no such key" : "";
}

}  // namespace

template <>
struct JsonForm<MovingPatch<double>> {
  static void fields(auto& archive, auto& patch) {
    auto& shape = patch.shape;
    archive("shape", shape.kind);
    const auto degree = Within{1, kMaxDegree};
    if (shape.kind == ShapeKind::kTensor) {
      std::array degrees{shape.n, shape.m};
      archive("degree", degrees, Each{degree});
      if constexpr (kReads<decltype(archive)>) shape = Shape::tensor(degrees[0], degrees[1]);
    } else if (shape.parameter_count() > 0) {
      archive("degree", shape.n, degree);
    }
    if (shape.kind == ShapeKind::kHull) {
      of_hull(archive, patch);
      return;
    }
    archive("positions", patch.positions);
    if constexpr (kReads<decltype(archive)>) {
      const bool has_ends = archive.object().find("ends").has_value();
      if (has_ends && archive.object().find("velocities")) {
        archive.object().at("ends").refuse("stands beside velocities; a patch has one of them");
      }
      has_ends ? archive("ends", patch.ends, not_empty) : archive("velocities", patch.velocities);
    } else {
      patch.has_ends() ? archive("ends", patch.ends) : archive("velocities", patch.velocities);
    }
    archive.optional("weights", patch.weights, {}, [](const auto& weights) {
      return weights.empty() ? "has none; a patch without weights has no such key" : "";
    });
    archive.optional("trim", patch.trim, {}, [](const Trim& trim) {
      return trim.empty() ? "has no loop; a patch that is whole has no such key" : "";
    });
  }

 private:
  static void of_hull(auto& archive, auto& patch) {
    archive("positions", patch.positions, [](const Points<double>& points) {
      const bool fits = !points.empty() && points.size() <= size_t{kMaxControls};
      return fits ? "" : fmt::format("has {}; a hull has 1..{}", points.size(), kMaxControls);
    });
    if constexpr (kReads<decltype(archive)>) {
      patch.shape = Shape::hull(static_cast<int>(patch.positions.size()));
    }
    archive("velocities", patch.velocities);
    archive.optional("radius", patch.radius);
    turn_fields(archive, patch.turn);
    face_fields(archive, patch);
    int sides = patch.one_sided ? 1 : 2;
    archive.optional("sides", sides, 2, Within{1, 2});
    if constexpr (kReads<decltype(archive)>) patch.one_sided = sides == 1;
  }
};

template <>
struct JsonForm<Witness> {
  static void fields(auto& archive, auto& witness) {
    archive("t", witness.t);
    bool has_weights = !witness.weights[0].empty();
    if constexpr (kReads<decltype(archive)>) has_weights = !!archive.object().find("weights");
    has_weights ? archive("weights", witness.weights) : archive("uv", witness.uv);
  }
};

template <>
struct JsonForm<ContactBox> {
  static void fields(auto& archive, auto& box) {
    archive("centre", box.centre);
    archive("dependent", box.dependent, Each{Within{0, 2}});
    archive("varied", box.varied, Each{Within{0, ContactBox::kTime}}, [](const auto& places) {
      const bool ascending = places[0] < places[1] && places[1] < places[2];
      return std::string(ascending ? "" : "is not ascending");
    });
    archive("radius", box.radius, Each{positive});
    archive("inverse", box.inverse);
  }
};

template <>
struct JsonForm<ContactRoot> {
  static void fields(auto& archive, auto& root) {
    archive("polynomial", root.polynomial, [](const auto& coefficients) {
      if (coefficients.size() <= kMaxRootDegree + 1) return std::string();
      return fmt::format("has {} coefficients; the degree is at most {}", coefficients.size(),
                         kMaxRootDegree);
    });
    archive("from", root.from);
    archive("by", root.by);
  }
};

template <>
struct JsonForm<TreeBytes> {
  static void write(std::string& json, const TreeBytes& tree) {
    json += json_string(to_hex_bytes(tree.bytes));
  }
  static void read(const JsonCursor& from, TreeBytes& tree) {
    if (from.value().kind == JsonKind::kObject) return;  // the place of one in another file
    std::optional<std::string> bytes = parse_hex_bytes(from.string());
    if (!bytes) from.refuse("is not pairs of hex digits 0-9a-f");
    if (bytes->size() > MissTree::kMaxBytes) {
      from.refuse(fmt::format("has {} bytes; the most is {}", bytes->size(), MissTree::kMaxBytes));
    }
    tree.bytes = *std::move(bytes);
  }
};

template <>
struct JsonForm<Clearance> {
  static void fields(auto& archive, auto& clearance) {
    std::string kind(proof_word(clearance));
    archive("kind", kind, [](const std::string& word) {
      const bool known =
          word == "P" || word == "T" || word == "L" || word == "K" || word == "N" || word == "F";
      return std::string(known ? "" : "is not a certificate of absence (P, T, L, K, N, F)");
    });
    if constexpr (kReads<decltype(archive)>) {
      if (kind == "T") clearance = MissTree{};
      if (kind == "L") clearance = LinearClearance{};
      if (kind == "K") clearance.template emplace<BodyClearance>();
      if (kind == "N") clearance.template emplace<BodyPlanes>();
      if (kind == "F") clearance.template emplace<MeshClearance>();
    }
    std::visit([&](auto& certificate) { of(archive, certificate); }, clearance);
  }

 private:
  static void of(auto& archive, auto& certificate) {
    archive("until", certificate.until);
    if constexpr (requires { certificate.tree; }) {
      archive("tree", certificate.tree);
    } else if constexpr (requires { certificate.planes; }) {
      archive("planes", certificate.planes);
    } else if constexpr (requires { certificate.normals; }) {
      archive("closed", certificate.closed);
      archive("normals", certificate.normals);
    } else {
      if constexpr (!requires { certificate.offset; }) archive("closed", certificate.closed);
      if constexpr (requires { certificate.normal; }) archive("normal", certificate.normal);
      if constexpr (requires { certificate.offset; }) archive("offset", certificate.offset);
    }
  }
};

namespace {

/// The certificates of a truth, which stand in an object of their own.
template <class T>
struct CertificatesOf {
  T& truth;

  static void fields(auto& archive, auto& certificates) {
    auto& of = certificates.truth;
    archive.optional("contact", of.contact_box);
    archive.optional("root", of.contact_root);
    archive.optional("clear", of.clearance);
  }
};

/// Refused: a truth that lacks what it says that it rests on.
void check_supports(const JsonCursor& from, const Truth& truth) {
  if (truth.proof && *truth.proof != kProofWords[2]) {
    if (!truth.clearance || proof_word(*truth.clearance) != *truth.proof) {
      from.at("proof").refuse_value("has no certificate.clear of that kind");
    }
  }
  if (truth.collides == true && !truth.witness && !truth.contact_box && !truth.contact_root) {
    from.at("witness", ", though collides is true");
  }
  if (truth.collides == false) from.at("proof", ", though collides is false");
}

}  // namespace

template <>
struct JsonForm<Truth> {
  static void fields(auto& archive, auto& truth) {
    archive.when(true, "collides", truth.collides);
    archive.optional("witness", truth.witness);
    archive.optional("clear_until", truth.clear_until);
    archive.optional("proof", truth.proof, {}, [](const auto& word) {
      if (!word || is_proof_word(*word)) return std::string();
      return fmt::format("is not a proof ({})", fmt::join(kProofWords, ", "));
    });
    const bool any = truth.contact_box || truth.contact_root || truth.clearance;
    CertificatesOf<std::remove_reference_t<decltype(truth)>> certificates{truth};
    archive.when(any, "certificate", certificates);
    if constexpr (kReads<decltype(archive)>) check_supports(archive.object(), truth);
  }
};

template <>
struct JsonForm<Origin> {
  static void fields(auto& archive, auto& origin) {
    archive.optional("name", origin.name);
    archive.optional("contact", origin.contact);
    archive.optional("kind", origin.kind);
    archive.optional("generator", origin.generator);
    archive.optional("seed", origin.seed);
    archive.optional("index", origin.index);
    archive.optional("ccdfuzz", origin.ccdfuzz);
    archive.optional("note", origin.note);
    archive.others(origin.more);
  }
};

template <>
struct JsonForm<Asked> {
  static void fields(auto& archive, auto& asked) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
    archive.optional("precision", asked.precision, Asked().precision, [](double precision) {
      return std::string(Asked::admits(precision) ? "" : "is not in [2^-50, 1]");
    });
    archive.optional("max_pops", asked.max_pops, Asked().max_pops, Within{std::uint64_t{1}, kMost});
  }
};

namespace {

/// Takes the text or number of an origin's further key out of it.
std::optional<JsonValue> take(Origin& origin, const std::string& key) {
  const auto found = origin.more.find(key);
  if (found == origin.more.end()) return std::nullopt;
  const Result<JsonValue> value = parse_json(found->second, "");
  if (!value) return std::nullopt;
  origin.more.erase(found);
  return *value;
}

/// Version 1 has the precision and the causes among the further keys of the origin. Its cause
/// begins with the level and the axes: "level 3, axes 1-3, left root". One that no failure has
/// ("not traced") goes.
void carry_over_version_1(const JsonCursor& from, Case& value) {
  if (const auto precision = take(value.origin, "precision")) {
    const JsonCursor at = from.at("origin").at("precision");
    value.asked.precision = at.real();
    if (!Asked::admits(value.asked.precision)) at.refuse_value("is not in [2^-50, 1]");
  }
  for (auto& [method, expected] : value.expect) {
    const auto error = take(value.origin, "error of " + method);
    const auto loss = take(value.origin, "loss of " + method);
    if (expected.outcome == Outcome::kError) {
      if (error) expected.cause = error->text;
    } else if (loss) {
      const size_t comma = loss->text.rfind(", ");
      const std::string cause =
          comma == std::string::npos ? loss->text : loss->text.substr(comma + 2);
      if (fault_of_cause(expected.outcome, cause).empty()) expected.cause = cause;
    }
  }
}

void query_fields(auto& archive, auto& query) {
  archive("patches", query.patches);
  archive("t_max", query.t_max);
  archive.optional("separation", query.separation);
  if constexpr (kReads<decltype(archive)>) {
    if (const auto fault = fault_of(query)) archive.object().refuse_below(*fault);
  }
}

void case_fields(auto& archive, auto& value) {
  const int version = archive.format("ccdfuzz-case", 1, 2);
  query_fields(archive, value.query);
  archive.optional("truth", value.truth);
  archive.optional("origin", value.origin);
  if (version > 1) archive.optional("asked", value.asked);
  archive.optional("expect", value.expect);
  if constexpr (kReads<decltype(archive)>) {
    if (version == 1) carry_over_version_1(archive.object(), value);
  }
}

}  // namespace

void JsonForm<Case>::write(std::string& json, const Case& value) {
  CCDFUZZ_VERIFY(is_finite(value.query.t_max));
  json += '{';
  JsonWriter writer(json);
  case_fields(writer, value);
  json += '}';
}

void JsonForm<Case>::read(const JsonCursor& from, Case& value) {
  JsonReader reader(from);
  case_fields(reader, value);
  reader.refuse_others();
}

template <>
struct JsonForm<Query> {
  static void fields(auto& archive, auto& query) { query_fields(archive, query); }
};

Result<Query> parse_query(std::string_view json, const std::string& file) {
  return from_json<Query>(json, file, Unknown::kIgnore);
}

Result<Case> parse_case(std::string_view json, const std::string& file) {
  Case value;
  return read_json_text(json, file, [&](const JsonCursor& top) { read_json(top, value); }).map([&] {
    return std::move(value);
  });
}

std::string to_json(const Case& value, JsonLayout layout) {
  std::string json;
  write_json(json, value);
  return layout == JsonLayout::kOneLine ? json : readable_json(json);
}

}  // namespace ccdfuzz
