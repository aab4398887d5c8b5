// SPDX-License-Identifier: BSD-3-Clause
#include "tools/case_scores.h"

#include <memory>
#include <utility>

#include "agrid/evaluation/perturbation.h"
#include "agrid/map/map_io.h"
#include "tools/reports.h"
#include "tools/truth_files.h"

namespace agrid::tools {
namespace {

constexpr std::uint32_t kNoiseSeed = 1;

using Labels = std::vector<std::uint16_t>;

/// What is true about a place.
struct Truth {
  OccupancyMap empty_map;  ///< without furniture
  Labels rooms;
  RoomFloor floor = RoomFloor::kFree;
  bool has_doors = false;
  TrueDoors doors;
};

LoadedMap load(const std::string& yaml_path, const ConversionParams& params) {
  MapFileParams file_params;
  file_params.max_pixels = params.map.max_pixels;
  return loadMap(yaml_path, file_params);
}

Truth readTruth(const EvalCase& about, const OccupancyMap& map, const ConversionParams& params) {
  const bool same = about.empty_yaml == about.map_yaml;
  Truth truth{same ? map : OccupancyMap(load(about.empty_yaml, params).grid, params.map),
              readTrueRooms(about.rooms, map),
              about.group == EvalGroup::kPlain ? RoomFloor::kAll : RoomFloor::kFree,
              !about.doors.empty(),
              {}};
  if (truth.empty_map.pixels().size() != map.pixels().size()) {
    throw FileError(FileErrorCode::kImage,
                    about.map_yaml + ": not of the size of " + about.empty_yaml);
  }
  if (truth.has_doors) truth.doors = readTrueDoors(about.doors, map.geometry());
  return truth;
}

ViewScores scoreView(const OccupancyMap& map, const AreaMap& areas, const Labels& labels,
                     const Truth& truth) {
  ViewScores scores;
  scores.areas = scoreAreas(map, labels, truth.rooms, truth.floor);
  const std::vector<Segment> doors = doorSegments(areas);
  if (truth.has_doors) {
    scores.doors = scoreDoors(doors, truth.doors.jambs_map);
    scores.doors_complete = truth.doors.complete;
  } else {
    scores.doors = scoreDoors(truth.empty_map, doors, truth.rooms);
  }
  return scores;
}

std::vector<JudgedDoor> judge(const AreaMap& areas, const ViewScores& scores) {
  std::vector<JudgedDoor> judged;
  if (!scores.doors_complete) return judged;
  for (const Door& door : doorsBetweenAreas(areas)) {
    judged.push_back({static_cast<std::uint32_t>(door.id), door.kind, door.width, door.confidence,
                      scores.doors.is_true[judged.size()]});
  }
  return judged;
}

}  // namespace

std::vector<View> evalViews(bool robustness) {
  std::vector<View> views{{"as given", {}}};
  if (!robustness) return views;
  for (const int degrees : {7, 17, 30, 45}) {
    views.push_back({"turned by " + std::to_string(degrees) + " deg",
                     [degrees](const OccupancyMap& map) { return turned(map, degrees); }});
  }
  views.push_back({"at 0.1 m", [](const OccupancyMap& map) { return resampled(map, 0.1); }});
  views.push_back({"at 0.025 m", [](const OccupancyMap& map) { return resampled(map, 0.025); }});
  views.push_back({"with noise", [](const OccupancyMap& map) { return noisy(map, kNoiseSeed); }});
  return views;
}

CaseScores scoreCase(const EvalCase& about, const ConversionParams& params,
                     const std::vector<View>& views) {
  CaseScores scores;
  scores.about = about;
  LoadedMap loaded = load(about.map_yaml, params);
  scores.warnings = std::move(loaded.warnings);
  const auto map = std::make_shared<const OccupancyMap>(loaded.grid, params.map);
  const Truth truth = readTruth(about, *map, params);
  for (const View& view : views) {
    const auto seen = view.make ? std::make_shared<const OccupancyMap>(view.make(*map)) : map;
    const SemanticMap found =
        annotate(extractStructure(seen, params.pipeline), {}, params.pipeline);
    const Labels labels =
        labelsOn(map->geometry(), seen->geometry(), found.area_map.pixel_labels.vector());
    scores.views.push_back(scoreView(*map, found.area_map, labels, truth));
    if (scores.views.size() == 1) scores.doors = judge(found.area_map, scores.views.front());
  }
  return scores;
}

}  // namespace agrid::tools
