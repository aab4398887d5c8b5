// SPDX-License-Identifier: BSD-3-Clause
#include "tags/aligned_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <opencv2/core/mat.hpp>

#include "tags/basins.h"
#include "tags/pixel_neighbours.h"

namespace agrid {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kMinTurn = 0.5 * kPi / 180;
constexpr double kResolution = 0.05;  // of the maps that the method was fitted to [m]
constexpr double kMinFree = 0.8;
constexpr std::size_t kSides = 4;  // of kNeighbours; thin walls are open at their corners
constexpr int kRim = 2;            // [px]
constexpr double kNear = 0.15;     // how far tags are moved [m]

/// How much of each square of `factor` by `factor` pixels is free, 255 being all of it.
cv::Mat1b freeShare(const OccupancyMap& map, int factor) {
  const MapGeometry& geometry = map.geometry();
  cv::Mat1b share((geometry.height + factor - 1) / factor, (geometry.width + factor - 1) / factor);
  std::vector<int> count(static_cast<std::size_t>(share.cols));
  for (int y = 0; y < share.rows; ++y) {
    std::fill(count.begin(), count.end(), 0);
    for (int v = y * factor; v < std::min((y + 1) * factor, geometry.height); ++v) {
      const Occupancy* row = map.pixels().data() + geometry.index({0, v});
      for (int u = 0; u < geometry.width; ++u) {
        if (row[u] == Occupancy::kFree) ++count[static_cast<std::size_t>(u / factor)];
      }
    }
    std::transform(count.begin(), count.end(), share[y],
                   [&](int n) { return static_cast<std::uint8_t>(n * 255 / (factor * factor)); });
  }
  return share;
}

/// Between the centres of four pixels, as what lies around a point beyond the image were 0.
double interpolated(const cv::Mat1b& image, const Point2& point) {
  const double x = std::floor(point.x() - 0.5);
  const double y = std::floor(point.y() - 0.5);
  if (!(x >= -1 && y >= -1 && x < image.cols && y < image.rows)) return 0;
  const int left = static_cast<int>(x);
  const int low = static_cast<int>(y);
  const auto at = [&](int u, int v) -> int {
    return u < 0 || v < 0 || u >= image.cols || v >= image.rows ? 0 : image(v, u);
  };
  const int corner = at(left, low);
  const int right_corner = at(left + 1, low);
  const int high_corner = at(left, low + 1);
  const int far_corner = at(left + 1, low + 1);
  const bool is_even = corner == right_corner && corner == high_corner && corner == far_corner;
  if (is_even) return corner;
  const double s = point.x() - 0.5 - x;
  const double t = point.y() - 0.5 - y;
  return (1 - t) * ((1 - s) * corner + s * right_corner) +
         t * ((1 - s) * high_corner + s * far_corner);
}

/// A frame turned by `turn` around the image's origin, cut to what of `share` is not 0; its unit is
/// a pixel of `share`.
struct Frame {
  Point2 origin;  ///< its lower left corner in the image
  int width = 0;
  int height = 0;
};

std::optional<Frame> frameAround(const cv::Mat1b& share, double turn) {
  const Pose2 turned_from_image{Point2::Zero(), -turn};
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Point2 low(kFar, kFar);
  Point2 high(-kFar, -kFar);
  for (int y = 0; y < share.rows; ++y) {
    const std::uint8_t* row = share[y];
    int first = 0;
    int last = share.cols;
    while (first < last && row[first] == 0) ++first;
    while (last > first && row[last - 1] == 0) --last;
    if (first == last) continue;
    for (const Point2& corner :
         {Point2(first, y), Point2(last, y), Point2(first, y + 1), Point2(last, y + 1)}) {
      const Point2 p = turned_from_image * corner;
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  if (low.x() > high.x()) return std::nullopt;
  low -= Point2(kRim, kRim);
  high += Point2(kRim, kRim);
  return Frame{inverse(turned_from_image) * low, static_cast<int>(std::ceil(high.x() - low.x())),
               static_cast<int>(std::ceil(high.y() - low.y()))};
}

/// Which pixels of a frame are free, as occupancy values.
std::vector<std::int8_t> valuesIn(const Frame& frame, double turn, const cv::Mat1b& share) {
  std::vector<std::int8_t> values(static_cast<std::size_t>(frame.width) *
                                  static_cast<std::size_t>(frame.height));
  std::int8_t* value = values.data();
  const Point2 along(std::cos(turn), std::sin(turn));
  const Point2 up(-along.y(), along.x());
  for (int y = 0; y < frame.height; ++y) {
    const Point2 start = frame.origin + 0.5 * along + (y + 0.5) * up;
    for (int x = 0; x < frame.width; ++x) {
      *value++ = interpolated(share, start + x * along) >= kMinFree * 255 ? 0 : 100;
    }
  }
  return values;
}

/// None if the map is as good itself, or nothing is free.
std::optional<OccupancyMap> alignedTo(double walls_yaw, const OccupancyMap& map) {
  const MapGeometry& old = map.geometry();
  const int factor = std::max(1, static_cast<int>(std::lround(kResolution / old.resolution)));
  double turn = std::remainder(walls_yaw - old.map_from_image.yaw, kPi / 2);
  if (std::abs(turn) < kMinTurn) turn = 0;
  if (turn == 0 && factor == 1) return std::nullopt;
  const cv::Mat1b share = freeShare(map, factor);
  const auto frame = frameAround(share, turn);
  if (!frame) return std::nullopt;
  OccupancyGrid view;
  view.geometry = {frame->width, frame->height, old.resolution * factor, {}};
  view.geometry.map_from_image =
      old.map_from_image * Pose2{frame->origin * view.geometry.resolution, turn};
  view.values = valuesIn(*frame, turn, share);
  return OccupancyMap(view);
}

/// Moves a point that is free on the map, but not on the view.
void moveToFree(const OccupancyMap& map, const OccupancyMap& view, Point2& point_map) {
  const auto on_map = map.geometry().pixelAt(point_map);
  const auto on_view = view.geometry().pixelAt(point_map);
  if (!on_map || !on_view || !map.isFree(*on_map) || view.isFree(*on_view)) return;
  const double reach = std::max(kNear, 2 * view.geometry().resolution);
  const int steps = static_cast<int>(std::ceil(reach / view.geometry().resolution));
  double nearest = reach;
  const Point2 from = point_map;
  for (int dy = -steps; dy <= steps; ++dy) {
    for (int dx = -steps; dx <= steps; ++dx) {
      const Pixel p{on_view->x + dx, on_view->y + dy};
      if (!view.geometry().contains(p) || !view.isFree(p)) continue;
      const Point2 center = view.geometry().center(p);
      if ((center - from).norm() >= nearest) continue;
      nearest = (center - from).norm();
      point_map = center;
    }
  }
}

std::uint32_t labelBeside(std::size_t i, const MapGeometry& geometry,
                          const std::vector<std::uint32_t>& labels) {
  for (std::size_t side = 0; side < kSides; ++side) {
    const Pixel q = geometry.pixel(i) + kNeighbours[side];
    if (geometry.contains(q) && labels[geometry.index(q)] != Basins::kNone) {
      return labels[geometry.index(q)];
    }
  }
  return Basins::kNone;
}

/// Lets labels grow over free pixels that have none, all by one pixel at a time.
void growOverFree(const OccupancyMap& map, std::vector<std::uint32_t>& labels) {
  const MapGeometry& geometry = map.geometry();
  const auto isOpen = [&](std::size_t i) {
    return labels[i] == Basins::kNone && map.pixels()[i] == Occupancy::kFree;
  };
  std::vector<std::pair<std::size_t, std::uint32_t>> front;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!isOpen(i)) continue;
    const std::uint32_t label = labelBeside(i, geometry, labels);
    if (label != Basins::kNone) front.emplace_back(i, label);
  }
  std::vector<std::size_t> reached;
  while (!front.empty()) {
    for (const auto& [i, label] : front) labels[i] = label;
    reached.clear();
    for (const auto& entry : front) {
      for (std::size_t side = 0; side < kSides; ++side) {
        const Pixel q = geometry.pixel(entry.first) + kNeighbours[side];
        if (geometry.contains(q) && isOpen(geometry.index(q))) reached.push_back(geometry.index(q));
      }
    }
    std::sort(reached.begin(), reached.end());
    reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
    front.clear();
    for (const std::size_t i : reached) front.emplace_back(i, labelBeside(i, geometry, labels));
  }
}

}  // namespace

