// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/planning/costmap_areas.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "planning/door_pixels.h"
#include "planning/fine_point.h"

namespace agrid {
namespace {

/// Where the row through a height crosses a polygon's sides, sorted [px].
std::vector<double> crossings(const std::vector<Point2>& corners, double y) {
  std::vector<double> places;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2& a = corners[i];
    const Point2& b = corners[(i + 1) % corners.size()];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    places.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  std::sort(places.begin(), places.end());
  return places;
}

/// Visits the pixels whose centres lie in a polygon, a row's run [from, to) at a time.
template <typename Visit>
void visitRuns(const Polygon& outline, const MapGeometry& geometry, const Visit& visit) {
  std::vector<Point2> corners;
  double low = geometry.height;
  double high = -1;
  for (const Point2& corner : outline) {
    if (!corner.allFinite()) return;
    corners.push_back(planning::pixelCoordinates(geometry, corner));
    low = std::min(low, corners.back().y());
    high = std::max(high, corners.back().y());
  }
  const auto inside = [&](double x) {
    return static_cast<int>(std::clamp(std::ceil(x), 0.0, static_cast<double>(geometry.width)));
  };
  const int first = static_cast<int>(std::max(0.0, std::ceil(low)));
  const int last = static_cast<int>(std::min(geometry.height - 1.0, std::floor(high)));
  for (int y = first; y <= last; ++y) {
    const std::vector<double> places = crossings(corners, y);
    for (std::size_t i = 1; i < places.size(); i += 2) {
      visit(y, inside(places[i - 1]), inside(places[i]));
    }
  }
}

std::uint8_t costOf(double factor, const CostRules& rules) {
  if (std::isinf(factor)) return kLethal;
  if (!(rules.cost_factor > 0)) return 0;
  const double cost = std::round((factor - 1) * rules.neutral_cost / rules.cost_factor);
  return static_cast<std::uint8_t>(
      std::clamp(cost, 0.0, static_cast<double>(CostmapAreas::kDearest)));
}

bool holds(const Polygon& outline, const Point2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point2& a = outline[i];
    const Point2& b = outline[(i + 1) % outline.size()];
    if ((a.y() <= p.y()) == (b.y() <= p.y())) continue;
    if (a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) > p.x()) inside = !inside;
  }
  return inside;
}

double distanceTo(const Segment& segment, const Point2& p) {
  const Point2 along = segment.b - segment.a;
  const double square = along.squaredNorm();
  const double t = square > 0 ? std::clamp((p - segment.a).dot(along) / square, 0.0, 1.0) : 0;
  return (segment.a + t * along - p).norm();
}

}  // namespace

bool operator==(const AreaCost& a, const AreaCost& b) {
  return a.outline == b.outline && a.size == b.size && a.factor == b.factor;
}

bool operator==(const AreaCosts& a, const AreaCosts& b) {
  return a.areas == b.areas &&
         std::equal(a.closed_doors.begin(), a.closed_doors.end(), b.closed_doors.begin(),
                    b.closed_doors.end(),
                    [](const Segment& x, const Segment& y) { return x.a == y.a && x.b == y.b; });
}

AreaCosts leavable(AreaCosts areas, const Point2& robot, double robot_radius) {
  for (AreaCost& area : areas.areas) {
    // more than any cost stands for, so that it becomes the dearest
    if (std::isinf(area.factor) && holds(area.outline, robot)) area.factor = 1e9;
  }
  const auto isAt = [&](const Segment& door) { return distanceTo(door, robot) <= robot_radius; };
  areas.closed_doors.erase(
      std::remove_if(areas.closed_doors.begin(), areas.closed_doors.end(), isAt),
      areas.closed_doors.end());
  return areas;
}

CostmapAreas::CostmapAreas(const AreaCosts& areas, const MapGeometry& geometry,
                           const CostRules& rules)
    : geometry_(geometry), doors_(areas.closed_doors) {
  const auto costs_something = [&](const AreaCost& area) { return costOf(area.factor, rules) > 0; };
  if (std::none_of(areas.areas.begin(), areas.areas.end(), costs_something)) return;
  costs_.assign(geometry.pixelCount(), 0);
  std::vector<std::size_t> order(areas.areas.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return areas.areas[a].size > areas.areas[b].size;
  });
  for (const std::size_t i : order) {
    const std::uint8_t cost = costOf(areas.areas[i].factor, rules);
    visitRuns(areas.areas[i].outline, geometry, [&](int y, int from, int to) {
      if (from >= to) return;
      std::uint8_t* row = costs_.data() + geometry.index({0, y});
      std::fill(row + from, row + to, cost);
    });
  }
}

void CostmapAreas::raise(std::uint8_t* costs, Pixel low, Pixel high) const {
  for (int y = low.y; y < high.y && !costs_.empty(); ++y) {
    for (int x = low.x; x < high.x; ++x) {
      const std::size_t i = geometry_.index({x, y});
      const bool known = costs[i] != kNoInformation;
      if (known ? costs_[i] > costs[i] : costs_[i] == kLethal) costs[i] = costs_[i];
    }
  }
  for (const Segment& door : doors_) {
    const auto isOpen = [&](std::size_t i) { return costs[i] != kLethal; };
    for (const std::size_t i : planning::doorPixels(geometry_, door, isOpen)) {
      const Pixel p = geometry_.pixel(i);
      if (p.x >= low.x && p.y >= low.y && p.x < high.x && p.y < high.y) costs[i] = kLethal;
    }
  }
}

void CostmapAreas::raise(Costmap& costmap) const {
  raise(costmap.costs.data(), {0, 0}, {geometry_.width, geometry_.height});
}

const CostmapAreas& CurrentAreas::get(const AreaCosts& areas, const MapGeometry& geometry) {
  const auto isAsBefore = [&](const MapGeometry& former) {
    return former.width == geometry.width && former.height == geometry.height &&
           former.resolution == geometry.resolution &&
           former.map_from_image.position == geometry.map_from_image.position &&
           former.map_from_image.yaw == geometry.map_from_image.yaw;
  };
  if (!made_ || !(areas == areas_) || !isAsBefore(made_->geometry())) {
    made_.emplace(areas, geometry, rules_);
    areas_ = areas;
  }
  return *made_;
}

}  // namespace agrid
