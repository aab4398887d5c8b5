// SPDX-License-Identifier: BSD-3-Clause
#include "areas/automatic_areas.h"

#include <utility>

#include "agrid/areas/area_segmentation.h"
#include "tags/pixel_runs.h"

namespace agrid {
namespace {

std::vector<cv::Rect> boxesOf(const AreaMap& areas, const MapGeometry& geometry) {
  std::vector<cv::Rect> boxes(areas.areas.size());
  for (int y = 0; y < geometry.height; ++y) {
    forEachRun(areas.pixel_labels.data() + geometry.index({0, y}), geometry.width,
               [&](int begin, int end, std::uint16_t label) {
                 if (label != 0) boxes[label - 1U] |= cv::Rect(begin, y, end - begin, 1);
               });
  }
  return boxes;
}

}  // namespace

std::shared_ptr<const AutomaticAreas> findAutomaticAreas(const OccupancyMap& map, const AGrid& grid,
                                                         const AreaParams& params) {
  auto found = std::make_shared<AutomaticAreas>();
  found->area_map = findAreas(map, grid, {}, params).area_map;
  found->boxes = boxesOf(found->area_map, map.geometry());
  found->min_area_size = params.min_island_size;
  found->min_border_length = params.min_border_length;
  return found;
}

}  // namespace agrid
