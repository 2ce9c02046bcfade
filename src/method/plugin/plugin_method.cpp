#include "method/plugin/plugin_method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <mutex>
#include <sstream>
#include <utility>

#include "base/no_process.hpp"
#include "base/stopwatch.hpp"
#include "io/hash_name.hpp"
#include "method/plugin/feature_claims.hpp"
#include "method/plugin/plugin_terms.hpp"
#include "method/plugin/probes.hpp"
#include "method/taken_query.hpp"

namespace ccdfuzz {

namespace {

/// A plug-in is asked no more after this many consecutive queries in which it hangs, also where
/// they are repeated or not finite. So it cannot take all of the time of a run by cases.
constexpr int kMostHangs = 8;

/// "; tolerance 1e-06 (space), NaN: error", or nothing if it claims nothing out of the ordinary.
std::string claims_text(const PluginDescription& d) {
  std::vector<std::string> claims;
  if (!d.closed_t_max) claims.emplace_back("open t_max");
  if (!d.contact_at_zero) claims.emplace_back("no contact at 0");
  if (d.tolerance > 0) {
    claims.push_back(fmt::format("tolerance {} ({})", d.tolerance, name_of(d.tolerance_kind)));
  }
  if (d.minimum_separation > 0) {
    claims.push_back(fmt::format("minimum separation {}", d.minimum_separation));
  }
  if (d.nan_policy != NanPolicy::kUndefined) {
    claims.push_back(fmt::format("NaN: {}", name_of(d.nan_policy)));
  }
  if (const std::string domain = d.domain.text(); !domain.empty()) claims.push_back(domain);
  if (!d.promise.empty()) claims.push_back(fmt::format("promises: {}", d.promise));
  return claims.empty() ? "" : fmt::format("; {}", fmt::join(claims, ", "));
}

std::string text_of(const Answer& answer) {
  const std::string word(word_of(answer.verdict));
  return answer.verdict == Verdict::kHit ? fmt::format("{} at {}", word, *answer.toi) : word;
}

/// The note of a fault when a plug-in is asked what it is.
std::string when_described(const Fault& fault) {
  return "when asked what it is: " + fault.note;
}

/// What a plug-in says of itself, or does in place of that.
tl::expected<PluginDescription, Fault> described_by(Child& worker, const PluginSpec& spec) {
  constexpr double kSecondsToStart = 10;  // on a busy machine; what hangs there ends the command
  return worker.ask(describe_request(spec.options), kSecondsToStart).and_then(read_description);
}

class PluginMethod : public Method {
 public:
  explicit PluginMethod(std::shared_ptr<const KnownPlugin> plugin)
      : plugin_(std::move(plugin)), worker_(plugin_->program) {}

  Answered answer(const Query& query, const SearchOptions& options) override {
    broken_claim_.reset();
    if (!is_question(query, options)) return {refusal(query, options)};
    if (hangs_ >= kMostHangs && !plugin_->is_ours) {
      return no_answer(Verdict::kUndecided,
                       fmt::format("is asked no more: hung {} times one after the other", hangs_));
    }
    if (options.is_stopped()) throw NoProcess("interrupted");
    worker_.heed(options.stop);
    try {
      return answer_or_throw(query, options);
    } catch (const MethodFault& fault) {
      hangs_ = fault.name() == "hang" ? hangs_ + 1 : 0;
      throw;
    }
  }

  bool runs_elsewhere() const override { return true; }
  const Domain* domain() const override { return &plugin_->description.domain; }

 private:
  Answered answer_or_throw(const Query& query, const SearchOptions& options) {
    const std::optional<bool> swapped = plugin_->description.domain.order_of(query);
    if (!swapped) {
      return no_answer(Verdict::kRefused,
                       fmt::format("does not take {} and {}", to_text(query.patches[0].shape),
                                   to_text(query.patches[1].shape)));
    }
    const TakenQuery taken(query, plugin_->is_ours ? kAllFeatures : plugin_->description.features);
    if (taken.query() == nullptr) {
      return no_answer(Verdict::kRefused, taken.why());
    }
    Query asked = *taken.query();
    if (*swapped) std::swap(asked.patches[0], asked.patches[1]);
    PluginAnswer given = ask_unless_killed(asked, options);
    hangs_ = 0;
    if (*swapped) std::swap(given.answer.uv[0], given.answer.uv[1]);
    const AnswerTerms terms = terms_of(plugin_->description, given, query);
    if (auto broken = broken_tolerance(plugin_->description, given)) {
      broken_claim_ = std::move(broken);
    }
    return {std::move(given.answer), terms, std::exchange(broken_claim_, {})};
  }

  [[noreturn]] void throw_fault(const Fault& fault) {
    worker_.kill();
    if (fault.name == kAway || fault.name == "interrupted") {
      throw NoProcess(fmt::format("\"{}\": {}", plugin_->spec.text, fault.note));
    }
    throw MethodFault(fault.name, fault.note);
  }

