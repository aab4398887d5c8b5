// SPDX-License-Identifier: BSD-3-Clause
#include "areas/group_parts.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include <opencv2/imgproc.hpp>

#include "areas/area_description.h"
#include "areas/area_labels.h"
#include "areas/category_guess.h"
#include "areas/joined_area.h"
#include "tags/door_barrier.h"
#include "tags/pixel_neighbours.h"

namespace agrid {
namespace {

/// A rectangle of the map as a map of its own.
OccupancyMap cropped(const OccupancyMap& map, const cv::Rect& window) {
  OccupancyGrid grid;
  grid.geometry = map.geometry();
  grid.geometry.width = window.width;
  grid.geometry.height = window.height;
  grid.geometry.map_from_image.position =
      map.geometry().map_from_image * (Point2(window.x, window.y) * map.geometry().resolution);
  grid.values.reserve(grid.geometry.pixelCount());
  for (int y = window.y; y < window.br().y; ++y) {
    const Occupancy* row = map.pixels().data() + map.geometry().index({window.x, y});
    for (int x = 0; x < window.width; ++x) {
      grid.values.push_back(row[x] == Occupancy::kFree       ? std::int8_t{0}
                            : row[x] == Occupancy::kOccupied ? std::int8_t{100}
                                                             : std::int8_t{-1});
    }
  }
  MapParams params;
  params.max_pixels = static_cast<double>(grid.geometry.pixelCount());
  return OccupancyMap(grid, params);
}

/// Around a group so far that the distances to the walls within it are right: nothing in it is
/// farther from them than `clearance`.
cv::Rect withMargin(const cv::Rect& box, double clearance, const MapGeometry& geometry) {
  const int margin = 2 + static_cast<int>(std::ceil(clearance / geometry.resolution));
  return cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin) &
         cv::Rect(0, 0, geometry.width, geometry.height);
}

/// A group's pixels in their window.
struct Shape {
  cv::Rect window;
  cv::Mat1b mask;
};

Shape shapeOfMembers(const AreaGroup& group, const MapGeometry& geometry,
                     const AutomaticAreas& automatic) {
  cv::Rect box;
  double clearance = 0;
  for (const std::uint16_t label : group.members) {
    box |= automatic.boxes[label - 1U];
    clearance = std::max(clearance, automatic.area_map.areas[label - 1U].anchor_clearance);
  }
  Shape shape;
  shape.window = withMargin(box, clearance, geometry);
  shape.mask = cv::Mat1b(shape.window.size(), std::uint8_t{0});
  for (const std::uint16_t label : group.members) {
    for (const PixelRun& run : automatic.runs[label - 1U]) {
      std::uint8_t* row = shape.mask[run.y - shape.window.y] - shape.window.x;
      std::fill(row + run.begin, row + run.end, std::uint8_t{1});
    }
  }
  return shape;
}

Shape shapeOfIsland(const AreaGroup& group, const OccupancyMap& map,
                    const AutomaticAreas& automatic) {
  const MapGeometry& geometry = map.geometry();
  const auto seed = geometry.pixelAt(group.seed_map);
  const auto island = islandAt(seed.value(), map, automatic.area_map.pixel_labels);
  cv::Rect box;
  for (const std::size_t i : island) {
    const Pixel p = geometry.pixel(i);
    box |= cv::Rect(p.x, p.y, 1, 1);
  }
  Shape shape;
  // no place of it is farther from what is not free than half of its shorter side, unless another
  // area opens there
  shape.window = withMargin(box, std::min(box.width, box.height) * geometry.resolution, geometry);
  shape.mask = cv::Mat1b(shape.window.size(), std::uint8_t{0});
  for (const std::size_t i : island) {
    const Pixel p = geometry.pixel(i);
    shape.mask(p.y - shape.window.y, p.x - shape.window.x) = 1;
  }
  return shape;
}

/// Components that are parts of their own: those beside a barrier that are large enough. All others
/// are 0 and will go to a part beside them, or to the largest.
std::vector<int> numberParts(const cv::Mat1i& component_of, const cv::Mat1b& beside_barrier,
                             int components, double least_px) {
  std::vector<std::size_t> size(static_cast<std::size_t>(components), 0);
  std::vector<std::uint8_t> beside(size.size(), 0);
  for (int y = 0; y < component_of.rows; ++y) {
    for (int x = 0; x < component_of.cols; ++x) {
      const auto c = static_cast<std::size_t>(component_of(y, x));
      ++size[c];
      if (beside_barrier(y, x) != 0) beside[c] = 1;
    }
  }
  std::vector<std::size_t> order;
  for (std::size_t c = 1; c < size.size(); ++c) {
    if (beside[c] != 0 && static_cast<double>(size[c]) >= least_px) order.push_back(c);
  }
  if (order.empty() && size.size() > 1) {
    order.push_back(
        static_cast<std::size_t>(std::max_element(size.begin() + 1, size.end()) - size.begin()));
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return size[a] > size[b]; });
  std::vector<int> part_of(size.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i) part_of[order[i]] = static_cast<int>(i) + 1;
  return part_of;
}

