// SPDX-License-Identifier: BSD-3-Clause
#include "tags/openings.h"

#include <algorithm>

#include "tags/near_points.h"

namespace agrid {
namespace {

constexpr double kSameJamb = 0.5;  // [m]
constexpr double kTouch = 0.2;     // ends may cross by this much [m]
constexpr double kReach = 4;       // no opening is longer [m]
constexpr double kCoarsest = 0.2;  // [m]

double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

bool intersect(const Segment& p, const Segment& q) {
  const auto parts = [](const Segment& line, const Segment& points) {
    const Point2 way = line.b - line.a;
    return cross(way, points.a - line.a) * cross(way, points.b - line.a) < 0;
  };
  return parts(p, q) && parts(q, p);
}

Segment shortened(const Segment& segment, double by) {
  const double length = segment.length();
  const Point2 step = (segment.b - segment.a) / length * std::min(by, 0.3 * length);
  return {segment.a + step, segment.b - step};
}

bool excludeEachOther(const Segment& p, const Segment& q, const Sight& sight) {
  const double straight = std::max((p.a - q.a).norm(), (p.b - q.b).norm());
  const double crosswise = std::max((p.a - q.b).norm(), (p.b - q.a).norm());
  if (std::min(straight, crosswise) < sight.pixels(kSameJamb)) return true;
  const double touch = sight.pixels(kTouch);
  return intersect(shortened(p, touch), shortened(q, touch));
}

}  // namespace

std::vector<Opening> findOpenings(const cv::Mat1b& free_space, const Sight& sight) {
  if (sight.metres(1) > kCoarsest) return {};
  const auto corners = findWallCorners(free_space, sight.metres(1));
  const WallDirections walls(corners, sight.metres(1));
  std::vector<Opening> found = findWallGaps(corners, walls, sight);
  const auto mouths = findMouths(corners, walls, sight);
  found.insert(found.end(), mouths.begin(), mouths.end());
  std::stable_sort(found.begin(), found.end(),
                   [](const Opening& a, const Opening& b) { return a.merit > b.merit; });
  NearPoints near(sight.pixels(kReach));
  std::vector<Opening> kept;
  for (const Opening& opening : found) {
    bool is_excluded = false;
    near.forEachNear(opening.jambs.midpoint(), [&](std::size_t i) {
      is_excluded = is_excluded || excludeEachOther(opening.jambs, kept[i].jambs, sight);
    });
    if (is_excluded) continue;
    near.add(opening.jambs.midpoint(), kept.size());
    kept.push_back(opening);
  }
  return kept;
}

}  // namespace agrid
