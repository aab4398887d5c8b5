// SPDX-License-Identifier: BSD-3-Clause
#include "tags/fragments.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "tags/disjoint_sets.h"
#include "tags/free_space.h"
#include "tags/hand_over.h"
#include "tags/persistence.h"
#include "tags/pixel_line.h"

namespace agrid {
namespace {

constexpr double kMergeRatio = 0.95;
constexpr double kMinProminence = 0.05;  // [m]
constexpr double kMinSize = 0.3;         // [m^2]

/// Closes the openings in free space; returns their pixels, each once.
std::vector<std::size_t> closeOpenings(const MapGeometry& geometry, Openings& openings,
                                       cv::Mat1b& free_space) {
  constexpr double kInWall = 1.5;  // [px]
  std::vector<std::size_t> closed;
  for (std::uint32_t k = 0; k < openings.all.size(); ++k) {
    const Segment& jambs = openings.all[k].jambs;
    const double length = jambs.length();
    const Point2 direction = (jambs.b - jambs.a) / length;
    walkPixels(jambs.a - direction * kInWall, direction, [&](Pixel p, double entered) {
      if (entered > length + 2 * kInWall) return false;
      if (geometry.contains(p) && free_space(p.y, p.x) != 0) {
        free_space(p.y, p.x) = 0;
        closed.push_back(geometry.index(p));
        openings.at_pixel.emplace(closed.back(), k);
      }
      return true;
    });
  }
  return closed;
}

/// Joins each region under a size to the neighbour that it has the longest border with, the
/// smallest first.
class SmallRegions {
 public:
  SmallRegions(const std::vector<std::uint32_t>& labels, std::size_t count,
               const MapGeometry& geometry)
      : sets_(count), size_px_(count), border_(count) {
    for (const std::uint32_t label : labels) {
      if (label != Basins::kNone) ++size_px_[label];
    }
    for (const BorderPoint& point : findBorderPoints(labels, geometry)) {
      ++border_[point.a][point.b];
      ++border_[point.b][point.a];
    }
  }

  /// @return for each region the one it belongs to
  std::vector<std::uint32_t> join(double min_size_px) {
    std::vector<std::uint32_t> order(size_px_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return size_px_[a] < size_px_[b]; });
    for (const std::uint32_t region : order) {
      const std::uint32_t small = sets_.find(region);
      if (static_cast<double>(size_px_[small]) < min_size_px) joinToNeighbour(small);
    }
    std::vector<std::uint32_t> region_of(size_px_.size());
    for (std::uint32_t i = 0; i < region_of.size(); ++i) region_of[i] = sets_.find(i);
    return region_of;
  }

 private:
  void joinToNeighbour(std::uint32_t small) {
    std::uint32_t widest = small;
    std::size_t length = 0;
    for (const auto& [neighbour, border] : border_[small]) {
      if (border <= length) continue;
      widest = neighbour;
      length = border;
    }
    if (widest == small) return;
    sets_.unite(widest, small);
    size_px_[widest] += size_px_[small];
    for (const auto& [neighbour, border] : border_[small]) {
      border_[neighbour].erase(small);
      if (neighbour == widest) continue;
      border_[neighbour][widest] += border;
      border_[widest][neighbour] += border;
    }
    border_[small].clear();
  }

  DisjointSets sets_;
  std::vector<std::size_t> size_px_;
  std::vector<std::map<std::uint32_t, std::size_t>> border_;  ///< to each neighbour [px]
};

/// Numbers the regions in row-major order of their first pixel and describes them as basins.
void describeRegions(const cv::Mat1f& height, Basins& result) {
  std::vector<std::uint32_t> number;
  for (std::size_t i = 0; i < result.of_pixel.size(); ++i) {
    std::uint32_t& label = result.of_pixel[i];
    if (label == Basins::kNone) continue;
    if (label >= number.size()) number.resize(label + 1, Basins::kNone);
    if (number[label] == Basins::kNone) {
      number[label] = static_cast<std::uint32_t>(result.basins.size());
      result.basins.emplace_back();
    }
    label = number[label];
    Basin& basin = result.basins[label];
    ++basin.size_px;
    const float h = height.ptr<float>()[i];
    if (h <= basin.height) continue;
    basin.height = h;
    basin.peak = i;
  }
}

/// The highest way between each two regions that touch.
void findSaddles(const cv::Mat1f& height, const std::vector<BorderPoint>& borders, Basins& result) {
  const float* heights = height.ptr<float>();
  for (const BorderPoint& point : borders) {
    const std::size_t lower = point.lower(heights);
    const bool is_new = result.saddles.empty() || result.saddles.back().a != point.a ||
                        result.saddles.back().b != point.b;
    if (is_new) result.saddles.push_back({heights[lower], point.a, point.b, lower});
    Saddle& saddle = result.saddles.back();
    if (heights[lower] <= saddle.height) continue;
    saddle.height = heights[lower];
    saddle.pixel = lower;
  }
  std::stable_sort(result.saddles.begin(), result.saddles.end(),
                   [](const Saddle& p, const Saddle& q) { return p.height > q.height; });
}

}  // namespace

Fragments cutIntoFragments(const Relief& relief, double resolution) {
  const MapGeometry geometry{relief.free_space.cols, relief.free_space.rows, resolution, {}};
  Fragments fragments;
  fragments.openings.all =
      findOpenings(relief.free_space, Sight(relief.free_space, relief.height, resolution));
  cv::Mat1b closed = relief.free_space.clone();
  const auto doorways = closeOpenings(geometry, fragments.openings, closed);
  Basins basins = findBasins(distanceFromWalls(closed));
  AreaParams params;
  params.merge_ratio = kMergeRatio;
  params.min_prominence = kMinProminence;
  params.min_area_size = kMinSize;
  params.min_area_clearance = 0;
  const auto merged = mergeByPersistence(basins, resolution, params);
  const std::size_t count = basins.basins.size();
  std::vector<std::uint32_t>& labels = fragments.basins.of_pixel;
  labels = std::move(basins.of_pixel);
  const auto relabel = [&](const std::vector<std::uint32_t>& by) {
    for (std::uint32_t& label : labels) {
      if (label != Basins::kNone) label = by[label];
    }
  };
  relabel(merged);
  handOver(doorways, geometry, labels);
  relabel(SmallRegions(labels, count, geometry).join(kMinSize / (resolution * resolution)));
  describeRegions(relief.height, fragments.basins);
  fragments.borders = findBorderPoints(labels, geometry);
  findSaddles(relief.height, fragments.borders, fragments.basins);
  return fragments;
}

}  // namespace agrid