  /// Whoever kills a worker without our doing (the system, short of memory) does so once.
  PluginAnswer ask_unless_killed(const Query& query, const SearchOptions& options) {
    const bool is_used = plugin_->is_ours && worker_.has_answered();
    try {
      return ask_and_repeat(query, options);
    } catch (const MethodFault& fault) {
      if (fault.name() != "crash SIGKILL" && !is_used) throw;
    }
    return ask_and_repeat(query, options);
  }

  /// Nothing more is asked of it once its time is over, or who asks is interrupted.
  PluginAnswer ask_and_repeat(const Query& query, const SearchOptions& options) {
    const Stopwatch watch;
    const auto is_over = [&] {
      return watch.seconds() >= options.max_seconds || options.is_stopped();
    };
    PluginAnswer given = ask_once(query, options);
    // What it refuses it is not held to.
    if (given.answer.verdict == Verdict::kRefused) return given;
    if (!plugin_->spec.repeats || is_over()) return given;
    ask_decoy(query, options);
    if (is_over()) return given;
    // Who says one thing and another by turns says the same every other time. Asking about NaN is
    // another time, too.
    const bool asks_nan = plugin_->description.nan_policy != NanPolicy::kUndefined;
    if (!has_repeated_ && !asks_nan) ask_decoy(query, options);
    if (is_over()) return given;
    check_nan_policy(query, options);
    if (is_over()) return given;
    const PluginAnswer again = ask_once(query, options);
    has_repeated_ = true;
    if (!again.agrees_with(given)) {
      const std::string first = text_of(given.answer), then = text_of(again.answer);
      throw_fault(
          {"two answers", fmt::format("answers differ from one ask to the next: {}, then {}{}",
                                      first, then, first == then ? " with another uv" : "")});
    }
    return given;
  }

  /// The result of work(). What its process does in place of answering is a fault like any, and
  /// says what was asked.
  static auto asking(const std::string& what, const auto& work) {
    try {
      return work();
    } catch (const MethodFault& fault) {
      throw MethodFault(fault.name(), fmt::format("asked {}: {}", what, fault.what()));
    }
  }

  void ask_decoy(const Query& query, const SearchOptions& options) {
    asking("the query turned by 180° about the z axis",
           [&] { return ask_once(decoy_query(query, plugin_->description.domain), options); });
  }

  PluginAnswer ask_once(const Query& query, const SearchOptions& options) {
    auto given = ask_for_any(query, options);
    if (!given) throw_fault(given.error());
    return *std::move(given);
  }

  /// An answer, or what is none. Throws what its process does in place of answering.
  tl::expected<PluginAnswer, Fault> ask_for_any(const Query& query, const SearchOptions& options) {
    if (!worker_.runs()) {
      const auto described = described_by(worker_, plugin_->spec);
      if (!described) throw_fault({described.error().name, when_described(described.error())});
      has_repeated_ = false;
      if (!plugin_->is_ours) check_description(described->line);
    }
    SearchOptions told = options;
    told.max_seconds = std::min(told.max_seconds, plugin_->spec.seconds);
    const std::string request = query_request(query, told, ++last_id_, plugin_->is_ours);
    const Stopwatch watch;
    const auto reply = worker_.ask(request);
    const double elapsed = watch.seconds();
    if (!reply) throw_fault(reply.error());
    auto given = read_answer(*reply, last_id_, query.t_max);
    if (given && !given->has_seconds) given->answer.seconds = elapsed;
    return given;
  }

  /// It is judged by what it said first.
  void check_description(const std::string& line) {
    const std::string changes = changes_between(plugin_->description.line, line);
    if (changes.empty()) return;
    throw_fault({"description", "describes itself otherwise when it is started again: " + changes});
  }

  /// Asks the query with one coordinate that is not finite, if the plug-in claims to know what to
  /// say then.
  void check_nan_policy(const Query& query, const SearchOptions& options) {
    const NanPolicy policy = plugin_->description.nan_policy;
    if (policy == NanPolicy::kUndefined) return;
    const PoisonedQuery poisoned = poisoned_query(query);
    const auto given =
        asking("with " + poisoned.where, [&] { return ask_for_any(poisoned.query, options); });
    if (keeps(policy, given)) return;
    const std::string said = given ? text_of(given->answer) : given.error().note;
    broken_claim_.emplace("nan policy",
                          fmt::format("claims \"{}\" of what is not finite; asked with {}: {}",
                                      name_of(policy), poisoned.where, said));
  }

  static bool keeps(NanPolicy policy, const tl::expected<PluginAnswer, Fault>& given) {
    if (!given) return policy == NanPolicy::kError && given.error().name == "error";
    const Answer& answer = given->answer;
    return name_of(policy) == word_of(answer.verdict) &&
           (answer.verdict != Verdict::kHit || *answer.toi == 0);
  }

