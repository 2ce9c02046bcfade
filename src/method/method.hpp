#pragma once

#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "case/answer.hpp"
#include "case/case.hpp"
#include "case/judge.hpp"
#include "case/search_options.hpp"
#include "method/domain.hpp"
#include "method/features.hpp"

namespace ccdfuzz {

struct Trace;
struct TraceOptions;

/// Thrown when a method fails to answer. name() is the kind of error ("hang", "crash SIGSEGV");
/// errors of one kind count as the same failure.
class MethodFault : public std::runtime_error {
 public:
  MethodFault(std::string name, const std::string& note)
      : std::runtime_error(note), name_(std::move(name)) {}
  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

/// An answer with what it claims, which says how it is to be judged.
struct Answered : Answer {
  AnswerTerms terms = {};
  /// The claim that the method has just broken, such as its NaN policy, if any.
  std::optional<MethodFault> broken_claim = std::nullopt;
};

/// No answer: a refusal, or undecided, and why.
inline Answered no_answer(Verdict verdict, std::string why) {
  Answered answer;
  answer.verdict = verdict;
  answer.note = std::move(why);
  return answer;
}

/// By its own terms.
inline Outcome judge(const CheckedCase& known, const Answered& answer) {
  return judge(known, answer, answer.terms);
}

/// A CCD method: built in, or a user's. One object serves one thread at a time and keeps its
/// buffers between queries, but no other state: the same query gives the same answer.
class Method {
 public:
  virtual ~Method() = default;
  /// Any bits may be asked about. What it does not take (is_taken, or a kind of query that it does
  /// not answer) it refuses, naming the reason. Errors: throws MethodFault, or any other exception,
  /// where it fails to answer; NoProcess is none of its failures.
  virtual Answered answer(const Query& query, const SearchOptions& options) = 0;
  /// True iff it answers in another process, so that this one's CPU time does not measure it.
  virtual bool runs_elsewhere() const { return false; }
  /// The queries that it promises to answer; null: all that it takes.
  virtual const Domain* domain() const { return nullptr; }

  /// Whether trace() can follow witnesses through it.
  virtual bool is_traceable() const { return false; }
  /// Follows a witness through its inclusion tests, the code that its queries run. Once warm, a
  /// trace allocates nothing but the witness's numbers. Requires is_traceable(), a valid query, a
  /// precision in (0, 1], and a witness of the query (check_witness). Throws InternalError where
  /// one of these is missing, the query is not taken (check_taken), or t* is outside [0, t_max].
  /// Whether the patches touch there is not checked. The result is valid until the next call.
  virtual const Trace& trace(const Query& query, const Witness& witness,
                             const TraceOptions& options);
};

/// The answer of a method, with the time that it took. A method that tells its own time, as
/// plug-ins do, is believed.
Answered timed_answer(Method& method, const Query& query, const SearchOptions& options);

/// A family of methods, for `ccdfuzz methods` and the judge.
struct MethodInfo {
  std::string spec;         ///< "tdibm-h:F": what --methods takes
  std::string source;       ///< where it is described
  std::string description;  ///< one line
  bool claims_no_false_negative = false;
  /// The switches that may follow a spec after '@', each once: "tdibm-e@unit-axes".
  std::vector<std::string> switches = {};
  Features features = {};
  /// Its claim holds of all queries that it takes. That of tdibm-e is false where products under-
  /// or overflow, that of tdibm-e-literal anywhere.
  bool claim_is_proven = false;
  Domain domain = {};
  std::string version = {};  ///< what a plug-in says of it; else empty
};

/// A switch of the methods of the paper: the form without any optimisation, for comparison.
inline constexpr const char* kUnoptimised = "@unoptimised";

/// A name behind '@' and what it means.
struct MethodSwitch {
  const char* name;
  const char* meaning;
};
/// Every switch that some method takes.
std::span<const MethodSwitch> method_switches();

/// Every registered family, in the order of the tables, without plug-ins.
const std::vector<MethodInfo>& registered_methods();

/// A spec that makes a registered method, with a parameter where it takes one.
std::string spec_of(const MethodInfo& info);
/// That of each but those named, and those without the mark. A list of those to ask would be
/// forgotten where a method is added; one of those that are not asked says why.
std::vector<std::string> every_method_but(const std::vector<std::string>& named = {},
                                          bool MethodInfo::*mark = nullptr);

/// Starts the plug-in of a spec (plugin_spec.hpp) and asks it what it is, once in the life of this
/// program. Built-in methods need no admission. Nothing else starts a plug-in, so that files are
/// data: a spec that a file holds is never to be admitted, only what the command line gives.
/// Errors: as parse_plugin_spec; no plug-in: not to be loaded or run, or of another version; a
/// fault when it is asked what it is.
Result<void> admit_plugin(const std::string& spec);

/// Lets "plugin:NAME" stand for the plug-in of a spec, which is admitted by that, so that files and
/// tables hold a name and no path. Errors: as admit_plugin; a name that is not of letters, digits
/// and '-', or that stands for another plug-in already.
Result<void> name_plugin(const std::string& name, const std::string& spec);

/// The spec of a plug-in that has a name (name_plugin); empty for any other method.
std::string spec_behind(const std::string& method);

/// What tells a plug-in from another that its name may stand for: its version and a hash. The hash
/// is of its claims, its options, those of the host, and its file. Empty for built-in methods.
std::string build_of(const std::string& method);

/// True iff make_method may make it: a built-in method, or a plug-in that was admitted.
bool is_admitted(const std::string& spec);

/// The family a concrete spec belongs to ("tdibm-h:1e-12" → "tdibm-h:F"). Errors: as make_method.
Result<MethodInfo> method_info(const std::string& spec);
/// True iff there is such a method, and it claims to have no false negative.
bool claims_no_false_negative(const std::string& spec);

/// Errors: the query has what the method does not take, or as method_info.
Result<void> check_taken(const std::string& spec, const Query& query);

/// A fresh method for a concrete spec, an admitted plug-in's too. Errors: an unknown name, a bad
/// parameter or a plug-in that was not admitted, naming it.
Result<std::unique_ptr<Method>> make_method(const std::string& spec);

/// The spec of a method, which the option `where` gives: checks it, and admits a plug-in.
Result<std::string> parse_method(const std::string& where, const std::string& spec);

}  // namespace ccdfuzz