AlignedView::AlignedView(const OccupancyMap& map, const AreaParams& params, double walls_yaw)
    : map_(map) {
  if (params.method == AreaMethod::kBorders) view_ = alignedTo(walls_yaw, map);
}

std::vector<Tag> AlignedView::tagsOnView(const std::vector<Tag>& tags) const {
  std::vector<Tag> moved = tags;
  if (!view_) return moved;
  for (Tag& tag : moved) {
    if (auto* area = std::get_if<AreaTag>(&tag)) moveToFree(map_, *view_, area->seed_map);
    if (auto* door = std::get_if<DoorTag>(&tag)) moveToFree(map_, *view_, door->pose_map.position);
  }
  return moved;
}

std::vector<std::uint32_t> AlignedView::labelsOnMap(
    const std::vector<std::uint32_t>& labels) const {
  const MapGeometry& geometry = map_.geometry();
  const MapGeometry& view = this->geometry();
  std::vector<std::uint32_t> on_map(geometry.pixelCount(), Basins::kNone);
  const Pose2 view_from_map = inverse(view.map_from_image) * geometry.map_from_image;
  const double scale = geometry.resolution / view.resolution;
  const Point2 along = scale * Point2(std::cos(view_from_map.yaw), std::sin(view_from_map.yaw));
  const Point2 up(-along.y(), along.x());
  const Point2 origin = view_from_map.position / view.resolution;
  for (int y = 0; y < geometry.height; ++y) {
    std::uint32_t* row = on_map.data() + geometry.index({0, y});
    const Point2 start = origin + 0.5 * along + (y + 0.5) * up;
    for (int x = 0; x < geometry.width; ++x) {
      const Point2 p = start + x * along;
      if (!(p.x() >= 0 && p.y() >= 0 && p.x() < view.width && p.y() < view.height)) continue;
      row[x] = labels[view.index({static_cast<int>(p.x()), static_cast<int>(p.y())})];
    }
  }
  growOverFree(map_, on_map);
  return on_map;
}

}  // namespace agrid
