// SPDX-License-Identifier: BSD-3-Clause
#include "areas/automatic_areas.h"

#include <utility>

#include "agrid/areas/area_segmentation.h"

namespace agrid {
namespace {

std::vector<std::vector<PixelRun>> runsOf(const AreaMap& areas, const MapGeometry& geometry) {
  std::vector<std::vector<PixelRun>> runs(areas.areas.size());
  std::vector<std::uint16_t> row;
  for (int y = 0; y < geometry.height; ++y) {
    areas.pixel_labels.copy(geometry.index({0, y}), static_cast<std::size_t>(geometry.width), row);
    forEachRun(row.data(), geometry.width, [&](int begin, int end, std::uint16_t label) {
      if (label != 0) runs[label - 1U].push_back({y, begin, end});
    });
  }
  for (auto& of_area : runs) of_area.shrink_to_fit();
  return runs;
}

cv::Rect boxOf(const std::vector<PixelRun>& runs) {
  cv::Rect box;
  for (const PixelRun& run : runs) box |= cv::Rect(run.begin, run.y, run.end - run.begin, 1);
  return box;
}

}  // namespace

std::shared_ptr<const AutomaticAreas> findAutomaticAreas(const OccupancyMap& map, const AGrid& grid,
                                                         const AreaParams& params) {
  auto found = std::make_shared<AutomaticAreas>();
  TaggedAreas areas = findAreas(map, grid, {}, params);
  found->area_map = std::move(areas.area_map);
  found->mean_clearances = std::move(areas.mean_clearances);
  found->runs = runsOf(found->area_map, map.geometry());
  for (const auto& runs : found->runs) found->boxes.push_back(boxOf(runs));
  found->cell_shares =
      CellShares(grid, map.geometry(), found->area_map.pixel_labels, found->area_map.areas.size());
  found->min_area_size = params.min_island_size;
  found->min_border_length = params.min_border_length;
  found->max_door_width = params.max_door_width;
  return found;
}

}  // namespace agrid
