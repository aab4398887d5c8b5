// SPDX-License-Identifier: BSD-3-Clause
#include "tags/free_space.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "map/squared_distance.h"
#include "tags/pixel_runs.h"

namespace agrid {
namespace {

/// What is known of a connected component of pixels.
struct Extent {
  int left = std::numeric_limits<int>::max();
  int right = 0;  ///< one past the last column
  int top = std::numeric_limits<int>::max();
  int bottom = 0;  ///< one past the last row
  std::int64_t size_px = 0;

  void add(const PixelRun& run) {
    left = std::min(left, run.begin);
    right = std::max(right, run.end);
    top = std::min(top, run.y);
    bottom = std::max(bottom, run.y + 1);
    size_px += run.end - run.begin;
  }
};

/// Turns the 8-connected components of the pixels of one value that `is_dropped` picks into 1 if
/// they are 0, into 0 if they are 1.
template <typename Predicate>
void dropComponents(cv::Mat1b& free_space, std::uint8_t value, Predicate is_dropped) {
  const std::vector<PixelRun> runs = findRuns(free_space, value);
  const std::vector<std::uint32_t> component_of = connectRuns(runs, true);
  std::vector<Extent> extents;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (component_of[i] == extents.size()) extents.emplace_back();
    extents[component_of[i]].add(runs[i]);
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!is_dropped(extents[component_of[i]])) continue;
    std::uint8_t* row = free_space[runs[i].y];
    std::fill(row + runs[i].begin, row + runs[i].end, value == 0 ? 1 : 0);
  }
}

}  // namespace

cv::Mat1b cleanFreeSpace(const OccupancyMap& map, const AreaParams& params) {
  const MapGeometry& geometry = map.geometry();
  cv::Mat1b free_space(geometry.height, geometry.width);
  std::transform(map.pixels().begin(), map.pixels().end(), free_space.ptr(),
                 [](Occupancy o) { return o == Occupancy::kFree ? 1 : 0; });

  const double max_diagonal = params.max_clutter_diagonal / geometry.resolution;
  dropComponents(free_space, 0, [&](const Extent& e) {
    const bool at_border =
        e.left == 0 || e.top == 0 || e.right == geometry.width || e.bottom == geometry.height;
    return !at_border && std::hypot(e.right - e.left, e.bottom - e.top) < max_diagonal;
  });
  const double min_island = params.min_island_size / (geometry.resolution * geometry.resolution);
  dropComponents(free_space, 1,
                 [&](const Extent& e) { return static_cast<double>(e.size_px) < min_island; });
  return free_space;
}

cv::Mat1f distanceFromWalls(const cv::Mat1b& free_space) {
  // cv::distanceTransform is wrong from the 4098th column on, where floats hold no square of x
  std::vector<std::uint8_t> walls(free_space.total());
  std::transform(free_space.ptr(), free_space.ptr() + walls.size(), walls.begin(),
                 [](std::uint8_t free) { return free == 0 ? 1 : 0; });
  const MapGeometry geometry{free_space.cols, free_space.rows, 1, {}};
  cv::Mat1f distance(free_space.size());
  forEachRowOfSquaredDistances(
      geometry, walls.data(), Surroundings::kMarked, [&](int y, const std::int32_t* squared) {
        std::transform(squared, squared + geometry.width, distance[y],
                       [](std::int32_t d2) { return std::sqrt(static_cast<float>(d2)); });
      });
  return distance;
}

}  // namespace agrid
