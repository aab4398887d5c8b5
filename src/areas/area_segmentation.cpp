// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/areas/area_segmentation.h"

#include <algorithm>
#include <utility>

#include <opencv2/core.hpp>

#include "areas/area_description.h"
#include "areas/area_labels.h"
#include "areas/category_guess.h"
#include "areas/cell_labels.h"
#include "areas/door_extraction.h"
#include "tags/aligned_view.h"
#include "tags/area_seeds.h"
#include "tags/division.h"
#include "tags/relief.h"
#include "tags/tag_numbering.h"

namespace agrid {
namespace {

std::vector<std::uint16_t> labelsOnFreePixels(const OccupancyMap& map, const AreaLabels& labels) {
  static_assert(AreaLabels::kNone + 1 == 0, "no area becomes 0");
  std::vector<std::uint16_t> result(map.pixels().size());
  std::transform(labels.of_pixel.begin(), labels.of_pixel.end(), map.pixels().begin(),
                 result.begin(), [](std::uint32_t label, Occupancy pixel) {
                   return static_cast<std::uint16_t>(pixel == Occupancy::kFree ? label + 1 : 0);
                 });
  return result;
}

std::string whyThereAreNoAreas(const OccupancyMap& map, const Relief& relief) {
  const auto& pixels = map.pixels();
  if (std::count(pixels.begin(), pixels.end(), Occupancy::kFree) == 0) {
    return "there are no areas: the map has no free pixel";
  }
  if (cv::countNonZero(relief.free_space) == 0) {
    return "there are no areas: every free part of the map is smaller than min_island_size";
  }
  return "there are no areas: no area tag lies in free space";
}

/// The areas on the map instead of its view; those that have no free pixel there are left out of
/// `on_view` as well.
AreaLabels bringToMap(const OccupancyMap& map, const AlignedView& view, AreaLabels& on_view) {
  AreaLabels on_map;
  on_map.tags = on_view.tags;
  on_map.of_pixel = view.labelsOnMap(on_view.of_pixel);
  const auto new_label = dropAreas(map, on_map);
  if (!new_label.empty()) relabel(new_label, on_view);
  on_map.warnings = on_view.warnings;
  return on_map;
}

TaggedAreas describe(const OccupancyMap& map, const AGrid& grid, const AlignedView& view,
                     const Relief& relief, AreaLabels on_view, const AreaParams& params) {
  const AreaLabels on_map = view.isMapItself() ? AreaLabels{} : bringToMap(map, view, on_view);
  const AreaLabels& labels = view.isMapItself() ? on_view : on_map;
  TaggedAreas tagged;
  AreaMap& result = tagged.area_map;
  result.warnings = relief.warnings;
  result.warnings.insert(result.warnings.end(), labels.warnings.begin(), labels.warnings.end());
  AreaMeasures measures = describeAreas(map, labels);
  result.areas = std::move(measures.areas);
  tagged.mean_clearances = std::move(measures.mean_clearances);
  if (result.areas.empty()) result.warnings.push_back(whyThereAreNoAreas(map, relief));
  result.doors = findDoors(on_view, relief, view.geometry(), params, result.warnings);
  guessCategories(on_view, relief, view.geometry().resolution, result.doors, result.areas);
  for (Door& door : result.doors) door.cells = cellsOnSegment(grid, door.jambs_map);
  result.pixel_labels = labelsOnFreePixels(map, labels);
  result.cell_areas = labelCells(grid, map.geometry(), result.pixel_labels, result.areas);
  return tagged;
}

TaggedAreas segment(const OccupancyMap& map, const AGrid& grid, const std::vector<Tag>& tags,
                    const AreaParams& params) {
  validate(params);
  const AlignedView view(map, params, grid.mapFromGrid().yaw);
  const std::vector<Tag> on_view = view.tagsOnView(tags);
  const Relief relief = makeRelief(view.map(), on_view, params);
  Division division = divide(relief, view.geometry().resolution, params);
  AreaLabels labels = growAreas(view.map(), relief, std::move(division), on_view, params);
  return describe(map, grid, view, relief, std::move(labels), params);
}

}  // namespace

AreaMap segmentAreas(const OccupancyMap& map, const AGrid& grid, const std::vector<Tag>& tags,
                     const AreaParams& params) {
  return segment(map, grid, tags, params).area_map;
}

TaggedAreas findAreas(const OccupancyMap& map, const AGrid& grid, const std::vector<Tag>& given,
                      const AreaParams& params) {
  TaggedAreas result;
  result.tags = given;
  if (params.method == AreaMethod::kPaper) {  // its doors change the relief
    for (Tag& tag : proposeTags(map, given, params)) result.tags.push_back(std::move(tag));
    TaggedAreas segmented = segment(map, grid, result.tags, params);
    segmented.tags = std::move(result.tags);
    return segmented;
  }
  validate(params);
  const AlignedView view(map, params, grid.mapFromGrid().yaw);
  std::vector<Tag> on_view = view.tagsOnView(given);
  const Relief relief = makeRelief(view.map(), on_view, params);
  Division division = divide(relief, view.geometry().resolution, params);
  const auto seeds = proposeSeeds(relief, division, view.geometry(), on_view, params);
  addNumbered(seeds, given, result.tags);
  on_view.insert(on_view.end(), result.tags.begin() + static_cast<std::ptrdiff_t>(given.size()),
                 result.tags.end());
  AreaLabels labels = growAreas(view.map(), relief, std::move(division), on_view, params);
  TaggedAreas described = describe(map, grid, view, relief, std::move(labels), params);
  described.tags = std::move(result.tags);
  return described;
}

}  // namespace agrid
