// SPDX-License-Identifier: BSD-3-Clause
// Drawn offices, whose rooms and doors are known, scored as agrid_map_tool eval does.
#include <map>
#include <memory>

#include <gtest/gtest.h>

#include "agrid/evaluation/office_generator.h"
#include "agrid/evaluation/perturbation.h"
#include "agrid/map/map_io.h"
#include "agrid/pipeline.h"
#include "evaluation/mean_scores.h"
#include "exchange/label_image.h"
#include "support/temporary_folder.h"
#include "tools/case_scoring.h"
#include "tools/image_frame.h"
#include "tools/output_directory.h"

namespace agrid {
namespace {

constexpr int kThreads = 2;

/// Draws an office as agrid_map_tool generate does.
void drawOffice(const std::string& folder, const OfficeParams& params) {
  const Office office = generateOffice(params);
  const MapGeometry& geometry = office.grid.geometry;
  std::filesystem::create_directory(folder);
  saveMap(office.grid, folder + "/office.yaml");
  tools::writePng(folder + "/rooms.png", labelImage(office.rooms, geometry));
  tools::writeText(folder + "/doors.csv", tools::segmentsCsv(office.doors_map, geometry));
}

std::vector<tools::CaseScores> scoreOffices(bool furniture, bool noise,
                                            const std::vector<tools::View>& views) {
  const test::TemporaryFolder temp;
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    OfficeParams params;
    params.size = 800;
    params.seed = seed;
    params.furniture = furniture;
    params.noise = noise;
    drawOffice(temp / std::to_string(seed), params);
  }
  const auto cases = tools::findEvalCases(temp.path(), "").cases;
  return tools::scoreCases(cases, {}, views, kThreads);
}

/// Labels by where they come first: areas are numbered from the top of the map frame.
std::vector<std::size_t> numberedByPlace(const std::vector<std::uint16_t>& labels) {
  std::map<std::uint16_t, std::size_t> numbers;
  std::vector<std::size_t> numbered;
  for (const std::uint16_t label : labels) {
    numbered.push_back(numbers.try_emplace(label, numbers.size()).first->second);
  }
  return numbered;
}

TEST(DrawnOffices, AreSeenTheSameWhateverTheirPose) {
  // Turned views keep their place in the map frame; nobody may take the angle from there.
  OfficeParams params;
  params.size = 400;
  const OccupancyMap view = turned(OccupancyMap(generateOffice(params).grid), 30);
  OccupancyGrid grid;
  grid.geometry = view.geometry();
  grid.geometry.map_from_image = {};
  for (const Occupancy o : view.pixels()) {
    grid.values.push_back(o == Occupancy::kFree ? 0 : o == Occupancy::kOccupied ? 100 : -1);
  }
  const auto labelsOf = [](const OccupancyMap& map) {
    const auto shared = std::make_shared<const OccupancyMap>(map);
    return numberedByPlace(
        annotate(extractStructure(shared, {}), {}, {}).area_map.pixel_labels.vector());
  };
  EXPECT_EQ(labelsOf(view), labelsOf(OccupancyMap(grid)));
}

TEST(DrawnOffices, EmptyOnesScoreAsMeasured) {
  test::expectAsMeasured(scoreOffices(false, false, tools::evalViews(false)), test::kEmptyOffices,
                         RoomFloor::kFree);
}

TEST(DrawnOffices, FurnishedOnesScoreAsMeasured) {
  test::expectAsMeasured(scoreOffices(true, false, tools::evalViews(false)),
                         test::kFurnishedOffices, RoomFloor::kFree);
}

TEST(DrawnOffices, ScannedOnesAndOtherViewsOfThemScoreAsMeasured) {
  const auto views = tools::evalViews(true);
  const auto scores = scoreOffices(true, true, views);
  test::expectAsMeasured(scores, test::kScannedOffices, RoomFloor::kFree);
  test::expectFallsAsMeasured(scores, views, &test::MeasuredFall::offices);
}

}  // namespace
}  // namespace agrid
