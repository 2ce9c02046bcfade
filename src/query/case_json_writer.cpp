#include <fmt/format.h>

#include "query/case_json.hpp"
#include "query/json_tree.hpp"

namespace ccdfuzz {

namespace {

/// Appends JSON text; knows where commas, and in the readable layout line breaks, belong.
class Writer {
 public:
  explicit Writer(JsonLayout layout) : readable_(layout == JsonLayout::kReadable) {}

  /// Opens an object or array; one that spans lines puts each of its members on a line of its own.
  void open(char bracket, bool spans_lines = false) {
    out_ += bracket;
    spans_.push_back(readable_ && spans_lines);
    first_ = true;
  }
  void close(char bracket) {
    const bool spanned = spans_.back();
    spans_.pop_back();
    if (spanned) new_line();
    out_ += bracket;
    first_ = false;
  }

  /// Starts the next item of an array.
  Writer& item() {
    if (!first_) out_ += spans_.back() || !readable_ ? "," : ", ";
    if (spans_.back()) new_line();
    first_ = false;
    return *this;
  }
  /// Starts the next member of an object.
  Writer& key(std::string_view name) {
    item().out_ += json_string(name);
    out_ += readable_ ? ": " : ":";
    return *this;
  }
  void raw(std::string_view text) { out_ += text; }
  void string(std::string_view text) { out_ += json_string(text); }
  void real(double x) { out_ += json_number(x); }
  void rational(const Rational& x) { string(to_text(x)); }

  std::string take() && { return std::move(out_); }

 private:
  void new_line() {
    out_ += '\n';
    out_.append(2 * spans_.size(), ' ');
  }

  std::string out_;
  std::vector<bool> spans_;
  bool readable_;
  bool first_ = true;
};

void write_points(Writer& w, const Points<double>& points) {
  w.open('[', true);
  for (const Vec3<double>& p : points) {
    w.item().open('[');
    for (int k = 0; k < 3; ++k) w.item().real(p[k]);
    w.close(']');
  }
  w.close(']');
}

void write_patch(Writer& w, const MovingPatch<double>& patch) {
  const Shape& shape = patch.shape;
  w.open('{', true);
  w.key("shape").string(name_of(shape.kind));
  if (shape.kind == ShapeKind::kTensor) {
    w.key("degree").raw(fmt::format("[{},{}]", shape.n, shape.m));
  } else if (shape.kind != ShapeKind::kPoint) {
    w.key("degree").raw(fmt::format("{}", shape.n));
  }
  write_points(w.key("positions"), patch.positions);
  write_points(w.key("velocities"), patch.velocities);
  w.close('}');
}

void write_witness(Writer& w, const Witness& witness) {
  w.open('{');
  w.key("t").rational(witness.t);
  w.key("uv").open('[');
  for (const Uv<Rational>& uv : witness.uv) {
    w.item().open('[');
    for (const Rational& x : uv) w.item().rational(x);
    w.close(']');
  }
  w.close(']');
  w.close('}');
}

template <class Items, class Write>
void write_array(Writer& w, const Items& items, const Write& write) {
  w.open('[');
  for (const auto& item : items) write(w.item(), item);
  w.close(']');
}

void write_contact_box(Writer& w, const ContactBox& box) {
  const auto real = [](Writer& to, double x) { to.real(x); };
  const auto integer = [](Writer& to, int x) { to.raw(fmt::format("{}", x)); };
  w.open('{', true);
  write_array(w.key("centre"), box.centre, real);
  write_array(w.key("dependent"), box.dependent, integer);
  write_array(w.key("varied"), box.varied, integer);
  write_array(w.key("radius"), box.radius, real);
  write_array(w.key("inverse"), box.inverse,
              [&](Writer& to, const auto& row) { write_array(to, row, real); });
  w.close('}');
}

void write_contact_root(Writer& w, const ContactRoot& root) {
  w.open('{', true);
  write_array(w.key("polynomial"), root.polynomial,
              [](Writer& to, const Integer& c) { to.string(c.get_str()); });
  w.key("from").rational(root.from);
  w.key("by").rational(root.by);
  w.close('}');
}

void write_clearance(Writer& w, const Clearance& clearance) {
  w.open('{', true);
  w.key("kind").string(proof_word(clearance));
  w.key("until").rational(until_of(clearance));
  if (const auto* plane = std::get_if<MovingPlane>(&clearance)) {
    write_array(w.key("normal"), plane->normal,
                [](Writer& to, const Rational& x) { to.rational(x); });
    w.key("offset").rational(plane->offset);
  } else if (const auto* linear = std::get_if<LinearClearance>(&clearance)) {
    w.key("closed").raw(linear->closed ? "true" : "false");
  } else {
    const TreeRef& tree = std::get<MissTree>(clearance).tree;
    w.key("tree").open('{');
    w.key("offset").raw(fmt::format("{}", tree.offset));
    w.key("length").raw(fmt::format("{}", tree.length));
    w.key("xxh3").string(tree.xxh3);
    w.close('}');
  }
  w.close('}');
}

void write_truth(Writer& w, const Truth& truth) {
  w.open('{', true);
  w.key("collides").raw(!truth.collides ? "null" : *truth.collides ? "true" : "false");
  if (truth.witness) write_witness(w.key("witness"), *truth.witness);
  if (truth.clear_until) w.key("clear_until").rational(*truth.clear_until);
  if (truth.proof) w.key("proof").string(*truth.proof);
  if (truth.contact_box || truth.contact_root || truth.clearance) {
    w.key("certificate").open('{', true);
    if (truth.contact_box) write_contact_box(w.key("contact"), *truth.contact_box);
    if (truth.contact_root) write_contact_root(w.key("root"), *truth.contact_root);
    if (truth.clearance) write_clearance(w.key("clear"), *truth.clearance);
    w.close('}');
  }
  w.close('}');
}

void write_origin(Writer& w, const Origin& origin) {
  const auto text = [&](const char* key, const std::string& value) {
    if (!value.empty()) w.key(key).string(value);
  };
  const auto number = [&](const char* key, const std::optional<std::uint64_t>& value) {
    if (value) w.key(key).raw(fmt::format("{}", *value));
  };
  w.open('{', true);
  text("name", origin.name);
  text("contact", origin.contact);
  text("kind", origin.kind);
  text("generator", origin.generator);
  number("seed", origin.seed);
  number("index", origin.index);
  text("ccdfuzz", origin.ccdfuzz);
  text("note", origin.note);
  for (const auto& [key, value] : origin.more) w.key(key).raw(value);
  w.close('}');
}

}  // namespace

std::string to_json(const Case& value, JsonLayout layout) {
  Writer w(layout);
  w.open('{', true);
  w.key("format").string("ccdfuzz-case");
  w.key("version").raw("1");
  w.key("patches").open('[', true);
  for (const MovingPatch<double>& patch : value.query.patches) write_patch(w.item(), patch);
  w.close(']');
  w.key("t_max").real(value.query.t_max);
  if (value.truth != Truth{}) write_truth(w.key("truth"), value.truth);
  if (value.origin != Origin{}) write_origin(w.key("origin"), value.origin);
  if (!value.expect.empty()) {
    w.key("expect").open('{', true);
    for (const auto& [method, outcome] : value.expect) w.key(method).string(name_of(outcome));
    w.close('}');
  }
  w.close('}');
  return std::move(w).take();
}

}  // namespace ccdfuzz