  std::shared_ptr<const KnownPlugin> plugin_;
  Child worker_;
  std::optional<MethodFault> broken_claim_;  ///< by the answer to this query
  std::uint64_t last_id_ = 0;
  int hangs_ = 0;
  bool has_repeated_ = false;  ///< this process has been asked a query again
};

Result<std::shared_ptr<const KnownPlugin>> start_and_ask(const std::string& text) {
  CCDFUZZ_TRY(PluginSpec spec, parse_plugin_spec(text));
  if (const auto worker = find_worker_program(); !worker) {
    return input_error("method", worker.error().message());
  }
  const ChildProgram program = {{spec.is_program ? "run" : "load", spec.path},
                                {.seconds = spec.seconds, .megabytes = spec.megabytes}};
  Child worker(program);
  auto description = described_by(worker, spec);
  if (!description) {
    const auto& [name, note] = description.error();
    const bool refuses = name == kRefusal || name == kAway;
    const std::string why = !refuses       ? name + " " + when_described(description.error())
                            : note.empty() ? "refuses to start, and does not say why"
                                           : note;
    return input_error("method", "\"{}\": {}", text, why);
  }
  return std::make_shared<const KnownPlugin>(KnownPlugin{spec, *std::move(description), program});
}

/// Those that were met, by spec or name.
struct MetPlugins {
  std::mutex mutex;
  std::map<std::string, std::shared_ptr<const KnownPlugin>> by_spec;
} met;

}  // namespace

Result<void> admit_plugin(const std::string& spec) {
  const std::lock_guard lock(met.mutex);
  if (!names_plugin(spec) || met.by_spec.contains(spec)) return {};
  return start_and_ask(spec).map([&](const auto& started) { met.by_spec.emplace(spec, started); });
}

Result<void> name_plugin(const std::string& name, const std::string& spec) {
  if (!names_plugin(spec)) {
    return input_error("", "\"{}\" is not plugin:PATH or plugin-exec:PATH", spec);
  }
  const bool is_name = !name.empty() && std::ranges::all_of(name, [](unsigned char c) {
    return c < 128 && (std::isalnum(c) != 0 || c == '-');
  });
  if (!is_name) {
    return input_error("", "\"{}\" is not a name of letters, digits and '-'", name);
  }
  const std::string known_as = kPluginPrefix + name;
  const std::lock_guard lock(met.mutex);
  if (met.by_spec.contains(known_as)) {
    return input_error("", "\"{}\" stands for a plug-in already", known_as);
  }
  return start_and_ask(spec).map([&](const std::shared_ptr<const KnownPlugin>& started) {
    KnownPlugin named = *started;
    named.spec.text = known_as;
    named.behind = spec;
    met.by_spec.emplace(known_as, std::make_shared<const KnownPlugin>(std::move(named)));
  });
}

std::string spec_behind(const std::string& method) {
  const auto known = know_plugin(method);
  return known ? (*known)->behind : "";
}

std::string build_of(const std::string& method) {
  const auto known = know_plugin(method);
  if (!known) return "";
  const auto& [spec, description, program, is_ours, behind] = **known;
  std::ostringstream bytes;
  bytes << description.line << '\n' << spec.options << '\n' << spec.seconds << ' ';
  bytes << spec.megabytes << ' ' << spec.repeats << '\n' << std::ifstream(spec.path).rdbuf();
  return fmt::format("{}{}({})", description.version, description.version.empty() ? "" : " ",
                     hash_name(bytes.str()));
}

bool is_admitted(const std::string& spec) {
  return !names_plugin(spec) || know_plugin(spec).has_value();
}

Result<std::shared_ptr<const KnownPlugin>> know_plugin(const std::string& spec) {
  const std::lock_guard lock(met.mutex);
  if (const auto found = met.by_spec.find(spec); found != met.by_spec.end()) return found->second;
  return input_error("method", "\"{}\" is a plug-in that was not admitted", spec);
}

MethodInfo plugin_info(const KnownPlugin& plugin) {
  MethodInfo info;
  info.spec = plugin.spec.text;
  info.source = plugin.spec.path;
  const PluginDescription& d = plugin.description;
  info.description = d.name.empty() ? "says no name" : d.name;
  if (!d.version.empty()) info.description += " " + d.version;
  info.description += claims_text(d);
  info.claims_no_false_negative = d.conservative;
  info.features = d.features;
  info.version = d.version;
  info.domain = d.domain;
  return info;
}

std::unique_ptr<Method> make_plugin_method(std::shared_ptr<const KnownPlugin> plugin) {
  return std::make_unique<PluginMethod>(std::move(plugin));
}

}  // namespace ccdfuzz
