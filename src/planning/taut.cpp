// SPDX-License-Identifier: BSD-3-Clause
#include "planning/taut.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace agrid::planning {
namespace {

/// Twice the signed area of a triangle: positive if c lies to the left of the line from a to b.
std::int64_t turn(FinePoint a, FinePoint b, FinePoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

int signOf(std::int64_t value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// Whether a shortest path from `before` to `after` can bend at `corner`: it wraps the obstacle.
bool wraps(FinePoint before, const RoadCorner& corner, FinePoint after) {
  if (corner.blocked_x == 0) return false;
  const int side = signOf(turn(before, corner.at, after));
  const FinePoint obstacle{corner.at.x + corner.blocked_x, corner.at.y + corner.blocked_y};
  return side != 0 && side * turn(before, corner.at, obstacle) >= 0 &&
         side * turn(corner.at, after, obstacle) >= 0;
}

class TautPath {
 public:
  TautPath(const FreeSpace& free, const Roadmap& roadmap, Road& road)
      : free_(free), roadmap_(roadmap), road_(road), corners_(road.corners) {}

  bool pull() {
    bool all = true;
    for (std::size_t i = 1; i + 1 < corners_.size();) {
      if (wraps(corners_[i - 1].at, corners_[i], corners_[i + 1].at)) {
        ++i;
      } else if (cutCorner(i)) {
        // The corner before may have become one that the path need not bend at.
        i = i > 1 ? i - 1 : 1;
      } else {
        all = false;
        ++i;
      }
    }
    return all;
  }

 private:
  /// Replaces corner i by the turning points inside the triangle with its neighbours that the
  /// shortest path wraps: the hull of those points.
  bool cutCorner(std::size_t i) {
    const RoadCorner& before = corners_[i - 1];
    const RoadCorner& after = corners_[i + 1];
    std::vector<RoadCorner> chain;
    if (!free_.canSee(before.at, after.at)) {
      chain =
          hull(before.at, corners_[i].at, after.at, pointsInside(before.at, corners_[i], after));
      if (chain.empty() || !inSight(before.at, chain, after.at)) return false;
    }
    const std::uint32_t first = corners_[i].first_region;
    const std::uint32_t last = corners_[i + 1].last_region;
    for (RoadCorner& corner : chain) {
      corner.first_region = first;
      corner.last_region = last;
    }
    corners_[i + 1].first_region = first;
    const auto place = corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(i));
    corners_.insert(place, chain.begin(), chain.end());
    return true;
  }

  std::vector<RoadCorner> pointsInside(FinePoint before, const RoadCorner& corner,
                                       const RoadCorner& after) const {
    const int side = signOf(turn(before, corner.at, after.at));
    std::vector<RoadCorner> inside;
    for (std::uint32_t r = corner.first_region; r <= after.last_region; ++r) {
      for (const TurningPoint& point : roadmap_.roads(road_.regions[r]).points()) {
        const FinePoint p = point.at;
        if (side * turn(before, corner.at, p) < 0 || side * turn(corner.at, after.at, p) < 0 ||
            side * turn(after.at, before, p) < 0 || p == before || p == after.at ||
            p == corner.at) {
          continue;
        }
        inside.push_back({p, point.blocked_x, point.blocked_y, 0, 0});
      }
    }
    return inside;
  }

  /// From a to b around the points, on the corner's side (Jarvis 1973).
  static std::vector<RoadCorner> hull(FinePoint a, FinePoint corner, FinePoint b,
                                      const std::vector<RoadCorner>& points) {
    const int side = signOf(turn(a, corner, b));
    std::vector<RoadCorner> chain;
    for (FinePoint here = a; chain.size() <= points.size();) {
      RoadCorner next;
      next.at = b;
      for (const RoadCorner& point : points) {
        const std::int64_t left = side * turn(here, next.at, point.at);
        if (point.at == here || left > 0) continue;
        const bool farther = distancePx(here, point.at) > distancePx(here, next.at);
        if (left < 0 || (farther && !(next.at == b))) next = point;
      }
      if (next.at == b) return chain;
      chain.push_back(next);
      here = next.at;
    }
    return {};
  }

  bool inSight(FinePoint from, const std::vector<RoadCorner>& chain, FinePoint to) const {
    for (const RoadCorner& corner : chain) {
      if (!free_.canSee(from, corner.at)) return false;
      from = corner.at;
    }
    return free_.canSee(from, to);
  }

  const FreeSpace& free_;
  const Roadmap& roadmap_;
  Road& road_;
  std::vector<RoadCorner>& corners_;
};

}  // namespace

bool pullTaut(const FreeSpace& free, const Roadmap& roadmap, Road& road) {
  return TautPath(free, roadmap, road).pull();
}

}  // namespace agrid::planning
