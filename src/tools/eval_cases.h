// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace agrid::tools {

/// How the truth of a map was made, which decides what is compared.
enum class EvalGroup {
  kPlain,      ///< an empty floor plan; its rooms were drawn on it
  kFurnished,  ///< the same with furniture; the rooms are those of the empty one
  kFolder,     ///< a map in a folder of its own
};

/// What tables and files call it: "plain", "furnished", "folder".
const char* nameOf(EvalGroup group);

/// A map with its truth.
struct EvalCase {
  std::string name;
  EvalGroup group = EvalGroup::kFolder;
  std::string map_yaml;
  std::string empty_yaml;  ///< the map without furniture; the same if there is none
  std::string rooms;       ///< file of the true rooms
  std::string doors;       ///< file of the true doors; empty: the borders between the rooms
};

struct EvalCases {
  std::vector<EvalCase> cases;             ///< by group, then by name
  std::vector<std::string> without_truth;  ///< names of maps
};

/// Finds maps and their truth in a folder (doc/tool.md tells the layouts).
/// @param truth_folder  looked into first for the truth, in the same layout; may be empty
/// @throws FileError if a folder cannot be read
EvalCases findEvalCases(const std::string& folder, const std::string& truth_folder);

}  // namespace agrid::tools
