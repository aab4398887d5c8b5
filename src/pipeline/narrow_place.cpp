// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/narrow_place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "tags/free_space.h"
#include "tags/pixel_line.h"

namespace agrid {
namespace {

constexpr double kUsualWidth = 0.7;    // narrower doors are meant no more often than this one [m]
constexpr double kLeastWidth = 0.3;    // nobody goes through [m]
constexpr double kThickestWall = 0.6;  // a longer way between two walls is a corridor [m]
constexpr double kAlike = 0.95;        // directions within 18 degrees
constexpr double kRim = 1.5;  // how much farther than the nearest wall the opposite one may be [px]

/// Two wall pixels that face each other, in pixels of the window.
struct Gap {
  Point2 middle = Point2::Zero();
  Point2 along = Point2::Zero();  ///< unit vector from one to the other
  double width = 0;               ///< between their surfaces
  double cost = 0;
};

/// The map around a point.
struct Window {
  Pixel corner;  ///< of the map, at the window's (0, 0)
  cv::Mat1b free_space;
  cv::Mat1f height;  ///< distance from walls [px]

  bool isWall(Pixel p) const {
    return p.x < 0 || p.y < 0 || p.x >= free_space.cols || p.y >= free_space.rows ||
           free_space(p.y, p.x) == 0;
  }
};

Window cutWindow(const OccupancyMap& map, const NarrowPlaceQuery& query, const Point2& near_px) {
  const MapGeometry& geometry = map.geometry();
  const double reach = query.reach + query.max_width / 2 + query.max_clutter_diagonal;
  const double reach_px = std::ceil(reach / geometry.resolution) + 3;
  const auto low = [&](double v) { return static_cast<int>(std::max(0., v - reach_px)); };
  const auto high = [&](double v, int end) {
    return static_cast<int>(std::min<double>(end, v + reach_px));
  };
  Window window;
  window.corner = {low(near_px.x()), low(near_px.y())};
  OccupancyGrid grid;
  grid.geometry = {high(near_px.x(), geometry.width) - window.corner.x,
                   high(near_px.y(), geometry.height) - window.corner.y,
                   geometry.resolution,
                   {}};
  grid.values.reserve(grid.geometry.pixelCount());
  for (int y = 0; y < grid.geometry.height; ++y) {
    for (int x = 0; x < grid.geometry.width; ++x) {
      const bool free = map.isFree({window.corner.x + x, window.corner.y + y});
      grid.values.push_back(free ? 0 : 100);
    }
  }
  AreaParams cleaning;
  cleaning.max_clutter_diagonal = query.max_clutter_diagonal;
  window.free_space = cleanFreeSpace(OccupancyMap(grid), cleaning);
  window.height = distanceFromWalls(window.free_space);
  return window;
}

class GapSearch {
 public:
  GapSearch(const Window& window, const NarrowPlaceQuery& query, const Point2& near_px,
            double resolution, double image_yaw)
      : window_(window),
        query_(query),
        near_(near_px),
        resolution_(resolution),
        image_yaw_(image_yaw) {}

  std::optional<Gap> find() {
    const double reach = query_.reach / resolution_ + 1;
    const int top = std::min(window_.free_space.rows, static_cast<int>(near_.y() + reach) + 1);
    const int right = std::min(window_.free_space.cols, static_cast<int>(near_.x() + reach) + 1);
    for (int y = std::max(0, static_cast<int>(near_.y() - reach)); y < top; ++y) {
      for (int x = std::max(0, static_cast<int>(near_.x() - reach)); x < right; ++x) {
        if (isBetweenWalls({x, y})) addGapsAround({x, y});
      }
    }
    const Gap* best = nullptr;
    for (const Gap& gap : gaps_) {
      if ((!best || gap.cost < best->cost - 1e-9) && leadsAsAsked(gap)) best = &gap;
    }
    if (!best) return std::nullopt;
    const Gap gap = centered(averaged(*best));
    return (gap.middle - near_).norm() * resolution_ <= query_.reach ? gap : *best;
  }

 private:
  double heightAt(Pixel p) const {
    return window_.isWall(p) ? 0 : static_cast<double>(window_.height(p.y, p.x));
  }

  /// Whether walls come nearer on both sides, whichever way across.
  bool isBetweenWalls(Pixel p) const {
    const double height = heightAt(p);
    if (height == 0 || (2 * height - 2) * resolution_ > query_.max_width) return false;
    for (const Pixel step : std::array<Pixel, 4>{{{2, 0}, {0, 2}, {2, 2}, {2, -2}}}) {
      if (heightAt({p.x + step.x, p.y + step.y}) <= height - 0.5 &&
          heightAt({p.x - step.x, p.y - step.y}) <= height - 0.5) {
        return true;
      }
    }
    return false;
  }

  /// Wall pixels about as near as the nearest one, relative to a pixel.
  std::vector<Point2> nearestWalls(Pixel p) const {
    const double inner = heightAt(p);
    const double outer = inner + kRim;
    std::vector<Point2> walls;
    for (int dy = -static_cast<int>(outer); dy <= outer; ++dy) {
      const double inner_x = std::sqrt(std::max(0., inner * inner - dy * dy));
      const double outer_x = std::sqrt(outer * outer - dy * dy);
      for (int dx = static_cast<int>(inner_x); dx <= outer_x; ++dx) {
        if (window_.isWall({p.x + dx, p.y + dy})) walls.emplace_back(dx, dy);
        if (dx > 0 && window_.isWall({p.x - dx, p.y + dy})) walls.emplace_back(-dx, dy);
      }
    }
    return walls;
  }

