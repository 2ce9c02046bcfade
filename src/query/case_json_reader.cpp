#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <initializer_list>

#include "numeric/double_parts.hpp"
#include "query/case_json.hpp"
#include "query/json_tree.hpp"

namespace ccdfuzz {

namespace {

/// Thrown within this file only, to leave the reader at the first fault.
struct Refusal {
  InputError error;
};

/// A value and its path in the file.
class Node {
 public:
  Node(const JsonValue& value, const std::string& file) : value_(&value), file_(file) {}

  [[noreturn]] void refuse(std::string what) const {
    throw Refusal{{path_.empty() ? file_ : fmt::format("{}: {}", file_, path_), std::move(what)}};
  }
  [[noreturn]] void refuse_value(std::string_view why) const {
    refuse(fmt::format("{} {}", shown(*value_), why));
  }

  const JsonValue& value() const { return *value_; }
  bool is_null() const { return value_->kind == JsonKind::kNull; }

  const Node& expect(JsonKind kind, const char* name) const {
    if (value_->kind != kind) refuse_value(fmt::format("is not {}", name));
    return *this;
  }
  const std::string& string() const { return expect(JsonKind::kString, "a string").value_->text; }
  double real() const { return take(parse_case_real(*value_)); }
  Rational rational() const {
    expect(JsonKind::kString, "a string \"p\" or \"p/q\"");
    return take(parse_rational(value_->text));
  }
  template <class Int>
  Int integer(Int lo, Int hi) const {
    const std::string& text = value_->text;
    Int x{};
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), x);
    const bool is_integer =
        value_->kind == JsonKind::kNumber && text.find_first_of(".eE") == std::string::npos;
    if (!is_integer) refuse_value("is not an integer");
    if (status != std::errc() || end != text.data() + text.size() || x < lo || hi < x) {
      refuse_value(fmt::format("is outside {}..{}", lo, hi));
    }
    return x;
  }

  size_t size() const { return value_->items.size(); }
  Node at(size_t i) const { return {value_->items[i], file_, fmt::format("{}[{}]", path_, i)}; }
  /// This array of exactly `count` items.
  const Node& array(size_t count, const char* of_what) const {
    expect(JsonKind::kArray, "an array");
    if (size() != count) refuse(fmt::format("needs {} {}, not {}", count, of_what, size()));
    return *this;
  }

  /// This object, which has no keys but these.
  const Node& object(std::initializer_list<const char*> known) const {
    expect(JsonKind::kObject, "an object");
    for (const std::string& key : value_->keys) {
      if (std::find(known.begin(), known.end(), key) == known.end()) {
        member(key)->refuse(fmt::format("unknown key (known here: {})", fmt::join(known, ", ")));
      }
    }
    return *this;
  }
  std::optional<Node> member(std::string_view key) const {
    const JsonValue* found = value_->find(key);
    if (found == nullptr) return std::nullopt;
    return Node(*found, file_, member_path(path_, key));
  }
  Node required(const char* key, const char* why = "") const {
    if (auto found = member(key)) return *found;
    throw Refusal{
        {fmt::format("{}: {}", file_, member_path(path_, key)), fmt::format("missing{}", why)}};
  }

 private:
  Node(const JsonValue& value, const std::string& file, std::string path)
      : value_(&value), file_(file), path_(std::move(path)) {}

  template <class T>
  T take(Result<T> result) const {
    if (!result) refuse(result.error().what);
    return *std::move(result);
  }

  const JsonValue* value_;
  const std::string& file_;
  std::string path_;
};

Shape read_shape(const Node& patch) {
  const Node kind = patch.required("shape");
  const std::string& name = kind.string();
  const auto degree = [](const Node& node) { return node.integer(1, kMaxDegree); };
  if (name == "point") {
    if (const auto extra = patch.member("degree")) extra->refuse("a point has no degree");
    return Shape::point();
  }
  if (name == "curve") return Shape::curve(degree(patch.required("degree")));
  if (name == "triangle") return Shape::triangle(degree(patch.required("degree")));
  if (name == "tensor") {
    const Node degrees = patch.required("degree").array(2, "degrees");
    const int n = degree(degrees.at(0));
    return Shape::tensor(n, degree(degrees.at(1)));
  }
  kind.refuse_value("is not a shape (point, curve, triangle, tensor)");
}

Points<double> read_points(const Node& node, const Shape& shape) {
  const auto count = static_cast<size_t>(shape.control_count());
  node.expect(JsonKind::kArray, "an array");
  if (node.size() != count) {
    node.refuse(
        fmt::format("{} needs {} control points, not {}", to_text(shape), count, node.size()));
  }
  Points<double> points(count);
  for (size_t i = 0; i < count; ++i) {
    const Node point = node.at(i);
    point.array(3, "coordinates");
    for (int k = 0; k < 3; ++k) points[i][k] = point.at(static_cast<size_t>(k)).real();
  }
  return points;
}

