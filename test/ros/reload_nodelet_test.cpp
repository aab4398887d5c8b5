// SPDX-License-Identifier: BSD-3-Clause
// A nodelet that is loaded and unloaded again and again, while it builds, plans and stores.
#include <cstdio>
#include <future>
#include <vector>

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
  /// Puts boxes somewhere until the service is gone.
  /// @return how many were acknowledged
  std::size_t addUntilItIsGone() {
    for (std::size_t count = 0;;) {
      agrid_map::AddTag service;
      service.request.tag.type = agrid_map::Tag::OBJECT;
      service.request.tag.name = "box " + std::to_string(++asked_);
      service.request.tag.source = agrid_map::Tag::MANUAL;
      service.request.tag.pose.position.x = service.request.tag.pose.position.y = 3;
      if (!ros::service::call("reloaded/add_tag", service)) return count;
      if (service.response.status.code != Status::SUCCESS) continue;
      ++count;
      ++added_;
    }
  }
  std::size_t loadAndUnload() {
    EXPECT_TRUE(ask<nodelet::NodeletLoad>("manager/load_nodelet", load_).success);
    EXPECT_TRUE(ros::service::waitForService("reloaded/add_tag", ros::Duration(60)));
    const int before = added_;
    auto edits = std::async(std::launch::async, [this] { return addUntilItIsGone(); });
    EXPECT_TRUE(test::eventually([&] { return added_ > before + 3; }));
    ask<std_srvs::Trigger>("reloaded/rebuild");
    nodelet::NodeletUnload::Request unload;
    unload.name = load_.name;
    EXPECT_TRUE(ask<nodelet::NodeletUnload>("manager/unload_nodelet", unload).success);
    return edits.get();
  }

  agrid::test::TemporaryFolder folder_;
  nodelet::NodeletLoad::Request load_;
  std::atomic<int> asked_{0};
  std::atomic<int> added_{0};
};

TEST_F(Reload, L1_UnloadedWhileItBuildsAndStoresItLeavesNothingBehind) {
  const int cycles = ros::param::param("~reloads", 8);
  useTwoRooms();
  const pid_t manager = test::processOf("/manager");
  std::size_t acknowledged = 0;
  long first = 0;
  for (int i = 0; i < cycles; ++i) {
    acknowledged += loadAndUnload();
    if (i == 2) first = test::residentKilobytes(manager);
  }
  EXPECT_EQ(test::processOf("/manager"), manager);
  const auto stored = agrid::readStoredMap(folder_ / "reloaded.yaml").map.knowledge;
  EXPECT_GE(stored.objects.size(), acknowledged);
  const double growth =
      static_cast<double>(test::residentKilobytes(manager) - first) / (cycles - 3);
  std::printf("%zu edits; %.0f kB more with each of %d reloads\n", acknowledged, growth,
              cycles - 3);
  EXPECT_LT(growth, 2000);  // of a few only; less than 50 of many
}

}  // namespace
}  // namespace agrid_map_ros
