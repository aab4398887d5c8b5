// SPDX-License-Identifier: BSD-3-Clause
#include "tags/free_space.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "map/squared_distance.h"

namespace agrid {
namespace {

/// Gives `new_value` to the pixels of each 8-connected component of `mask` that `is_dropped` picks
/// by its statistics.
template <typename Predicate>
void dropComponents(const cv::Mat1b& mask, cv::Mat1b& free_space, std::uint8_t new_value,
                    Predicate is_dropped) {
  cv::Mat1i labels;
  cv::Mat1i stats;
  cv::Mat1d centroids;
  const int count = cv::connectedComponentsWithStats(mask, labels, stats, centroids, 8, CV_32S);
  std::vector<std::uint8_t> dropped(static_cast<std::size_t>(count), 0);
  for (int i = 1; i < count; ++i) dropped[static_cast<std::size_t>(i)] = is_dropped(stats.row(i));
  for (int y = 0; y < mask.rows; ++y) {
    const int* label = labels[y];
    std::uint8_t* out = free_space[y];
    for (int x = 0; x < mask.cols; ++x) {
      if (dropped[static_cast<std::size_t>(label[x])]) out[x] = new_value;
    }
  }
}

}  // namespace

cv::Mat1b cleanFreeSpace(const OccupancyMap& map, const AreaParams& params) {
  const MapGeometry& geometry = map.geometry();
  cv::Mat1b free_space(geometry.height, geometry.width);
  std::transform(map.pixels().begin(), map.pixels().end(), free_space.begin(),
                 [](Occupancy o) { return o == Occupancy::kFree ? 1 : 0; });

  const double max_diagonal = params.max_clutter_diagonal / geometry.resolution;
  dropComponents(free_space == 0, free_space, 1, [&](const cv::Mat1i& stats) {
    const cv::Rect box(stats(cv::CC_STAT_LEFT), stats(cv::CC_STAT_TOP), stats(cv::CC_STAT_WIDTH),
                       stats(cv::CC_STAT_HEIGHT));
    const bool at_border = box.x == 0 || box.y == 0 || box.x + box.width == geometry.width ||
                           box.y + box.height == geometry.height;
    return !at_border && std::hypot(box.width, box.height) < max_diagonal;
  });

  const double min_island = params.min_island_size / (geometry.resolution * geometry.resolution);
  dropComponents(free_space.clone(), free_space, 0,
                 [&](const cv::Mat1i& stats) { return stats(cv::CC_STAT_AREA) < min_island; });
  return free_space;
}

std::vector<std::int32_t> squaredDistancesFromWalls(const cv::Mat1b& free_space) {
  // cv::distanceTransform is wrong from the 4098th column on, where floats hold no square of x
  std::vector<std::uint8_t> walls(free_space.total());
  std::transform(free_space.begin(), free_space.end(), walls.begin(),
                 [](std::uint8_t free) { return free == 0 ? 1 : 0; });
  const MapGeometry geometry{free_space.cols, free_space.rows, 1, {}};
  std::vector<std::int32_t> squared = squaredDistances(geometry, walls);
  std::size_t i = 0;
  for (int y = 0; y < geometry.height; ++y) {
    const int beyond_y = std::min(y + 1, geometry.height - y);
    for (int x = 0; x < geometry.width; ++x, ++i) {
      const std::int64_t beyond = std::min({beyond_y, x + 1, geometry.width - x});
      if (squared[i] > beyond * beyond) squared[i] = static_cast<std::int32_t>(beyond * beyond);
    }
  }
  return squared;
}

cv::Mat1f distanceFromWalls(const cv::Mat1b& free_space) {
  const std::vector<std::int32_t> squared = squaredDistancesFromWalls(free_space);
  cv::Mat1f distance(free_space.size());
  std::transform(squared.begin(), squared.end(), distance.begin(),
                 [](std::int32_t d2) { return std::sqrt(static_cast<float>(d2)); });
  return distance;
}

}  // namespace agrid