MovingPatch<double> read_patch(const Node& node) {
  node.object({"shape", "degree", "positions", "velocities"});
  MovingPatch<double> patch;
  patch.shape = read_shape(node);
  patch.positions = read_points(node.required("positions"), patch.shape);
  patch.velocities = read_points(node.required("velocities"), patch.shape);
  return patch;
}

Witness read_witness(const Node& node) {
  node.object({"t", "uv"});
  Witness witness;
  witness.t = node.required("t").rational();
  const Node uv = node.required("uv").array(2, "pairs of parameters, one a patch");
  for (size_t s = 0; s < 2; ++s) {
    const Node pair = uv.at(s).array(2, "parameters");
    witness.uv[s] = {pair.at(0).rational(), pair.at(1).rational()};
  }
  return witness;
}

template <class T, size_t N, class Read>
std::array<T, N> read_array(const Node& node, const char* of_what, const Read& read) {
  node.array(N, of_what);
  std::array<T, N> out;
  for (size_t i = 0; i < N; ++i) out[i] = read(node.at(i));
  return out;
}

ContactBox read_contact_box(const Node& node) {
  node.object({"centre", "dependent", "varied", "radius", "inverse"});
  const auto real = [](const Node& n) { return n.real(); };
  ContactBox box;
  box.centre = read_array<double, 5>(node.required("centre"), "unknowns", real);
  box.dependent = read_array<int, 2>(node.required("dependent"), "barycentrics, one a patch",
                                     [](const Node& n) { return n.integer(0, 2); });
  const Node varied = node.required("varied");
  box.varied = read_array<int, 3>(varied, "unknowns",
                                  [](const Node& n) { return n.integer(0, ContactBox::kTime); });
  if (box.varied[0] >= box.varied[1] || box.varied[1] >= box.varied[2]) {
    varied.refuse("an array that is not ascending");
  }
  box.radius = read_array<double, 3>(node.required("radius"), "radii", [](const Node& n) {
    const double radius = n.real();
    if (radius <= 0) n.refuse_value("is not > 0");
    return radius;
  });
  box.inverse = read_array<std::array<double, 3>, 3>(
      node.required("inverse"), "rows",
      [&](const Node& row) { return read_array<double, 3>(row, "columns", real); });
  return box;
}

ContactRoot read_contact_root(const Node& node) {
  node.object({"polynomial", "from", "by"});
  ContactRoot root;
  const Node polynomial = node.required("polynomial").expect(JsonKind::kArray, "an array");
  if (polynomial.size() > kMaxRootDegree + 1) {
    polynomial.refuse(fmt::format("has {} coefficients; the degree is at most {}",
                                  polynomial.size(), kMaxRootDegree));
  }
  for (size_t k = 0; k < polynomial.size(); ++k) {
    const Rational coefficient = polynomial.at(k).rational();
    if (coefficient.get_den() != 1) polynomial.at(k).refuse_value("is not a whole number");
    root.polynomial.push_back(coefficient.get_num());
  }
  root.from = node.required("from").rational();
  root.by = node.required("by").rational();
  return root;
}

TreeRef read_tree_ref(const Node& node) {
  node.object({"offset", "length", "xxh3"});
  constexpr std::uint64_t kMost = std::uint64_t{1} << 62;
  TreeRef tree;
  tree.offset = node.required("offset").integer<std::uint64_t>(0, kMost);
  tree.length = node.required("length").integer<std::uint64_t>(1, kMost);
  const Node hash = node.required("xxh3");
  tree.xxh3 = hash.string();
  if (tree.xxh3.size() != 32 ||
      tree.xxh3.find_first_not_of("0123456789abcdef") != std::string::npos) {
    hash.refuse_value("is not 32 lower-case hexadecimal digits");
  }
  return tree;
}

Clearance read_clearance(const Node& node) {
  const Node kind = node.required("kind");
  if (kind.string() == "P") {
    node.object({"kind", "until", "normal", "offset"});
    return MovingPlane{node.required("until").rational(),
                       read_array<Rational, 3>(node.required("normal"), "components",
                                               [](const Node& n) { return n.rational(); }),
                       node.required("offset").rational()};
  }
  if (kind.string() == "T") {
    node.object({"kind", "until", "tree"});
    return MissTree{node.required("until").rational(), read_tree_ref(node.required("tree"))};
  }
  if (kind.string() == "L") {
    node.object({"kind", "until", "closed"});
    const Node closed = node.required("closed").expect(JsonKind::kBool, "true or false");
    return LinearClearance{node.required("until").rational(), closed.value().text == "true"};
  }
  kind.refuse_value("is not a certificate of absence (P, T, L)");
}

void read_certificate(const Node& node, Truth& truth) {
  node.object({"contact", "root", "clear"});
  if (const auto root = node.member("root")) truth.contact_root = read_contact_root(*root);
  if (const auto contact = node.member("contact")) truth.contact_box = read_contact_box(*contact);
  if (const auto clear = node.member("clear")) truth.clearance = read_clearance(*clear);
}

