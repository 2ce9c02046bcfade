#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "ccd/search.hpp"
#include "ccd/witness_trace/trace.hpp"
#include "query/answer.hpp"
#include "query/case.hpp"
#include "query/judge.hpp"

namespace ccdfuzz {

/// What a method did in place of answering: an error with a name by which like ones are told from
/// others ("hang", "crash SIGSEGV").
class MethodFault : public std::runtime_error {
 public:
  MethodFault(std::string name, const std::string& note)
      : std::runtime_error(note), name_(std::move(name)) {}
  const std::string& name() const { return name_; }

 private:
  std::string name_;
};

/// A CCD method: built in, or a user's. One object serves one thread at a time and keeps its
/// buffers between queries, but no other state: the same query gives the same answer.
class Method {
 public:
  virtual ~Method() = default;
  /// Errors: throws MethodFault, or any other exception, where it fails to answer.
  virtual Answer answer(const Query& query, const SearchOptions& options) = 0;
  /// What the answer given last claims; how it is to be judged.
  virtual AnswerTerms terms() const { return {}; }
  /// What it claims besides and was just seen not to keep; absent: nothing.
  virtual std::optional<MethodFault> broken_claim() const { return std::nullopt; }
  /// True iff it answers in another process, so that CPU time of this one says nothing of it.
  virtual bool runs_elsewhere() const { return false; }
};

/// Follows a witness through the inclusion tests of a method, the code that its queries run. One
/// object serves one thread and keeps its buffers: once warm, a trace allocates nothing.
class Tracer {
 public:
  virtual ~Tracer() = default;
  /// Requires a valid query and a witness of it (check_witness). The result is valid until the next
  /// call.
  virtual const Trace& trace(const Query& query, const Witness& witness,
                             const TraceOptions& options) = 0;
};

/// What a family of methods is, for `ccdfuzz methods` and the judge.
struct MethodInfo {
  std::string spec;         ///< "tdibm-h:F": what --methods takes
  std::string source;       ///< where it is described
  std::string description;  ///< one line
  bool claims_no_false_negative = false;
};

/// Behind the spec of a method of the paper: its form without any optimisation, for comparison.
inline constexpr std::string_view kUnoptimised = "@unoptimised";

/// Every registered family, in the order of the tables, without plug-ins.
const std::vector<MethodInfo>& registered_methods();

/// The family a concrete spec belongs to ("tdibm-h:1e-12" → "tdibm-h:F").
Result<MethodInfo> method_info(const std::string& spec);

/// A fresh method for a concrete spec, a plug-in's too (plugin_spec.hpp). Errors: an unknown name
/// or a bad parameter, naming it.
Result<std::unique_ptr<Method>> make_method(const std::string& spec);

/// A fresh tracer of the method of a concrete spec. Errors: as make_method.
Result<std::unique_ptr<Tracer>> make_tracer(const std::string& spec);

/// Splits "a,b,c" and checks each spec.
Result<std::vector<std::string>> parse_method_list(const std::string& list);

}  // namespace ccdfuzz
