// SPDX-License-Identifier: BSD-3-Clause
#include "tools/eval_cases.h"

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "agrid/map/map_io.h"

namespace agrid::tools {
namespace {

namespace fs = std::filesystem;

const std::string kFurniture = "_furnitures";

using Names = std::vector<std::string>;

/// The first of these files that is there, or nothing.
std::string firstFile(const Names& folders, const Names& files) {
  for (const std::string& folder : folders) {
    for (const std::string& file : files) {
      const fs::path path = fs::path(folder) / file;
      std::error_code missing;
      if (fs::is_regular_file(path, missing)) return path.string();
    }
  }
  return "";
}

std::vector<fs::path> entriesOf(const std::string& folder) {
  std::vector<fs::path> entries;
  try {
    for (const auto& entry : fs::directory_iterator(folder)) entries.push_back(entry.path());
  } catch (const fs::filesystem_error& error) {
    throw FileError(FileErrorCode::kPath, folder + ": " + error.code().message());
  }
  return entries;
}

/// The map of a folder that holds one map; a drawn office tells itself by its rooms.
std::string mapOf(const std::string& folder) {
  const std::string map = firstFile({folder}, {"map.yaml"});
  if (!map.empty() || firstFile({folder}, {"rooms.png"}).empty()) return map;
  return firstFile({folder}, {"office.yaml"});
}

void addFolder(const std::string& folder, const Names& truth_folders, EvalCases& found) {
  EvalCase one;
  one.name = fs::path(folder).filename().string();
  one.map_yaml = one.empty_yaml = mapOf(folder);
  one.rooms =
      firstFile(truth_folders, {"rooms.yaml", "rooms_gt.png", "rooms.png", "locations.png"});
  one.doors = firstFile(truth_folders, {"doors.yaml", "doors.csv"});
  if (one.rooms.empty()) return found.without_truth.push_back(one.name);
  found.cases.push_back(one);
}

void addFile(const fs::path& yaml, const Names& truth_folders, EvalCases& found) {
  EvalCase one;
  one.name = yaml.stem().string();
  one.map_yaml = one.empty_yaml = yaml.string();
  std::string building = one.name;
  const bool furnished =
      building.size() > kFurniture.size() &&
      building.compare(building.size() - kFurniture.size(), std::string::npos, kFurniture) == 0;
  if (furnished) {
    building.resize(building.size() - kFurniture.size());
    const std::string empty = firstFile({yaml.parent_path().string()}, {building + ".yaml"});
    if (!empty.empty()) one.empty_yaml = empty;
  }
  one.group = furnished ? EvalGroup::kFurnished : EvalGroup::kPlain;
  one.rooms = firstFile(truth_folders, {building + "_gt_segmentation.png"});
  if (one.rooms.empty()) return found.without_truth.push_back(one.name);
  found.cases.push_back(one);
}

/// The folder itself and, before it, where its truth may lie apart.
Names truthFolders(const std::string& folder, const std::string& truth_folder) {
  if (truth_folder.empty()) return {folder};
  return {truth_folder, folder};
}

}  // namespace

const char* nameOf(EvalGroup group) {
  switch (group) {
    case EvalGroup::kPlain:
      return "plain";
    case EvalGroup::kFurnished:
      return "furnished";
    case EvalGroup::kFolder:
      break;
  }
  return "folder";
}

EvalCases findEvalCases(const std::string& folder, const std::string& truth_folder) {
  EvalCases found;
  // A trailing slash would leave a folder without a name.
  const std::string root = fs::absolute(folder + "/.").lexically_normal().parent_path().string();
  const std::vector<fs::path> entries = entriesOf(root);
  if (!truth_folder.empty()) entriesOf(truth_folder);
  if (!mapOf(root).empty()) {
    addFolder(root, truthFolders(root, truth_folder), found);
    return found;
  }
  for (const fs::path& entry : entries) {
    const std::string name = entry.filename().string();
    if (fs::is_directory(entry)) {
      if (mapOf(entry.string()).empty()) continue;
      const std::string truth = truth_folder.empty() ? "" : truth_folder + "/" + name;
      addFolder(entry.string(), truthFolders(entry.string(), truth), found);
    } else if (entry.extension() == ".yaml") {
      addFile(entry, truthFolders(root, truth_folder), found);
    }
  }
  std::sort(found.cases.begin(), found.cases.end(), [](const EvalCase& a, const EvalCase& b) {
    return std::tie(a.group, a.name) < std::tie(b.group, b.name);
  });
  std::sort(found.without_truth.begin(), found.without_truth.end());
  return found;
}

}  // namespace agrid::tools