  /// The pairs of walls whose middle lies in a pixel and that no other wall is between.
  void addGapsAround(Pixel p) {
    const std::vector<Point2> walls = nearestWalls(p);
    for (std::size_t i = 0; i < walls.size(); ++i) {
      for (std::size_t j = i + 1; j < walls.size(); ++j) {
        const Point2 middle = (walls[i] + walls[j]) / 2;
        if (middle.cwiseAbs().maxCoeff() > 0.5) continue;
        const double squared = (walls[j] - walls[i]).squaredNorm() / 4 - 1e-9;
        const bool is_clear = std::all_of(walls.begin(), walls.end(), [&](const Point2& wall) {
          return (wall - middle).squaredNorm() >= squared;
        });
        if (is_clear) addGap(Point2(p.x + 0.5, p.y + 0.5) + middle, walls[j] - walls[i]);
      }
    }
  }

  void addGap(const Point2& middle, const Point2& way) {
    Gap gap;
    gap.middle = middle;
    gap.along = way.normalized();
    gap.width = way.norm() - 1 / gap.along.cwiseAbs().maxCoeff();
    const double distance = (middle - near_).norm() * resolution_;
    gap.cost = costOfPlace(gap.width * resolution_, distance);
    if (distance <= query_.reach && fits(gap.width * resolution_)) gaps_.push_back(gap);
  }

  bool fits(double width) const {
    return width >= kLeastWidth - 1e-9 && width <= query_.max_width + 1e-9;
  }

  bool leadsAsAsked(const Gap& gap) const {
    if (!query_.yaw) return true;
    const double asked = *query_.yaw - image_yaw_;
    const Point2 direction(std::cos(asked), std::sin(asked));
    return std::abs(gap.along.dot(direction)) <= std::sqrt(0.5) + 1e-9;
  }

  /// How far it is from a point to the first wall, at most `limit`.
  double run(const Point2& from, const Point2& direction, double limit) const {
    double length = 0;
    walkPixels(from, direction, [&](Pixel p, double entered) {
      length = std::min(entered, limit);
      return !window_.isWall(p) && entered < limit;
    });
    return length;
  }

  /// Pixels make the direction of a single pair of them uncertain: that of all the pairs in the
  /// thickness of the wall is better.
  Gap averaged(const Gap& gap) const {
    Point2 along = Point2::Zero();
    for (const Gap& other : gaps_) {
      const Point2 offset = other.middle - gap.middle;
      if (offset.norm() * resolution_ > kThickestWall / 2) continue;
      const double cosine = other.along.dot(gap.along);
      if (std::abs(cosine) < kAlike || other.width > gap.width + kRim) continue;
      if (std::abs(offset.dot(gap.along)) > kRim) continue;
      along += other.along * (cosine < 0 ? -1 : 1);
    }
    Gap better = gap;
    better.along = along.normalized();
    return leadsAsAsked(better) ? better : gap;
  }

  /// How far a way between two walls goes on in a direction, at most as far as a wall is thick.
  double goesOn(const Gap& gap, const Point2& direction) const {
    const double limit = kThickestWall / resolution_;
    const double half = gap.width / 2 + 2 * kRim;
    double length = 0;
    for (; length <= limit; ++length) {
      const Point2 middle = gap.middle + direction * (length + 1);
      const double left = run(middle, gap.along, half);
      const double right = run(middle, -gap.along, half);
      if (std::max(left, right) >= half || std::abs(left + right - gap.width) > 2) break;
    }
    return length;
  }

  Gap centered(Gap gap) const {
    const Point2 through(-gap.along.y(), gap.along.x());
    const double before = goesOn(gap, -through);
    const double behind = goesOn(gap, through);
    const double limit = kThickestWall / resolution_;
    if (before <= limit && behind <= limit) gap.middle += through * ((behind - before) / 2);
    const double half = gap.width / 2 + 2 * kRim;
    const double left = run(gap.middle, gap.along, half);
    const double right = run(gap.middle, -gap.along, half);
    gap.middle += gap.along * ((left - right) / 2);
    gap.width = left + right;
    return gap;
  }

  const Window& window_;
  const NarrowPlaceQuery& query_;
  Point2 near_;
  double resolution_;
  double image_yaw_;
  std::vector<Gap> gaps_;  ///< in any direction
};

}  // namespace

double costOfPlace(double width, double distance) {
  return std::max(width, kUsualWidth) + distance / 2;
}

std::optional<NarrowPlace> findNarrowPlace(const OccupancyMap& map, const NarrowPlaceQuery& query) {
  const MapGeometry& geometry = map.geometry();
  const double resolution = geometry.resolution;
  const Point2 near_px = inverse(geometry.map_from_image) * query.near_map / resolution;
  const Window window = cutWindow(map, query, near_px);
  const Point2 corner(window.corner.x, window.corner.y);
  GapSearch search(window, query, near_px - corner, resolution, geometry.map_from_image.yaw);
  const auto gap = search.find();
  if (!gap) return std::nullopt;
  NarrowPlace place;
  place.pose_map.position = geometry.map_from_image * Point2((gap->middle + corner) * resolution);
  place.pose_map.yaw = std::atan2(gap->along.x(), -gap->along.y()) + geometry.map_from_image.yaw;
  const double turned = query.yaw ? std::cos(place.pose_map.yaw - *query.yaw) : 1;
  if (turned < 0) place.pose_map.yaw += M_PI;
  place.pose_map.yaw = std::remainder(place.pose_map.yaw, 2 * M_PI);
  place.width = gap->width * resolution;
  place.distance = (place.pose_map.position - query.near_map).norm();
  return place;
}

}  // namespace agrid
