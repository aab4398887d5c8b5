// SPDX-License-Identifier: BSD-3-Clause
#include "agrid_map_ros/navigation.h"

#include <cmath>

#include <gtest/gtest.h>

#include "agrid_map_ros/conversions.h"
#include "answers_fixture.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;
using Fixture = test::AnswersFixture;

/// Turned by a right angle and moved: what lies at (x, y) of the map is at (5 - y, x + 1).
const agrid::Pose2 kFrameFromMap{{5, 1}, M_PI / 2};

class Navigation : public Fixture {
 protected:
  agrid_map::TopologicalGraph graph() const { return graphToMsg(*snapshot_.map, snapshot_.stamp); }

  agrid_map::PlanPath::Response pathWithClosed(const std::vector<std::uint32_t>& doors) const {
    agrid_map::PlanPath::Request request;
    request.start = at(2.5, 3.5);
    request.goal = at(9.5, 3.5);
    request.closed_doors = doors;
    return answerPlanPath(ground_, request);
  }
};

TEST_F(Navigation, DoorsThatARequestTakesAsClosedAreNotPlannedThroughAndStayOpenForOthers) {
  const std::uint32_t door = graph().doors.at(0).id;
  const auto closed = pathWithClosed({door});
  EXPECT_EQ(closed.status.code, int{Status::NO_ROUTE});
  EXPECT_NE(closed.status.message.find("closed door"), std::string::npos) << closed.status.message;
  EXPECT_EQ(pathWithClosed({}).status.code, int{Status::SUCCESS});
  EXPECT_EQ(codeThrown([&] { pathWithClosed({door, 77}); }), int{Status::UNKNOWN_NAME});
}

TEST_F(Navigation, OutlinesCostsAndClosedDoorsOfAGraphAreTakenToTheFrameOfTheCostmap) {
  agrid_map::TopologicalGraph graph = this->graph();
  graph.areas.at(0).properties.resize(1);
  graph.areas[0].properties[0].key = "cost";
  graph.areas[0].properties[0].value = "forbidden";
  EXPECT_TRUE(areaCosts(graph, kFrameFromMap).closed_doors.empty());
  graph.doors.at(0).state = agrid_map::Door::CLOSED;
  const agrid::AreaCosts costs = areaCosts(graph, kFrameFromMap);
  ASSERT_EQ(costs.areas.size(), graph.areas.size());
  EXPECT_TRUE(std::isinf(costs.areas[0].factor));
  EXPECT_EQ(costs.areas[1].factor, 1);
  EXPECT_EQ(costs.areas[1].size, graph.areas[1].size);
  const geometry_msgs::Point32& corner = graph.areas[0].outline.points.at(0);
  EXPECT_NEAR(costs.areas[0].outline.at(0).x(), 5 - static_cast<double>(corner.y), 1e-5);
  EXPECT_NEAR(costs.areas[0].outline.at(0).y(), static_cast<double>(corner.x) + 1, 1e-5);
  ASSERT_EQ(costs.closed_doors.size(), 1U);
  EXPECT_NEAR(costs.closed_doors[0].a.x(), 5 - graph.doors[0].jambs[0].y, 1e-9);
  graph.areas[0].source = 9;
  EXPECT_THROW(areaCosts(graph, kFrameFromMap), std::invalid_argument);
}

TEST_F(Navigation, ALeadHoldsThePathAndItsDoorsInTheFrameOfTheCostmap) {
  const auto response = pathWithClosed({});
  const agrid::Lead lead = leadOf(response, graph(), kFrameFromMap);
  EXPECT_TRUE(lead.found);
  ASSERT_EQ(lead.path.size(), response.path.poses.size());
  EXPECT_NEAR((lead.path.front() - agrid::Point2(5 - 3.5, 2.5 + 1)).norm(), 0, 1e-5);
  ASSERT_EQ(lead.doors.size(), 1U);
  EXPECT_EQ(lead.doors[0].id, agrid::DoorId{response.route.doors.at(0)});
  const geometry_msgs::Point& jamb = graph().doors.at(0).jambs[1];
  EXPECT_NEAR((lead.doors[0].jambs.b - agrid::Point2(5 - jamb.y, jamb.x + 1)).norm(), 0, 1e-9);
}

TEST_F(Navigation, WithoutARouteTheLeadSaysWhy) {
  const auto response = pathWithClosed({graph().doors.at(0).id});
  const agrid::Lead lead = leadOf(response, graph(), {});
  EXPECT_FALSE(lead.found);
  EXPECT_EQ(lead.message, response.status.message);
}

TEST_F(Navigation, EachPoseHeadsForTheNextOneAndTheLastAsTheGoal) {
  geometry_msgs::PoseStamped goal = at(2, 1);
  goal.header.frame_id = "odom";
  goal.pose.position.z = 0.3;
  goal.pose.orientation = toMsg(agrid::Pose2{{0, 0}, -2}).orientation;
  const auto poses = posesOf({{0, 0}, {2, 0}, {2, 1.00001}}, goal);
  ASSERT_EQ(poses.size(), 3U);
  EXPECT_NEAR(fromMsg(poses[0].pose).yaw, 0, 1e-9);
  EXPECT_NEAR(fromMsg(poses[1].pose).yaw, M_PI / 2, 1e-9);
  EXPECT_EQ(poses[2].pose, goal.pose);
  for (const auto& pose : poses) EXPECT_EQ(pose.header, goal.header);
  // a goal that was moved keeps its heading only
  const auto moved = posesOf({{0, 0}, {2, 0.5}}, goal);
  EXPECT_EQ(moved.back().pose.position.y, 0.5);
  EXPECT_NEAR(fromMsg(moved.back().pose).yaw, -2, 1e-9);
  EXPECT_TRUE(posesOf({}, goal).empty());
}

TEST_F(Navigation, ASentenceNamesTheBlockedDoorsAndWhatBecameOfThePlan) {
  agrid::FollowedPath path;
  path.status = agrid::FollowedPath::Status::kFound;
  path.origin = agrid::FollowedPath::Origin::kOtherLead;
  agrid_map::Door door;
  door.id = 4;
  door.name = "kitchen\ndoor";
  EXPECT_EQ(describe(path, {door}), "door 'kitchen\\x0adoor' is blocked: through other doors");
  path.status = agrid::FollowedPath::Status::kNoWay;
  path.lead_message = "free space does not connect";
  EXPECT_EQ(describe(path, {}),
            "the costmap does not connect start and goal; on the static map: free space does not "
            "connect");
}

TEST_F(Navigation, DoorsAreFoundByTheirIdsInTheOrderAsked) {
  agrid_map::TopologicalGraph graph;
  for (const std::uint32_t id : {3U, 5U, 8U}) {
    graph.doors.emplace_back();
    graph.doors.back().id = id;
  }
  const auto doors = doorsOf(graph, {agrid::DoorId{8}, agrid::DoorId{4}, agrid::DoorId{3}});
  ASSERT_EQ(doors.size(), 2U);
  EXPECT_EQ(doors[0].id, 8U);
  EXPECT_EQ(doors[1].id, 3U);
}

}  // namespace
}  // namespace agrid_map_ros
