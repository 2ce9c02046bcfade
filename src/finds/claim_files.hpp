#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "finds/claim_find.hpp"

namespace ccdfuzz {

/// Where the finds of claims are in a corpus or a folder of finds.
std::string claims_in(const std::string& corpus);
/// Whether the path is that of such a folder itself: the first entry in it is a find of a claim.
/// Where there is none, by its name (kClaims). A corpus may have that name, too, and has one
/// inside.
bool is_claims_folder(const std::string& path);

/// The files of a corpus, which has cases and finds of claims.
struct CorpusFiles {
  std::vector<std::string> cases, claims;
};
/// Those of a corpus, or of a folder of claims, which has no cases. A path of a file is a claim if
/// it can be read as one, and a case if not. Errors: a folder cannot be read.
Result<CorpusFiles> cases_and_claims(const std::string& corpus);

/// The find in a file. Errors: it cannot be read, or is no find.
Result<ClaimFind> read_claim(const std::string& path);
/// The text of its file.
std::string file_text(const ClaimFind& find);

/// The find of the same property and error in a folder, if it expects the same. Errors: a file that
/// is no find.
Result<std::optional<ClaimFind>> saved_claim(const std::string& folder, const ClaimFind& like);

struct SavedClaim {
  std::string path;
  bool is_new = true;  ///< else what was there stays
  std::optional<ClaimFind> replaced = {};
};

/// Puts a find into the file of this name, without ".json", or else of its stem(). Under its stem
/// it takes the place of one that it replaces. An entry of another name, or that expects something
/// else, stays, and the find is named by its hash. Errors: of the folder or file.
Result<SavedClaim> save_claim(const std::string& folder, const ClaimFind& find,
                              const std::string& name = "");

/// The counts of a merge of finds of claims.
struct MergedClaims {
  std::uint64_t entries = 0, taken = 0;
  std::uint64_t without_input = 0;  ///< finds that did not fail again, which have no choices
};

/// Copies the finds of these files into the claims of a corpus (save_claim), whose folder is made
/// if there are any. An input that is there already stays as it is. known: all the properties that
/// there are. Errors: of a folder or file; an entry of an unknown property, naming it.
Result<MergedClaims> merge_claims(const std::vector<std::string>& files, const std::string& corpus,
                                  const std::vector<Property>& known);

}  // namespace ccdfuzz
