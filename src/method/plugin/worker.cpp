// ccdfuzz-plugin-worker MEGABYTES STARTER load LIBRARY: loads a plug-in and answers for it by the
// line protocol. ccdfuzz-plugin-worker MEGABYTES STARTER run PROGRAM ARGUMENTS...: becomes the
// program, which answers lines itself. Both with limited memory, unless MEGABYTES is 0. The process
// STARTER started this: it limits the time, and nothing stays when it is gone.
// It is built without sanitizers: it loads what users built.
#include <dlfcn.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/stopwatch.hpp"
#include "bezier/shape.hpp"
#include "io/descriptor.hpp"
#include "io/process_limits.hpp"
#include "io/supervise.hpp"
#include "method/plugin/feature_claims.hpp"

namespace {

using Json = nlohmann::json;

int reply_descriptor = STDOUT_FILENO;

void send(const std::string& line) {
  if (ccdfuzz::write_all(reply_descriptor, line) != 0) std::_Exit(1);
}

void send(const Json& reply) {
  send(reply.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

/// Says what is wrong and ends: nothing that the plug-in may have damaged is used again.
[[noreturn]] void end_with(const char* field, const std::string& name, const std::string& note) {
  send(Json{{field, name}, {"message", note}});
  std::_Exit(0);
}
[[noreturn]] void fault(const std::string& name, const std::string& note) {
  end_with("fault", name, note);
}

[[noreturn]] void out_of_memory() {
  send(std::string("{\"fault\":\"memory\",\"message\":\"no more memory within its limit\"}\n"));
  std::_Exit(0);
}

/// Calls a function of the plug-in. An exception ends this with its text after `before`.
template <class Call>
auto guarded(const Call& call, const char* field = "fault", const char* name = "exception",
             const std::string& before = "") {
  try {
    return call();
  } catch (const std::bad_alloc&) {
    out_of_memory();
  } catch (const std::exception& error) {
    end_with(field, name, before + error.what());
  } catch (...) {
    end_with(field, name, before + "something that is no std::exception");
  }
}

/// A struct that the plug-in writes to, with bytes behind it that it must not touch.
template <class T>
struct Fenced {
  T value;
  std::array<unsigned char, 256> fence;

  Fenced() : value() { fence.fill(0xA5); }

  /// least: the bytes of its shortest form, which an older plug-in knows.
  void check(const char* what, std::size_t least = sizeof(T)) const {
    for (const unsigned char byte : fence) {
      if (byte != 0xA5) fault("sizes", std::string("wrote past the end of its ") + what);
    }
    if (value.size < least || value.size > sizeof(T)) {
      fault("sizes", std::string("says that its ") + what + " has " + std::to_string(value.size) +
                         " bytes, not " + std::to_string(sizeof(T)));
    }
  }
};

constexpr auto kShapeNames = names_of(ccdfuzz::ShapeKind{});
static_assert(CCDFUZZ_HULL == static_cast<int>(ccdfuzz::ShapeKind::kHull));

constexpr std::uint64_t all_claims() {
  std::uint64_t sum = CCDFUZZ_CONSERVATIVE + CCDFUZZ_CLOSED_T_MAX + CCDFUZZ_CONTACT_AT_ZERO +
                      CCDFUZZ_BINARY32 + CCDFUZZ_ORDINARY + CCDFUZZ_PLANE + CCDFUZZ_SMALL_SPINS +
                      CCDFUZZ_SHORT_SPINS + CCDFUZZ_INITIAL_OVERLAP;
  for (const ccdfuzz::FeatureClaim& claim : ccdfuzz::kFeatureClaims) sum += claim.bit;
  return sum;
}
static_assert(std::has_single_bit(all_claims() + 1), "claims have the lowest bits, one each");

/// The name of a number that a description holds.
std::string_view named(const auto& names, std::uint32_t number, const std::string& what) {
  if (number < names.size()) return names[number];
  fault("sizes", "describes a " + what + " " + std::to_string(number) + " that there is not");
}

Json real(double x) {
  if (std::isnan(x)) return "nan";
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  return x;
}

Json real_or_null(double x) {
  return std::isnan(x) ? Json() : real(x);
}

/// The loaded library.
class Plugin {
 public:
  Plugin(const char* path, const std::string& options) {
    void* const library = ::dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
      end_with("refused", "library", std::string(::dlerror()) + "; a program is plugin-exec:PATH");
    }
    const auto get =
        reinterpret_cast<decltype(&ccdfuzz_plugin_get)>(::dlsym(library, "ccdfuzz_plugin_get"));
    if (get == nullptr) {
      end_with("refused", "library", std::string(path) + " exports no ccdfuzz_plugin_get");
    }
    table_ = guarded(get);
    if (table_ == nullptr) fault("sizes", "ccdfuzz_plugin_get returned a null pointer");
    if (table_->abi != CCDFUZZ_PLUGIN_ABI) {
      end_with("refused", "version",
               std::string(path) + " was built for version " + std::to_string(table_->abi) +
                   " of the plug-in interface, and this is version " +
                   std::to_string(CCDFUZZ_PLUGIN_ABI));
    }
    constexpr std::uint32_t kMostBytes = 4096;
    if (table_->size < sizeof *table_ || table_->size > kMostBytes) {
      fault("sizes", "says that its ccdfuzz_plugin has " + std::to_string(table_->size) +
                         " bytes, not " + std::to_string(sizeof *table_));
    }
    const std::string refusal = std::string(path) + " refuses the options \"" + options + "\"";
    if (guarded([&] { return table_->create(options.c_str(), &state_); }, "refused", "options",
                refusal + ": ") != 0) {
      end_with("refused", "options", refusal);
    }
  }

  Json describe() {
    Fenced<ccdfuzz_description> out;
    ccdfuzz_description& d = out.value;
    d.size = sizeof d;
    if (guarded([&] { return table_->describe(state_, &d); }) != 0) {
      fault("error", "could not describe itself");
    }
    out.check("description", offsetof(ccdfuzz_description, promise));
    constexpr std::uint64_t kMostPairs = 1024;
    if (d.pair_count > kMostPairs || (d.pair_count > 0 && d.pairs == nullptr)) {
      fault("sizes", "describes " + std::to_string(d.pair_count) + " pairs of shapes");
    }
    Json accepts = Json::array();
    for (std::uint64_t i = 0; i < d.pair_count; ++i) {
      Json pair = Json::array();
      for (int side = 0; side < 2; ++side) {
        pair.push_back({{"shape", named(kShapeNames, d.pairs[i].shapes[side], "shape")},
                        {"max_degree", d.pairs[i].max_degrees[side]}});
      }
      accepts.push_back(pair);
    }
    if (d.body_count > kMostPairs || (d.body_count > 0 && d.bodies == nullptr)) {
      fault("sizes", "describes " + std::to_string(d.body_count) + " kinds of bodies");
    }
    constexpr std::array kRadii = {"any", "zero", "positive"};
    Json bodies = Json::array();
    for (std::uint64_t i = 0; i < d.body_count; ++i) {
      const ccdfuzz_body_kind& kind = d.bodies[i];
      bodies.push_back({{"least_points", kind.least_points},
                        {"most_points", kind.most_points},
                        {"radius", named(kRadii, kind.radius, "radius")}});
    }
    constexpr std::array kKinds = {"time", "time_relative", "space", "space_relative"};
    constexpr std::array kPolicies = {"undefined", "error", "inconclusive", "hit", "refused"};
    Json description = {{"protocol", 1},
                        {"name", d.name == nullptr ? "" : d.name},
                        {"version", d.version == nullptr ? "" : d.version},
                        {"accepts", accepts},
                        {"conservative", (d.claims & CCDFUZZ_CONSERVATIVE) != 0},
                        {"closed_t_max", (d.claims & CCDFUZZ_CLOSED_T_MAX) != 0},
                        {"contact_at_zero", (d.claims & CCDFUZZ_CONTACT_AT_ZERO) != 0},
                        {"tolerance_kind", named(kKinds, d.tolerance_kind, "tolerance_kind")},
                        {"tolerance", real(d.tolerance)},
                        {"minimum_separation", real(d.minimum_separation)},
                        {"nan_policy", named(kPolicies, d.nan_policy, "nan_policy")},
                        {"promise", d.promise == nullptr ? "" : d.promise},
                        {"numbers", (d.claims & CCDFUZZ_BINARY32) != 0 ? "binary32" : "binary64"},
                        {"ordinary", (d.claims & CCDFUZZ_ORDINARY) != 0},
                        {"initial_overlap", (d.claims & CCDFUZZ_INITIAL_OVERLAP) != 0},
                        {"plane", (d.claims & CCDFUZZ_PLANE) != 0},
                        {"small_spins", (d.claims & CCDFUZZ_SMALL_SPINS) != 0},
                        {"short_spins", (d.claims & CCDFUZZ_SHORT_SPINS) != 0},
                        {"within", d.within},
                        {"bodies", bodies}};
    for (const ccdfuzz::FeatureClaim& claim : ccdfuzz::kFeatureClaims) {
      description[claim.field] = (d.claims & claim.bit) != 0;
    }
    return description;
  }

  Json answer(const Json& asked) {
    for (size_t side = 0; side < 2; ++side) read_patch(asked.at("patches").at(side), side);
    ccdfuzz_query query{};
    query.size = sizeof query;
    query.patches[0] = &patches_[0];
    query.patches[1] = &patches_[1];
    query.t_max = asked.at("t_max").get<double>();
    query.precision = asked.at("precision").get<double>();
    query.max_iterations = asked.at("max_iterations").get<std::uint64_t>();
    query.max_seconds = asked.at("max_seconds").get<double>();
    query.separation = asked.value("separation", 0.0);
    const std::string before = given_bytes();
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    Fenced<ccdfuzz_answer> out;
    ccdfuzz_answer& a = out.value;
    a.size = sizeof a;
    a.toi_lower = a.toi_upper = a.tolerance = kNaN;
    for (auto& uv : a.uv) uv[0] = uv[1] = kNaN;

    const ccdfuzz::Stopwatch watch;
    const int status = guarded([&] { return table_->answer(state_, &query, &a); });
    const double seconds = watch.seconds();
    out.check("answer");
    if (given_bytes() != before) fault("sizes", "wrote into the query");
    a.message[sizeof a.message - 1] = '\0';
    if (status != 0 || a.verdict == CCDFUZZ_ERROR) {
      return {{"verdict", "error"},
              {"message", a.message[0] != '\0' ? std::string(a.message)
                                               : "returned " + std::to_string(status)}};
    }
    constexpr std::array kVerdicts = {"", "hit", "miss", "inconclusive", "error", "refused"};
    if (a.verdict == 0) fault("unanswered", "returned without a verdict");
    if (a.verdict >= kVerdicts.size()) {
      fault("garbage", "gave the verdict " + std::to_string(a.verdict) + ", which there is not");
    }
    Json reply = {{"verdict", kVerdicts[a.verdict]},
                  {"iterations", a.iterations},
                  {"tolerance", real_or_null(a.tolerance)},
                  {"seconds", seconds},
                  {"message", a.message}};
    if (a.verdict == CCDFUZZ_HIT) {
      reply["toi"] = {real(a.toi_lower), real_or_null(a.toi_upper)};
      for (size_t side = 0; side < 2; ++side) {
        const auto& [u, v] = a.uv[side];
        const bool has_v = patches_[side].shape > CCDFUZZ_CURVE;
        // Who knows neither leaves both NaN.
        const bool is_half = std::isnan(u) != std::isnan(v) && (std::isnan(u) || has_v);
        reply["uv"].push_back(is_half ? Json{real(u), real(v)}
                                      : Json{real_or_null(u), real_or_null(v)});
      }
    }
    return reply;
  }

 private:
  using Coordinates = std::vector<std::array<double, 3>>;

  /// The value of a number, or of "nan", "inf" or "-inf".
  static double any_real(const Json& x) {
    return x.is_string() ? std::strtod(x.get_ref<const std::string&>().c_str(), nullptr)
                         : x.get<double>();
  }

  static std::vector<double> any_reals(const Json& numbers) {
    std::vector<double> out;
    for (const Json& x : numbers) out.push_back(any_real(x));
    return out;
  }

  static Coordinates coordinates(const Json& points) {
    Coordinates out(points.size());
    for (size_t i = 0; i < out.size(); ++i)
      for (size_t k = 0; k < 3; ++k) out[i][k] = any_real(points[i][k]);
    return out;
  }

  void read_patch(const Json& patch, size_t side) {
    ccdfuzz_patch& out = patches_[side];
    out = {};
    out.size = sizeof out;
    out.shape = static_cast<std::uint32_t>(
        std::ranges::find(kShapeNames, patch.at("shape").get_ref<const std::string&>()) -
        kShapeNames.begin());
    if (patch.contains("degree")) {
      const Json& degree = patch.at("degree");
      out.degree_u =
          degree.is_array() ? degree.at(0).get<std::uint32_t>() : degree.get<std::uint32_t>();
      if (degree.is_array()) out.degree_v = degree.at(1).get<std::uint32_t>();
    }
    Coordinates& positions = points_[2 * side];
    Coordinates& moves = points_[2 * side + 1];
    const bool has_ends = patch.contains("ends");
    positions = coordinates(patch.at("positions"));
    moves = coordinates(patch.at(has_ends ? "ends" : "velocities"));
    out.count = positions.size();
    out.radius = patch.contains("radius") ? any_real(patch.at("radius")) : 0;
    out.positions = reinterpret_cast<const double(*)[3]>(positions.data());
    (has_ends ? out.ends : out.velocities) = reinterpret_cast<const double(*)[3]>(moves.data());
    weights_[side] = patch.value("weights", std::vector<double>());
    if (!weights_[side].empty()) out.weights = weights_[side].data();
    const bool spins = patch.contains("spin");
    if (spins || patch.contains("turn")) {
      const Json& turn = patch.at(spins ? "spin" : "turn");
      turns_[2 * side] = any_reals(turn.at(spins ? "velocity" : "from"));
      out.turn_count = turns_[2 * side].size();
      out.turn_from = turns_[2 * side].data();
      if (!spins) {
        turns_[2 * side + 1] = any_reals(turn.at("to"));
        out.turn_to = turns_[2 * side + 1].data();
      }
      for (size_t k = 0; k < 3; ++k) out.turn_centre[k] = any_real(turn.at("centre")[k]);
    }
    faces_[side] = patch.value("faces", std::vector<std::array<std::uint32_t, 3>>());
    out.face_count = faces_[side].size();
    out.faces = reinterpret_cast<const std::uint32_t(*)[3]>(faces_[side].data());
    out.one_sided = patch.value("sides", 2) == 1 ? 1 : 0;
    sizes_[side].clear();
    vertices_[side].clear();
    for (const auto& loop : patch.value("trim", std::vector<std::vector<Vertex>>())) {
      sizes_[side].push_back(loop.size());
      vertices_[side].insert(vertices_[side].end(), loop.begin(), loop.end());
    }
    if (sizes_[side].empty()) return;
    out.loop_count = sizes_[side].size();
    out.loop_sizes = sizes_[side].data();
    out.loop_vertices = reinterpret_cast<const double(*)[2]>(vertices_[side].data());
  }

  /// The bytes of all lists that the plug-in reads; NaN is not equal to itself.
  std::string given_bytes() const {
    std::string bytes;
    const auto add = [&](const auto& lists) {
      for (const auto& list : lists) {
        bytes.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof list[0]);
      }
    };
    add(points_), add(weights_), add(turns_), add(faces_), add(vertices_), add(sizes_);
    return bytes;
  }

  const ccdfuzz_plugin* table_ = nullptr;
  void* state_ = nullptr;
  std::array<ccdfuzz_patch, 2> patches_{};
  std::array<Coordinates, 4> points_;
  std::array<std::vector<double>, 2> weights_;
  std::array<std::vector<double>, 4> turns_;  ///< from and to of each side, or a spin
  std::array<std::vector<std::array<std::uint32_t, 3>>, 2> faces_;
  using Vertex = std::array<double, 2>;
  std::array<std::vector<Vertex>, 2> vertices_;  ///< those of all loops
  std::array<std::vector<std::uint64_t>, 2> sizes_;
};

/// The questions come on a descriptor that the plug-in does not know; what it prints goes to
/// stderr.
[[noreturn]] void serve(const char* path) {
  std::set_new_handler(out_of_memory);
  std::unique_ptr<Plugin> plugin;
  ccdfuzz::answer_lines([&](std::string_view line, int replies) {
    reply_descriptor = replies;
    const Json asked = Json::parse(line);
    Json reply;
    if (asked.at("ask") == "describe") {
      plugin = std::make_unique<Plugin>(path, asked.at("options").get<std::string>());
      reply = plugin->describe();
    } else {
      reply = plugin->answer(asked);
      reply["id"] = asked.at("id");
    }
    std::fflush(nullptr);
    send(reply);
  });
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    std::fputs("ccdfuzz-plugin-worker is started by ccdfuzz\n", stderr);
    return 2;
  }
  ccdfuzz::limit_answering_process(std::strtoull(argv[1], nullptr, 10) << 20);
  ccdfuzz::continue_in_supervised_child(static_cast<pid_t>(std::strtol(argv[2], nullptr, 10)));
  if (std::strcmp(argv[3], "load") == 0) serve(argv[4]);
  ::execv(argv[4], argv + 4);
  end_with("refused", "program", std::string("cannot run ") + argv[4] + ": " + strerror(errno));
}
