#pragma once

#include <memory>
#include <string>

#include "method/method.hpp"
#include "method/plugin/line_protocol.hpp"

namespace ccdfuzz {

/// A plug-in as the host knows it.
struct KnownPlugin {
  PluginSpec spec;
  PluginDescription description;  ///< what it says of itself
  ChildProgram program;
  /// A built-in method in a child (served_method). It is asked on however often it hangs. What only
  /// a child does that has answered before is not its fault.
  bool is_ours = false;
  std::string behind = {};  ///< the spec that its name stands for; empty where it has no name
};

/// The plug-in of a spec or name that admit_plugin or name_plugin has met. Starts nothing, so that
/// any text may be looked up. Errors: it has not been met.
Result<std::shared_ptr<const KnownPlugin>> know_plugin(const std::string& spec);

/// What the registry says of it.
MethodInfo plugin_info(const KnownPlugin& plugin);

/// The plug-in as a Method, in a worker process that starts with the first query, and anew after
/// each fault. A query of shapes that it does not accept is undecided. Every query is asked again
/// after another one, unless the spec says repeat=no: an answer that changes is the fault "two
/// answers". A description that changes when it is started again is the fault "description".
/// Where the plug-in claims a NaN policy, the query is asked between the two with a coordinate that
/// is not finite. An answer that does not fit is the broken claim "nan policy". answer() throws
/// MethodFault for whatever the plug-in does that it may not.
std::unique_ptr<Method> make_plugin_method(std::shared_ptr<const KnownPlugin> plugin);

}  // namespace ccdfuzz
