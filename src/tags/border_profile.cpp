// SPDX-License-Identifier: BSD-3-Clause
#include "tags/border_profile.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "tags/narrowing.h"

namespace agrid {
namespace {

constexpr double kWallReach = 4;    // [m]
constexpr double kLineReach = 8;    // [m]
constexpr double kWidthReach = 5;   // to either side [m]
constexpr double kDepthReach = 15;  // [m]
constexpr double kAround = 0.5;     // [m]

/// Along the border; where the jambs touch, along the stretch's ends.
Point2 directionOf(const Segment& jambs, const Stretch& stretch, const MapGeometry& geometry) {
  Point2 way = jambs.b - jambs.a;
  if (way.norm() < 1) way = stretch.back().position(geometry) - stretch.front().position(geometry);
  return way.norm() < 0.5 ? Point2(1, 0) : Point2(way.normalized());
}

}  // namespace

BorderSurvey::BorderSurvey(const Relief& relief, const Openings& openings,
                           const MapGeometry& geometry)
    : relief_(relief),
      openings_(openings),
      geometry_(geometry),
      sight_(relief.free_space, relief.height, geometry.resolution) {}

BorderProfile BorderSurvey::profileOf(const Stretch& stretch,
                                      const std::vector<std::uint32_t>& labels) const {
  BorderProfile profile;
  profile.jambs_px = jambsOf(stretch, profile);
  profile.width = sight_.metres(profile.jambs_px.length());
  profile.extent = sight_.metres(extentOf(stretch, geometry_));
  const Point2 direction = directionOf(profile.jambs_px, stretch, geometry_);
  lookAlong(direction, profile);
  profile.walls_at_jambs = wallsAround(profile.jambs_px);
  Point2 normal(-direction.y(), direction.x());
  double towards_b = 0;
  for (const BorderPoint& point : stretch) {
    const Pixel p = geometry_.pixel(point.pixel);
    const Pixel q = geometry_.pixel(point.other);
    const double step = Point2(q.x - p.x, q.y - p.y).dot(normal);
    towards_b += labels[point.pixel] == point.a ? step : -step;
  }
  if (towards_b < 0) normal = -normal;
  profile.sides = {lookAcross(profile, direction, -normal), lookAcross(profile, direction, normal)};
  return profile;
}

float BorderSurvey::heightAt(const BorderPoint& point) const {
  return heights()[point.lower(heights())];
}

/// Those of the opening that most of the stretch lies on, else of the narrowing at its place
/// farthest from the walls.
Segment BorderSurvey::jambsOf(const Stretch& stretch, BorderProfile& profile) const {
  std::map<std::uint32_t, std::size_t> on_opening;
  std::size_t elsewhere = 0;
  const BorderPoint* farthest = &stretch.front();
  for (const BorderPoint& point : stretch) {
    auto opening = openings_.at_pixel.find(point.pixel);
    if (opening == openings_.at_pixel.end()) opening = openings_.at_pixel.find(point.other);
    ++(opening == openings_.at_pixel.end() ? elsewhere : on_opening[opening->second]);
    if (heightAt(point) > heightAt(*farthest)) farthest = &point;
  }
  profile.clearance = sight_.metres(static_cast<double>(heightAt(*farthest)));
  const auto most = std::max_element(on_opening.begin(), on_opening.end(),
                                     [](auto& a, auto& b) { return a.second < b.second; });
  profile.is_opening = most != on_opening.end() && most->second >= elsewhere;
  if (profile.is_opening) return openings_.all[most->first].jambs;
  return findNarrowing(geometry_.pixel(farthest->lower(heights())), relief_.height);
}

bool BorderSurvey::isOpeningAlong(const Point2& point, const Point2& direction) const {
  constexpr double kMaxSine = 0.17;  // 10 degrees
  const Point2 normal(-direction.y(), direction.x());
  const double beside = std::max(1., sight_.pixels(0.15));
  for (double aside = -beside; aside <= beside; aside += 1) {
    const Point2 place = point + normal * aside;
    const Pixel pixel{static_cast<int>(std::floor(place.x())),
                      static_cast<int>(std::floor(place.y()))};
    if (!geometry_.contains(pixel)) continue;
    const auto opening = openings_.at_pixel.find(geometry_.index(pixel));
    if (opening == openings_.at_pixel.end()) continue;
    const Segment& jambs = openings_.all[opening->second].jambs;
    if (std::abs((jambs.b - jambs.a).dot(normal)) <= kMaxSine * jambs.length()) return true;
  }
  return false;
}

double BorderSurvey::lineRun(const Point2& jamb, const Point2& outward) const {
  const double reach = sight_.pixels(kLineReach);
  const Point2 start = jamb + outward * 0.25;
  double run = 0;
  while (run < reach && (sight_.isWallBeside(start, outward, run) ||
                         isOpeningAlong(start + outward * run, outward))) {
    run += 1;
  }
  return std::min(run, reach);
}

void BorderSurvey::lookAlong(const Point2& direction, BorderProfile& profile) const {
  const Segment& jambs = profile.jambs_px;
  const double half = jambs.length() / 2;
  for (std::size_t end = 0; end < 2; ++end) {
    const Point2 outward = end == 0 ? Point2(-direction) : direction;
    const Point2& jamb = end == 0 ? jambs.a : jambs.b;
    profile.wall_runs[end] =
        sight_.metres(sight_.wallRun(jamb + outward * 0.25, outward, sight_.pixels(kWallReach)));
    profile.line_runs[end] = sight_.metres(lineRun(jamb, outward));
    profile.is_flat[end] = sight_.endOf(jambs.midpoint(), outward, half).is_flat;
  }
}

SideProfile BorderSurvey::lookAcross(const BorderProfile& profile, const Point2& direction,
                                     const Point2& normal) const {
  constexpr double kRounding = 0.6;  // [px]
  const Point2 middle = profile.jambs_px.midpoint();
  const double depth = sight_.freeRun(middle, normal, sight_.pixels(kDepthReach));
  const double reach = sight_.pixels(kWidthReach);
  SideProfile side;
  side.depth = sight_.metres(depth);
  for (std::size_t i = 0; i < side.widths.size(); ++i) {
    const double distance = sight_.pixels(SideProfile::kDistances[i]);
    const Point2 place = middle + normal * distance;
    if (depth < distance - kRounding || sight_.isWall(place)) continue;
    side.widths[i] = sight_.metres(sight_.freeRun(place, direction, reach) +
                                   sight_.freeRun(place, -direction, reach));
  }
  return side;
}

double BorderSurvey::wallsAround(const Segment& jambs) const {
  const double reach = sight_.pixels(kAround);
  int walls = 0;
  int all = 0;
  for (const Point2& jamb : {jambs.a, jambs.b}) {
    for (double y = -reach; y <= reach; ++y) {
      for (double x = -reach; x <= reach; ++x) {
        if (x * x + y * y > reach * reach) continue;
        ++all;
        if (sight_.isWall(jamb + Point2(x, y))) ++walls;
      }
    }
  }
  return static_cast<double>(walls) / all;
}

}  // namespace agrid