Truth read_truth(const Node& node) {
  node.object({"collides", "witness", "clear_until", "proof", "certificate"});
  Truth truth;
  if (const auto collides = node.member("collides"); collides && !collides->is_null()) {
    collides->expect(JsonKind::kBool, "true, false or null");
    truth.collides = collides->value().text == "true";
  }
  if (const auto witness = node.member("witness")) truth.witness = read_witness(*witness);
  if (const auto until = node.member("clear_until")) truth.clear_until = until->rational();
  if (const auto proof = node.member("proof")) {
    truth.proof = proof->string();
    if (!is_proof_word(*truth.proof)) {
      proof->refuse_value(fmt::format("is not a proof ({})", fmt::join(kProofWords, ", ")));
    }
  }
  if (const auto certificate = node.member("certificate")) read_certificate(*certificate, truth);
  if (truth.proof && *truth.proof != kProofWords[2]) {
    if (!truth.clearance || proof_word(*truth.clearance) != *truth.proof) {
      node.required("proof").refuse_value("has no certificate.clear of that kind");
    }
  }
  if (truth.collides == true && !truth.contact_box && !truth.contact_root) {
    node.required("witness", ", though collides is true");
  }
  if (truth.collides == false) node.required("proof", ", though collides is false");
  return truth;
}

Origin read_origin(const Node& node) {
  node.expect(JsonKind::kObject, "an object");
  Origin origin;
  for (const std::string& key : node.value().keys) {
    const Node member = *node.member(key);
    const auto is = [&](const char* name) { return key == name; };
    constexpr std::uint64_t kMax = std::numeric_limits<std::uint64_t>::max();
    if (is("contact")) {
      origin.contact = member.string();
    } else if (is("kind")) {
      origin.kind = member.string();
    } else if (is("generator")) {
      origin.generator = member.string();
    } else if (is("ccdfuzz")) {
      origin.ccdfuzz = member.string();
    } else if (is("name")) {
      origin.name = member.string();
    } else if (is("note")) {
      origin.note = member.string();
    } else if (is("seed")) {
      origin.seed = member.integer<std::uint64_t>(0, kMax);
    } else if (is("index")) {
      origin.index = member.integer<std::uint64_t>(0, kMax);
    } else if (member.value().kind == JsonKind::kNumber) {
      origin.more[key] = member.value().text;
    } else if (member.value().kind == JsonKind::kString) {
      origin.more[key] = json_string(member.value().text);
    } else {
      member.refuse_value("is neither a string nor a number");
    }
  }
  return origin;
}

std::map<std::string, Outcome> read_expect(const Node& node) {
  node.expect(JsonKind::kObject, "an object");
  std::map<std::string, Outcome> expect;
  for (const std::string& method : node.value().keys) {
    const Node word = *node.member(method);
    const auto outcome = outcome_named(word.string());
    if (!outcome) {
      std::array<std::string_view, kAllOutcomes.size()> names;
      std::transform(kAllOutcomes.begin(), kAllOutcomes.end(), names.begin(),
                     [](Outcome o) { return name_of(o); });
      word.refuse_value(fmt::format("is not an outcome ({})", fmt::join(names, ", ")));
    }
    expect[method] = *outcome;
  }
  return expect;
}

Case read_case(const Node& node) {
  node.expect(JsonKind::kObject, "an object");
  if (const Node format = node.required("format"); format.string() != "ccdfuzz-case") {
    format.refuse_value("is not \"ccdfuzz-case\"");
  }
  if (const Node version = node.required("version");
      version.integer(0, std::numeric_limits<int>::max()) != 1) {
    version.refuse_value("is not a version that this program reads (1)");
  }
  node.object({"format", "version", "patches", "t_max", "truth", "origin", "expect"});
  Case value;
  const Node patches = node.required("patches").array(2, "patches");
  for (size_t p = 0; p < 2; ++p) value.query.patches[p] = read_patch(patches.at(p));
  const Node t_max = node.required("t_max");
  value.query.t_max = t_max.real();
  if (compare(value.query.t_max, 0) < 0) t_max.refuse_value("is negative");
  if (const auto truth = node.member("truth")) value.truth = read_truth(*truth);
  if (const auto origin = node.member("origin")) value.origin = read_origin(*origin);
  if (const auto expect = node.member("expect")) value.expect = read_expect(*expect);
  return value;
}

}  // namespace

Result<Case> parse_case(std::string_view json, const std::string& file) {
  const auto tree = parse_json(json, file);
  if (!tree) return tl::unexpected(tree.error());
  try {
    return read_case(Node(*tree, file));
  } catch (const Refusal& refusal) {
    return tl::unexpected(refusal.error);
  }
}

}  // namespace ccdfuzz
