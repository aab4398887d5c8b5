// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/planning/lead_follower.h"

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "planning/drawn_costmap.h"

namespace agrid {
namespace {

using test::at;
using test::costmap;
using test::expectFree;
using test::kResolution;
using test::Rows;
using Status = FollowedPath::Status;
using Origin = FollowedPath::Origin;

Lead noLead(const std::vector<DoorId>& /*closed*/) { return {false, {}, {}, "no lead today"}; }

/// Two rooms one above the other, joined by doors on the left (id 1) and on the right (id 2).
Rows twoDoors() {
  Rows rows(41, "#" + std::string(78, '.') + "#");
  rows.front() = rows.back() = std::string(80, '#');
  rows[20] = "#....." + std::string(8, '.') + std::string(52, '#') + std::string(13, '.') + "#";
  rows[20].replace(1, 5, "#####");
  rows[20].replace(74, 5, "#####");
  return rows;
}

/// Leads straight through the left door, then the right one, then none.
struct DoorLeads {
  const Costmap& map;
  Segment ends;
  std::vector<std::vector<DoorId>> asked = {};

  Lead operator()(const std::vector<DoorId>& closed) {
    asked.push_back(closed);
    Lead lead;
    if (closed.size() > 1) return lead;
    lead.found = true;
    const bool left = closed.empty();
    const LeadDoor door{DoorId{left ? 1U : 2U},
                        {at(map, left ? 5 : 66, 20), at(map, left ? 14 : 74, 20)}};
    lead.doors = {door};
    lead.path = {ends.a, door.jambs.midpoint(), ends.b};
    return lead;
  }
};

TEST(LeadFollower, WhereTheLeadIsFreeThePathIsTheStraightLineBesideIt) {
  const Costmap map = costmap(twoDoors());
  const Segment ends{at(map, 10, 35), at(map, 10, 5)};
  DoorLeads leads{map, ends};
  LeadFollower follower({});
  const FollowedPath path = follower.plan(map, ends, 0, std::ref(leads));
  EXPECT_EQ(path.status, Status::kFound);
  EXPECT_EQ(path.origin, Origin::kLead);
  EXPECT_TRUE(path.blocked_doors.empty());
  expectFree(map, path, ends);
  EXPECT_NEAR(path.cost, 3.0, 1e-3);
  EXPECT_EQ(leads.asked.size(), 1U);
}

TEST(LeadFollower, AnObstacleOnTheLeadIsGoneAroundNearby) {
  Rows rows = twoDoors();
  for (int y = 26; y < 31; ++y)
    rows[static_cast<std::size_t>(y)].replace(1, 24, std::string(24, '#'));
  const Costmap map = costmap(rows);
  const Segment ends{at(map, 10, 35), at(map, 10, 5)};
  DoorLeads leads{map, ends};
  LeadFollower follower({});
  const FollowedPath path = follower.plan(map, ends, 0, std::ref(leads));
  EXPECT_EQ(path.status, Status::kFound);
  EXPECT_EQ(path.origin, Origin::kLead);
  EXPECT_TRUE(path.blocked_doors.empty());
  expectFree(map, path, ends);
}

TEST(LeadFollower, ABlockedDoorIsNamedAndTheNextLeadTaken) {
  Rows rows = twoDoors();
  rows[20].replace(1, 30, std::string(30, 'i'));
  rows[22].replace(4, 20, std::string(20, '#'));
  const Costmap map = costmap(rows);
  const Segment ends{at(map, 10, 35), at(map, 10, 5)};
  DoorLeads leads{map, ends};
  LeadFollower follower({});
  const FollowedPath path = follower.plan(map, ends, 0, std::ref(leads));
  EXPECT_EQ(path.status, Status::kFound);
  EXPECT_EQ(path.origin, Origin::kOtherLead);
  EXPECT_EQ(path.blocked_doors, std::vector<DoorId>{DoorId{1}});
  EXPECT_EQ(leads.asked, (std::vector<std::vector<DoorId>>{{}, {DoorId{1}}}));
  expectFree(map, path, ends);
  EXPECT_GT(path.cost, 11);
}

TEST(LeadFollower, WhereAllDoorsAreBlockedItSaysSoAndNamesThem) {
  Rows rows = twoDoors();
  rows[20] = std::string(80, '#');
  const Costmap map = costmap(rows);
  const Segment ends{at(map, 10, 35), at(map, 10, 5)};
  DoorLeads leads{map, ends};
  LeadFollower follower({});
  const FollowedPath path = follower.plan(map, ends, 0, std::ref(leads));
  EXPECT_EQ(path.status, Status::kNoWay);
  EXPECT_TRUE(path.path.empty());
  EXPECT_EQ(path.blocked_doors, (std::vector<DoorId>{DoorId{1}, DoorId{2}}));
}

TEST(LeadFollower, ADoorThatTheWholeCostmapStillLeadsThroughIsNotCalledBlocked) {
  Rows rows = twoDoors();
  // a maze before the left door that no detour of 0.5 m gets through; the right one is shut
  rows[30].replace(1, 60, std::string(60, '#'));
  rows[20].replace(60, 19, std::string(19, '#'));
  const Costmap map = costmap(rows);
  const Segment ends{at(map, 10, 35), at(map, 10, 5)};
  DoorLeads leads{map, ends};
  FollowParams params;
  params.band = 0.4;
  params.detour = 0.5;
  LeadFollower follower(params);
  const FollowedPath path = follower.plan(map, ends, 0, std::ref(leads));
  EXPECT_EQ(path.status, Status::kFound);
  EXPECT_EQ(path.origin, Origin::kCostmap);
  EXPECT_TRUE(path.blocked_doors.empty());
  expectFree(map, path, ends);
}

TEST(LeadFollower, WithoutALeadTheCostmapAloneIsSearchedAndTheReasonKept) {
  const Costmap map = costmap(twoDoors());
  const Segment ends{at(map, 10, 35), at(map, 10, 5)};
  LeadFollower follower({});
  const FollowedPath path = follower.plan(map, ends, 0, noLead);
  EXPECT_EQ(path.status, Status::kFound);
  EXPECT_EQ(path.origin, Origin::kCostmap);
  EXPECT_EQ(path.lead_message, "no lead today");
  expectFree(map, path, ends);
}

TEST(LeadFollower, ExpensivePixelsAreAvoidedWhereTheWayAroundCostsLess) {
  Rows rows(21, std::string(41, '.'));
  for (int y = 6; y < 15; ++y)
    rows[static_cast<std::size_t>(y)].replace(15, 10, std::string(10, '5'));
  const Costmap map = costmap(rows);
  const Segment ends{at(map, 2, 10), at(map, 38, 10)};
  LeadFollower follower({});
  const FollowedPath path = follower.plan(map, ends, 0, noLead);
  expectFree(map, path, ends);
  for (const Point2& p : path.path) {
    EXPECT_EQ(map.costs[map.geometry.index(map.geometry.pixelAt(p).value())], 0) << p.transpose();
  }
  FollowParams indifferent;
  indifferent.rules.cost_factor = 0;
  const FollowedPath straight = LeadFollower(indifferent).plan(map, ends, 0, noLead);
  EXPECT_NEAR(straight.cost, 3.6, 1e-3);
}

TEST(LeadFollower, UnknownPixelsAreEnteredOnlyIfAllowed) {
  Rows rows(11, std::string(31, '.'));
  for (std::string& row : rows) row[15] = '?';
  const Costmap map = costmap(rows);
  const Segment ends{at(map, 2, 5), at(map, 28, 5)};
  EXPECT_EQ(LeadFollower({}).plan(map, ends, 0, noLead).status, Status::kFound);
  FollowParams params;
  params.rules.allow_unknown = false;
  EXPECT_EQ(LeadFollower(params).plan(map, ends, 0, noLead).status, Status::kNoWay);
}

TEST(LeadFollower, EndsBeyondTheMapOrInObstaclesAreToldApart) {
  Rows rows(21, std::string(31, '.'));
  for (int y = 8; y < 13; ++y) rows[static_cast<std::size_t>(y)].replace(20, 5, "#####");
  const Costmap map = costmap(rows);
  LeadFollower follower({});
  const Point2 inside = at(map, 2, 10);
  EXPECT_EQ(follower.plan(map, {{-9, 0}, inside}, 1, noLead).status, Status::kStartOutside);
  EXPECT_EQ(follower.plan(map, {inside, {1e30, 0}}, 1, noLead).status, Status::kGoalOutside);
  const Point2 nan(std::numeric_limits<double>::quiet_NaN(), 0);
  EXPECT_EQ(follower.plan(map, {inside, nan}, 1, noLead).status, Status::kGoalOutside);
  EXPECT_EQ(follower.plan(map, {inside, at(map, 22, 10)}, 0.1, noLead).status,
            Status::kGoalBlocked);
  const FollowedPath moved = follower.plan(map, {inside, at(map, 22, 10)}, 0.35, noLead);
  ASSERT_EQ(moved.status, Status::kFound);
  EXPECT_NEAR((moved.path.back() - at(map, 22, 10)).norm(), 0.3, 1e-3);
  const FollowedPath leaving = follower.plan(map, {at(map, 24, 10), inside}, 0, noLead);
  EXPECT_EQ(leaving.status, Status::kFound);
  expectFree(map, leaving, {at(map, 24, 10), inside});
}

TEST(LeadFollower, AGoalThatCannotBeReachedIsMovedToThisSideOfTheWall) {
  Rows rows(11, std::string(31, '.'));
  for (std::string& row : rows) row[15] = '#';
  const Costmap map = costmap(rows);
  const Segment ends{at(map, 2, 5), at(map, 16, 5)};
  EXPECT_EQ(LeadFollower({}).plan(map, ends, 0.15, noLead).status, Status::kNoWay);
  const FollowedPath path = LeadFollower({}).plan(map, ends, 0.25, noLead);
  ASSERT_EQ(path.status, Status::kFound);
  EXPECT_NEAR((path.path.back() - at(map, 14, 5)).norm(), 0, 1e-3);
}

TEST(LeadFollower, ParametersOutOfRangeAreNamed) {
  FollowParams params;
  params.band = 0;
  EXPECT_EQ(problemOf(params), "band = 0.000000 must be from 0.05 to 100 m");
  EXPECT_THROW(LeadFollower{params}, std::invalid_argument);
  params = {};
  params.rules.neutral_cost = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(problemOf(params).find("neutral_cost"), std::string::npos);
  EXPECT_EQ(problemOf({}), "");
}

}  // namespace
}  // namespace agrid
