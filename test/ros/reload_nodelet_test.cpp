// SPDX-License-Identifier: BSD-3-Clause
// A nodelet that is loaded and unloaded again and again, while it builds, plans and stores.
#include <atomic>
#include <cstdio>
#include <future>
#include <map>

#include <gtest/gtest.h>
#include <nodelet/NodeletLoad.h>
#include <nodelet/NodeletUnload.h>
#include <std_srvs/Trigger.h>

#include <agrid_map/AddTag.h>

#include "agrid/storage.h"
#include "node_process.h"
#include "nodelet_client.h"
#include "support/temporary_folder.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;

class Reload : public test::NodeletClient {
 protected:
  Reload() {
    load_.name = "/reloaded";
    load_.type = "agrid_map/AGridNodelet";
    ros::param::set("reloaded/storage_dir", folder_.path());
    ros::param::set("reloaded/static_map_wait", 0.0);
  }
  /// Moves some boxes, each edit a bit further, until the service is gone.
  void moveUntilItIsGone() {
    for (;;) {
      const double x = 2 + 1e-4 * ++asked_;
      agrid_map::AddTag service;
      service.request.replace = true;
      service.request.tag.type = agrid_map::Tag::OBJECT;
      service.request.tag.name = "box " + std::to_string(asked_ % 4);
      service.request.tag.source = agrid_map::Tag::MANUAL;
      service.request.tag.pose.position.x = x;
      service.request.tag.pose.position.y = 3;
      if (!ros::service::call("reloaded/add_tag", service)) return;
      if (service.response.status.code != Status::SUCCESS) continue;
      moved_[service.request.tag.name] = x;
      ++edits_;
    }
  }
  void loadAndUnload() {
    EXPECT_TRUE(ask<nodelet::NodeletLoad>("manager/load_nodelet", load_).success);
    EXPECT_TRUE(ros::service::waitForService("reloaded/add_tag", ros::Duration(60)));
    const int before = edits_;
    const auto edits = std::async(std::launch::async, [this] { moveUntilItIsGone(); });
    EXPECT_TRUE(test::eventually([&] { return edits_ > before + 3; }));
    ask<std_srvs::Trigger>("reloaded/rebuild");
    nodelet::NodeletUnload::Request unload;
    unload.name = load_.name;
    EXPECT_TRUE(ask<nodelet::NodeletUnload>("manager/unload_nodelet", unload).success);
  }

  agrid::test::TemporaryFolder folder_;
  nodelet::NodeletLoad::Request load_;
  std::atomic<int> asked_{0};
  std::atomic<int> edits_{0};
  std::map<std::string, double> moved_;  ///< where it was acknowledged that each box is
};

TEST_F(Reload, L1_UnloadedWhileItBuildsAndStoresItLeavesNothingBehind) {
  const int cycles = ros::param::param("~reloads", 8);
  useTwoRooms();
  const pid_t manager = test::processOf("/manager");
  long first = 0;
  for (int i = 0; i < cycles; ++i) {
    loadAndUnload();
    if (i == 2) first = test::kilobytesOf(manager);
  }
  EXPECT_EQ(test::processOf("/manager"), manager);
  const auto stored = agrid::readStoredMap(folder_ / "reloaded.yaml").map.knowledge;
  EXPECT_EQ(stored.objects.size(), moved_.size());
  for (const auto& box : stored.objects) {
    EXPECT_GE(box.pose_map.position.x(), moved_.at(box.name) - 1e-9) << box.name;
  }
  const double growth = static_cast<double>(test::kilobytesOf(manager) - first) / (cycles - 3);
  std::printf("%d edits; %.0f kB more with each of %d reloads\n", edits_.load(), growth,
              cycles - 3);
  EXPECT_LT(growth, cycles < 100 ? 2000 : 50);  // a few say little
}

}  // namespace
}  // namespace agrid_map_ros
