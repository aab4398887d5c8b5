// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/planning/lead_follower.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "planning/cost_line.h"
#include "planning/cost_search.h"
#include "planning/fine_point.h"
#include "planning/lead_gap.h"

namespace agrid {
namespace {

using planning::CostField;
using planning::CostSearch;
using planning::LeadGap;
using planning::LeadPlace;
using planning::PixelRegion;

/// Blocked places of one lead that are gone around before the next lead is asked for.
constexpr int kMaxGaps = 16;
/// How far from a blocked place its door may be, along the lead [m].
constexpr double kDoorSlack = 1;

/// One request: everything in pixels.
class Follow {
 public:
  Follow(const FollowParams& params, const Costmap& costmap, Pixel start, Pixel goal,
         CostSearch& search, PixelRegion& region)
      : params_(params),
        costmap_(costmap),
        field_(costmap, params.rules, start),
        start_(start),
        goal_(goal),
        search_(search),
        region_(region) {}

  /// Moves a blocked goal to the nearest open pixel; whether there is one.
  bool openGoal(const Point2& wanted, double tolerance);
  std::vector<Pixel> alongLeads(const LeadSource& leads, FollowedPath& result);
  /// Over the whole costmap, to the goal or else to the nearest pixel within the tolerance.
  std::vector<Pixel> anywhere(const Point2& wanted, double tolerance);
  /// The way as points, from and to the very places, with needless corners left out; the doors
  /// that it goes through are not blocked.
  void fill(FollowedPath& result, const std::vector<Pixel>& way, const Segment& ends) const;

 private:
  double inPixels(double metres) const { return metres / costmap_.geometry.resolution; }
  Point2 pixelsOf(const Point2& point) const {
    return planning::pixelCoordinates(costmap_.geometry, point);
  }
  LeadPlace placeAt(const Point2& at) const;
  std::vector<Pixel> along(const std::vector<Point2>& lead, std::optional<LeadGap>& blocked);
  template <typename Good>
  std::optional<Pixel> nearest(const Point2& at, double radius, const Good& good) const;

  const FollowParams& params_;
  const Costmap& costmap_;
  CostField field_;
  Pixel start_;
  Pixel goal_;
  CostSearch& search_;
  PixelRegion& region_;
  std::vector<LeadDoor> blocked_;  // in pixels
};

bool Follow::openGoal(const Point2& wanted, double tolerance) {
  if (!field_.isBlocked(costmap_.geometry.index(goal_))) return true;
  const auto open = nearest(pixelsOf(wanted), inPixels(tolerance),
                            [this](std::size_t i) { return !field_.isBlocked(i); });
  if (open) goal_ = *open;
  return open.has_value();
}

std::vector<Pixel> Follow::anywhere(const Point2& wanted, double tolerance) {
  search_.flood(field_, start_);
  if (!search_.reached(costmap_.geometry.index(goal_))) {
    const auto reached = nearest(pixelsOf(wanted), inPixels(tolerance),
                                 [this](std::size_t i) { return search_.reached(i); });
    if (!reached) return {};
    goal_ = *reached;
  }
  return search_.find(field_, start_, goal_, nullptr);
}

LeadPlace Follow::placeAt(const Point2& at) const {
  const Pixel p{static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))};
  if (!costmap_.geometry.contains(p)) return LeadPlace::kBlocked;
  const std::size_t index = costmap_.geometry.index(p);
  if (search_.reached(index)) return LeadPlace::kReached;
  return field_.isBlocked(index) ? LeadPlace::kBlocked : LeadPlace::kFree;
}

template <typename Good>
std::optional<Pixel> Follow::nearest(const Point2& at, double radius, const Good& good) const {
  std::optional<Pixel> found;
  double least = radius * radius;
  const int reach = static_cast<int>(std::ceil(radius));
  const int x = static_cast<int>(std::lround(at.x()));
  const int y = static_cast<int>(std::lround(at.y()));
  for (int row = y - reach; row <= y + reach; ++row) {
    for (int column = x - reach; column <= x + reach; ++column) {
      const Pixel p{column, row};
      const double distance = (Point2(column, row) - at).squaredNorm();
      if (distance > least || (found && distance == least)) continue;
      if (!costmap_.geometry.contains(p) || !good(costmap_.geometry.index(p))) continue;
      least = distance;
      found = p;
    }
  }
  return found;
}

