#pragma once

#include <functional>
#include <string>
#include <vector>

#include "files/case_files.hpp"

namespace ccdfuzz {

/// Where the inputs of properties are, in a folder of finds or a corpus.
inline constexpr const char* kClaims = "claims";

/// The paths of all entries of a folder and its sub-folders, except those called kClaims, in order.
/// An entry is a .json whose name does not start with a dot. Errors: the folder or a sub-folder
/// cannot be read; an entry is not a regular file (a pipe), naming it.
Result<std::vector<std::string>> list_entries(const std::string& folder);

/// Calls visit on each entry of a folder in their order, one at a time; its id is its path. Entries
/// that somebody removes meanwhile are left out. Errors: as list_entries; an entry that cannot be
/// read or whose truth is refuted, naming it.
Result<void> for_each_entry(const std::string& folder,
                            const std::function<void(const NamedCase&)>& visit);

/// The files of a corpus: the entries of a folder, or the one file. Errors: as list_entries; a
/// folder without any entry.
Result<std::vector<std::string>> corpus_files(const std::string& path);

}  // namespace ccdfuzz