/// Gives the pixels of `mask` without a part to the part that is nearest over such pixels, the rest
/// to the first one.
void handOverRest(const cv::Mat1b& mask, cv::Mat1i& part_of) {
  std::vector<cv::Point> front;
  const cv::Rect inside(0, 0, mask.cols, mask.rows);
  const auto isOpen = [&](cv::Point p) { return mask(p) != 0 && part_of(p) == 0; };
  const auto partBeside = [&](cv::Point p) {
    for (const Pixel step : kNeighbours) {
      const cv::Point q(p.x + step.x, p.y + step.y);
      if (inside.contains(q) && part_of(q) != 0) return part_of(q);
    }
    return 0;
  };
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      if (isOpen({x, y})) front.emplace_back(x, y);
    }
  }
  while (!front.empty()) {
    std::vector<std::pair<cv::Point, int>> found;
    std::vector<cv::Point> rest;
    for (const cv::Point p : front) {
      const int part = partBeside(p);
      if (part != 0) {
        found.emplace_back(p, part);
      } else {
        rest.push_back(p);
      }
    }
    for (const auto& [p, part] : found) part_of(p) = part;
    if (found.empty()) {
      for (const cv::Point p : rest) part_of(p) = 1;
      return;
    }
    front = std::move(rest);
  }
}

/// Parts of the mask after its barriers are closed.
cv::Mat1i cutAt(const std::vector<Barrier>& barriers, const cv::Mat1b& mask, double least_px) {
  cv::Mat1b open = mask.clone();
  closeDoors(barriers, open);
  cv::Mat1b beside(mask.size(), std::uint8_t{0});
  for (const Barrier& barrier : barriers) {
    for (const std::size_t i : barrier.pixels) beside.ptr()[i] = 1;
  }
  cv::dilate(beside, beside, cv::Mat::ones(3, 3, CV_8U));
  cv::Mat1i component_of;
  const int components = cv::connectedComponents(open, component_of, 8, CV_32S);
  const std::vector<int> part = numberParts(component_of, beside, components, least_px);
  cv::Mat1i part_of(mask.size());
  std::transform(component_of.begin(), component_of.end(), part_of.begin(),
                 [&](int c) { return part[static_cast<std::size_t>(c)]; });
  handOverRest(mask, part_of);
  return part_of;
}

/// The parts as areas; how many doors they have is not known here.
std::vector<Area> describe(const OccupancyMap& window, const cv::Mat1i& part_of, int parts) {
  AreaLabels labels;
  labels.tags.resize(static_cast<std::size_t>(parts));
  labels.of_pixel.reserve(part_of.total());
  for (const int part : part_of) {
    labels.of_pixel.push_back(part == 0 ? AreaLabels::kNone : static_cast<std::uint32_t>(part - 1));
  }
  AreaMeasures measures = describeAreas(window, labels);
  for (std::size_t i = 0; i < measures.areas.size(); ++i) {
    Area& area = measures.areas[i];
    area.category_guess =
        guessCategory({area.size, measures.mean_clearances[i], area.anchor_clearance, 0});
  }
  return std::move(measures.areas);
}

}  // namespace

std::vector<std::size_t> islandAt(Pixel seed, const OccupancyMap& map, const PixelLabels& labels) {
  const MapGeometry& geometry = map.geometry();
  std::unordered_set<std::size_t> seen;
  std::vector<std::size_t> island;
  const auto visit = [&](Pixel p) {
    if (!geometry.contains(p) || !map.isFree(p)) return;
    const std::size_t i = geometry.index(p);
    if (labels[i] == 0 && seen.insert(i).second) island.push_back(i);
  };
  visit(seed);
  for (std::size_t next = 0; next < island.size(); ++next) {
    for (std::size_t k = 0; k < 4; ++k) visit(geometry.pixel(island[next]) + kNeighbours[k]);
  }
  return island;
}

GroupParts partsOf(const AreaGroup& group, const OccupancyMap& map,
                   const AutomaticAreas& automatic) {
  if (!group.members.empty() && group.doors.empty())
    return {{}, {}, {joinedArea(group.members, automatic, map.geometry())}, {}};
  const Shape shape = group.members.empty() ? shapeOfIsland(group, map, automatic)
                                            : shapeOfMembers(group, map.geometry(), automatic);
  const cv::Mat1b& mask = shape.mask;
  GroupParts result;
  result.window = shape.window;
  const OccupancyMap window = cropped(map, result.window);
  std::vector<Barrier> barriers;
  for (const GivenDoor& door : group.doors) {
    DoorTag tag;
    tag.pose_map = door.pose_map;
    tag.width = door.width;
    auto barrier = findBarrier(mask, window.geometry(), tag);
    result.jambs_map.push_back(barrier ? barrier->jambs_map : Segment{});
    if (barrier) barriers.push_back(std::move(*barrier));
  }
  const double resolution = map.geometry().resolution;
  result.part_of = cutAt(barriers, mask, automatic.min_area_size / (resolution * resolution));
  int parts = 0;
  for (const int part : result.part_of) parts = std::max(parts, part);
  result.parts = describe(window, result.part_of, parts);
  return result;
}

}  // namespace agrid
