// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>

#include "tags/openings.h"

namespace agrid {
namespace {

// lengths in metres
constexpr double kMinWidth = 0.4;
constexpr double kMaxWidth = 4;
constexpr double kMaxWall = 4;     // how far walls beyond the jambs are followed
constexpr double kMinWall = 0.25;  // on either side ...
constexpr double kMinShortWall = 0.2;
constexpr double kMinWallShare = 0.5;  // ... and in sum, of the gap's width
constexpr double kLongWall = 0.8;      // enough on its own
constexpr double kSurroundings = 2.5;
constexpr double kMinShareAround = 0.8;  // sum of both sides
constexpr double kMinArm = 0.2;          // shorter walls have no direction
constexpr double kMinArmPx = 3;
constexpr double kMaxDepth = 0.16;
constexpr double kMaxSlope = 0.5;
constexpr double kMinTurn = 0.5;     // [rad]
constexpr double kMinTipTurn = 2.2;  // both sides of a thin wall run back along each other [rad]

/// The end of a wall, from which its line goes on into free space.
struct WallEnd {
  Point2 corner;
  Point2 direction;  ///< away from the wall
  Point2 into_wall;  ///< across the direction, from free space towards the wall
  bool is_tip;       ///< of a wall so thin that the corner lies ahead of it, not beside it
};

std::optional<WallEnd> wallEnd(const WallCorner& corner, int arm, const WallDirections& walls,
                               const Sight& sight) {
  const Point2& along = corner.arms[static_cast<std::size_t>(arm)];
  const Point2& other = corner.arms[static_cast<std::size_t>(1 - arm)];
  const double length = along.norm();
  if (sight.metres(length) < kMinArm || length < kMinArmPx) return std::nullopt;
  const Point2 direction = -along / length;
  const Point2 normal(-direction.y(), direction.x());
  const Point2 on_wall = corner.point - direction * std::min(3., length / 2);
  int balance = 0;
  for (double aside = 1; aside <= 3; ++aside) {
    balance += sight.isWall(on_wall + normal * aside) ? 1 : 0;
    balance -= sight.isWall(on_wall - normal * aside) ? 1 : 0;
  }
  const auto aligned = walls.align(along);
  if (!aligned) return std::nullopt;
  const Point2 into_wall = balance < 0 ? Point2(-normal) : normal;
  const Point2 behind = corner.point + *aligned * 1.5;
  const bool is_tip = sight.isWall(behind) && (balance == 0 || !sight.isWall(behind + into_wall));
  if (balance == 0 && !is_tip) return std::nullopt;
  const double bend =
      std::atan2(direction.x() * other.y() - direction.y() * other.x(), direction.dot(other));
  const double turn = is_tip ? std::abs(bend) : balance < 0 ? -bend : bend;
  if (turn < (is_tip ? kMinTipTurn : kMinTurn)) return std::nullopt;
  return WallEnd{corner.point, -*aligned, into_wall, is_tip};
}

/// Whether the line of a gap has enough wall on it.
bool isSupported(const Opening& gap, const Point2& direction, const Sight& sight) {
  const double width = sight.metres(gap.jambs.length());
  const double before = sight.metres(gap.wall_before);
  const double beyond = sight.metres(gap.wall_beyond);
  const Sight::End end = sight.endOf(gap.jambs.a, direction, gap.jambs.length());
  if (end.slope > kMaxSlope) return false;
  // of a wall that runs across the line, its thickness says nothing
  const double beyond_on_line = end.is_flat ? std::min(beyond, kMinWall) : beyond;
  if (before >= kMinWall && beyond_on_line >= kMinShortWall &&
      before + beyond_on_line >= kMinWallShare * width) {
    return true;
  }
  if (before >= kLongWall && gap.wall_beyond >= 1) return true;
  if (end.is_flat || std::min(before, beyond) < kMinShortWall) return false;
  const double around = sight.pixels(kSurroundings);
  return sight.wallShare(gap.jambs.a - direction * 0.75, -direction, around) +
             sight.wallShare(gap.jambs.b + direction * 0.25, direction, around) >=
         kMinShareAround;
}

/// The gap that begins where the wall ends, the line being led `depth` pixels inside the wall.
std::optional<Opening> gapFrom(const WallEnd& end, double depth, const Sight& sight) {
  constexpr double kMaxTip = 4;  // a wall's last pixels may lie ahead of its corner
  const Point2& direction = end.direction;
  Point2 start = end.corner + end.into_wall * depth - direction * (end.is_tip ? 1 : 0);
  double tip = 0;
  while (tip < kMaxTip && sight.isWall(start + direction * tip)) tip += 0.5;
  if (tip >= kMaxTip) return std::nullopt;
  start += direction * tip;
  const double max_width = sight.pixels(kMaxWidth);
  const double width = sight.freeRun(start, direction, max_width + 1);
  if (width < sight.pixels(kMinWidth) || width > max_width) return std::nullopt;
  const double reach = sight.pixels(kMaxWall);
  Opening gap;
  gap.jambs = {start, start + direction * width};
  gap.wall_before = sight.wallRun(start - direction * 0.75, -direction, reach);
  gap.wall_beyond = sight.wallRun(gap.jambs.b + direction * 0.25, direction, reach);
  if (!isSupported(gap, direction, sight)) return std::nullopt;
  gap.merit = std::min(sight.metres(gap.wall_before), 1.) +
              std::min(sight.metres(gap.wall_beyond), 1.) - sight.metres(width) / 2;
  return gap;
}

}  // namespace

std::vector<Opening> findWallGaps(const std::vector<WallCorner>& corners,
                                  const WallDirections& walls, const Sight& sight) {
  std::vector<Opening> gaps;
  for (const WallCorner& corner : corners) {
    for (int arm = 0; arm < 2; ++arm) {
      const auto end = wallEnd(corner, arm, walls, sight);
      if (!end) continue;
      std::optional<Opening> narrowest;
      const double deepest = end->is_tip ? 0 : 3;
      for (double depth = end->is_tip ? 0 : 1; depth <= deepest; ++depth) {
        if (depth > 1 && sight.metres(depth) > kMaxDepth) break;
        const auto gap = gapFrom(*end, depth, sight);
        if (gap && (!narrowest || gap->jambs.length() < narrowest->jambs.length())) narrowest = gap;
      }
      if (narrowest) gaps.push_back(*narrowest);
    }
  }
  return gaps;
}

}  // namespace agrid
