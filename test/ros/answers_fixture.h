// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "agrid/pipeline.h"
#include "drawn_maps.h"
#include "ros/plan_answers.h"
#include "ros/request_error.h"

namespace agrid_map_ros::test {

/// Answers from a snapshot of two rooms with a door and a closet without one, without a master.
class AnswersFixture : public testing::Test {
 protected:
  AnswersFixture() {
    const ReceivedMap received = fromMsg(drawn(twoRoomsAndACloset()));
    const agrid::PipelineParams pipeline;
    const auto structure = agrid::extractStructure(
        std::make_shared<const agrid::OccupancyMap>(received.grid), pipeline);
    auto map = std::make_shared<agrid::SemanticMap>(agrid::annotate(structure, {}, pipeline));
    map->area_map.areas.at(0).category = "room";
    map->area_map.areas.at(1).category = "room";
    snapshot_.map = map;
    snapshot_.planner = std::make_shared<const agrid::Planner>(map, agrid::PlannerParams{});
    snapshot_.parameters = std::make_shared<const Parameters>();
    snapshot_.stamp.header.frame_id = "map";
  }

  std::string areaAt(double x, double y) const {
    const agrid::Area* area = agrid::areaAt(*snapshot_.map, {x, y});
    return area ? area->name : "";
  }

  static geometry_msgs::PoseStamped at(double x, double y) {
    geometry_msgs::PoseStamped pose;
    pose.pose.position.x = x;
    pose.pose.position.y = y;
    return pose;
  }

  agrid_map::PlanPath::Response pathTo(const geometry_msgs::PoseStamped& goal) const {
    agrid_map::PlanPath::Request request;
    request.start = at(2.5, 3.5);
    request.goal = goal;
    return answerPlanPath(ground_, request);
  }

  template <typename Answer>
  static int codeThrown(const Answer& answer) {
    try {
      answer();
    } catch (...) {
      return statusOfException().code;
    }
    return agrid_map::Status::SUCCESS;
  }

  Snapshot snapshot_;
  tf2::BufferCore transforms_;
  std::atomic<bool> cancelled_{false};
  Frames frames_{transforms_, cancelled_, "map", 0};
  Ground ground_{snapshot_, frames_, cancelled_};
};

}  // namespace agrid_map_ros::test
