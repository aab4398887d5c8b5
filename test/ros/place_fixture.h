// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <ros/time.h>

#include "agrid/pipeline.h"
#include "drawn_maps.h"
#include "ros/place_keeper.h"
#include "support/temporary_folder.h"

namespace agrid_map_ros::test {

/// Keepers of a place, one after the other, on one file.
class PlaceFixture : public testing::Test {
 protected:
  PlaceFixture() { ros::Time::init(); }

  std::unique_ptr<PlaceKeeper> keeper() {
    auto keeper = std::make_unique<PlaceKeeper>(
        PlaceKeeper::Listeners{[this](const SnapshotPtr&) { ++changes_; },
                               [this](const std::string& text) { warned_.push_back(text); },
                               [this](const std::string& text) { failed_.push_back(text); }});
    keeper->open(storage_, "/agrid");
    return keeper;
  }

  static std::shared_ptr<Snapshot> draft(const std::vector<std::string>& rows,
                                         const std::string& frame = "map") {
    static const auto kParameters = std::make_shared<const Parameters>();
    auto snapshot = std::make_shared<Snapshot>();
    const ReceivedMap received = fromMsg(drawn(rows, frame));
    auto map = std::make_shared<const agrid::OccupancyMap>(received.grid);
    snapshot->map = std::make_shared<const agrid::SemanticMap>(
        agrid::annotate(agrid::extractStructure(std::move(map), {}), {}, {}));
    snapshot->planner =
        std::make_shared<const agrid::Planner>(snapshot->map, agrid::PlannerParams{});
    snapshot->parameters = kParameters;
    snapshot->stamp.header.frame_id = frame;
    return snapshot;
  }

  static PlaceKeeper::Decision put(const agrid::Tag& tag) {
    return [tag](const Snapshot& snapshot) {
      agrid::AddTag add;
      add.tag = tag;
      return agrid::decide(add, *snapshot.map);
    };
  }

  static agrid::AreaTag kitchen(double x = 2.5, double y = 3.5) {
    agrid::AreaTag tag;
    tag.name = "kitchen";
    tag.seed_map = {x, y};
    tag.source = agrid::TagSource::kManual;
    return tag;
  }

  static agrid::ObjectTag object(const std::string& name) {
    agrid::ObjectTag tag;
    tag.name = name;
    tag.pose_map = {{3, 3}, 0};
    tag.size = {0.6, 0.6};
    return tag;
  }

  static std::string areaAt(const PlaceKeeper& keeper, double x, double y) {
    const SnapshotPtr snapshot = keeper.snapshot();
    const agrid::Area* area = agrid::areaAt(*snapshot->map, {x, y});
    return area ? area->name : "";
  }

  agrid::test::TemporaryFolder folder_;
  StorageParams storage_{folder_.path(), "place", true, false};
  int changes_ = 0;
  std::vector<std::string> warned_;
  std::vector<std::string> failed_;
};

}  // namespace agrid_map_ros::test
