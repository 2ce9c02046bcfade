#pragma once

#include <string>

#include "base/result.hpp"

namespace ccdfuzz {

/// What a spec "plugin:PATH[:OPTION…]" or "plugin-exec:PATH[:OPTION…]" names: a shared library
/// with the interface of ccdfuzz_plugin.h, or a program that speaks the line protocol.
struct PluginSpec {
  std::string text;  ///< as the user wrote it
  bool is_program = false;
  std::string path;     ///< with at least one '/', so that no search path is looked at
  std::string options;  ///< what the plug-in gets: all options but those below, joined by ':'
  /// seconds=S: from a question to its answer; then the worker is killed, which is a finding.
  double seconds = 2;
  /// mb=N: address space of the worker.
  std::uint64_t megabytes = 1024;
  /// repeat=no: ask each query once, not again after another.
  bool repeats = true;
};

inline constexpr const char* kPluginPrefix = "plugin:";
inline constexpr const char* kPluginProgramPrefix = "plugin-exec:";

bool names_plugin(const std::string& spec);

/// True iff the spec can only be a name, as name_plugin gives one: no path without a '/' or '.' is
/// that of a library.
bool is_plugin_name(const std::string& spec);

/// Requires names_plugin(spec). Errors: no path, a path that is no file, a bad value of seconds, mb
/// or repeat; naming spec and value.
Result<PluginSpec> parse_plugin_spec(const std::string& spec);

}  // namespace ccdfuzz