/// The way near one lead.
/// @param blocked  gets the place that cannot be gone around, if there is one
std::vector<Pixel> Follow::along(const std::vector<Point2>& lead, std::optional<LeadGap>& blocked) {
  region_.reset(costmap_.geometry);
  for (std::size_t i = 1; i < lead.size(); ++i) {
    region_.addBand(lead[i - 1], lead[i], inPixels(params_.band));
  }
  double gone_around = -1;  // along the lead, up to where
  for (int gaps = 0; gaps < kMaxGaps; ++gaps) {
    std::vector<Pixel> way = search_.find(field_, start_, goal_, &region_);
    if (!way.empty()) return way;
    blocked = planning::findGap(planning::resampled(lead, 1),
                                [&](const Point2& at) { return placeAt(at); });
    if (!blocked || blocked->begin <= gone_around) return {};
    gone_around = blocked->begin;
    region_.addDisc(blocked->middle,
                    blocked->length / 2 + inPixels(std::max(params_.detour, params_.band)));
  }
  return {};
}

std::vector<Pixel> Follow::alongLeads(const LeadSource& leads, FollowedPath& result) {
  std::vector<DoorId>& closed = result.blocked_doors;
  for (int i = 0; i < params_.max_leads; ++i) {
    Lead lead = leads(closed);
    if (!lead.found) {
      if (i == 0) result.lead_message = lead.message;
      return {};
    }
    std::vector<Point2> path{Point2(start_.x, start_.y)};
    for (const Point2& point : lead.path) path.push_back(pixelsOf(point));
    path.emplace_back(goal_.x, goal_.y);
    for (LeadDoor& door : lead.doors) {
      door.jambs = {pixelsOf(door.jambs.a), pixelsOf(door.jambs.b)};
    }
    std::optional<LeadGap> blocked;
    std::vector<Pixel> way = along(path, blocked);
    result.origin = i == 0 ? FollowedPath::Origin::kLead : FollowedPath::Origin::kOtherLead;
    if (!way.empty() || !blocked) return way;
    const auto door = planning::doorInGap(planning::resampled(path, 1), lead.doors, *blocked,
                                          inPixels(kDoorSlack));
    if (!door || std::find(closed.begin(), closed.end(), door->id) != closed.end()) return {};
    closed.push_back(door->id);
    blocked_.push_back(*door);
  }
  return {};
}

void Follow::fill(FollowedPath& result, const std::vector<Pixel>& way, const Segment& ends) const {
  std::vector<Point2> points{pixelsOf(ends.a)};
  for (const Pixel p : way) points.emplace_back(p.x, p.y);
  points.push_back(pixelsOf(ends.b));
  for (int pass = 0; pass < 2; ++pass) {  // from either end
    points = planning::resampled(planning::pulledStraight(field_, points), 1);
    std::reverse(points.begin(), points.end());
  }
  const MapGeometry& geometry = costmap_.geometry;
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.path.push_back(planning::mapPoint(geometry, planning::finePoint(points[i])));
    if (i == 0) continue;
    const Segment piece{points[i - 1], points[i]};
    result.cost += planning::costOfLine(field_, piece.a, piece.b) * geometry.resolution;
    for (const LeadDoor& door : blocked_) {
      if (!planning::cross(piece, door.jambs)) continue;
      std::vector<DoorId>& doors = result.blocked_doors;
      doors.erase(std::remove(doors.begin(), doors.end(), door.id), doors.end());
    }
  }
}

}  // namespace

struct LeadFollower::Impl {
  FollowParams params;
  CostSearch search;
  PixelRegion region;
};

LeadFollower::LeadFollower(const FollowParams& params) : impl_(std::make_unique<Impl>()) {
  const std::string problem = problemOf(params);
  if (!problem.empty()) throw std::invalid_argument("LeadFollower: " + problem);
  impl_->params = params;
}

LeadFollower::~LeadFollower() = default;

FollowedPath LeadFollower::plan(const Costmap& costmap, const Segment& start_and_goal,
                                double tolerance, const LeadSource& leads) {
  FollowedPath result;
  const MapGeometry& geometry = costmap.geometry;
  const auto start = geometry.pixelAt(start_and_goal.a);
  const auto goal = geometry.pixelAt(start_and_goal.b);
  if (!start || !goal) {
    result.status =
        start ? FollowedPath::Status::kGoalOutside : FollowedPath::Status::kStartOutside;
    return result;
  }
  Follow follow(impl_->params, costmap, *start, *goal, impl_->search, impl_->region);
  if (!follow.openGoal(start_and_goal.b, tolerance)) {
    result.status = FollowedPath::Status::kGoalBlocked;
    return result;
  }
  std::vector<Pixel> way = follow.alongLeads(leads, result);
  if (way.empty()) {
    result.origin = FollowedPath::Origin::kCostmap;
    way = follow.anywhere(start_and_goal.b, tolerance);
  }
  if (way.empty()) return result;
  result.status = FollowedPath::Status::kFound;
  const bool moved = way.back() != *goal;
  follow.fill(result, way,
              {start_and_goal.a, moved ? geometry.center(way.back()) : start_and_goal.b});
  return result;
}

}  // namespace agrid
