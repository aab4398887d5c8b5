// SPDX-License-Identifier: BSD-3-Clause
// Maps that come and go, as the nodelet lives through them.
#include <future>

#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>

#include <agrid_map/PlanAreas.h>

#include "agrid/evaluation/office_generator.h"
#include "node_process.h"
#include "nodelet_client.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;
using test::eventually;

class Maps : public test::NodeletClient {
 protected:
  /// Asks for something whose goal waits for a transform, walls the door up and gives the
  /// transform.
  template <typename Service>
  typename Service::Response askBeforeTheMapChanges(
      const std::string& name, typename Service::Request request,
      geometry_msgs::PoseStamped Service::Request::*goal) {
    const std::string frame = "late_" + std::to_string(++late_frames_);
    (request.*goal).header.frame_id = frame;
    auto answer =
        std::async(std::launch::async, [&] { return ask<Service>("agrid/" + name, request); });
    ros::Duration(0.1).sleep();
    use(test::drawn(test::walledUp()));
    place(frame, 0, 0);
    return answer.get();
  }
  static bool remarksNewerMap(const Status& status) {
    return status.message.find("newer map") != std::string::npos;
  }
  /// Whether /diagnostics gives an error with these words as the last one of a node.
  static bool tells(const std::string& node, const std::string& words) {
    std::string last_error;
    ros::CallbackQueue queue;
    ros::NodeHandle nh;
    nh.setCallbackQueue(&queue);
    const boost::function<void(const diagnostic_msgs::DiagnosticArrayConstPtr&)> listen =
        [&](const diagnostic_msgs::DiagnosticArrayConstPtr& array) {
          const auto& status = array->status.at(0);
          if (status.name == node + ": map") last_error = status.values.back().value;
        };
    const ros::Subscriber subscriber =
        nh.subscribe<diagnostic_msgs::DiagnosticArray>("/diagnostics", 100, listen);
    return eventually([&] {
      queue.callAvailable();
      return last_error.find(words) != std::string::npos;
    });
  }
  inline static int late_frames_ = 0;  // a frame once known stays known
};

TEST_F(Maps, ASecondMapReplacesTheFirst) {
  useTwoRooms();
  const std::uint32_t version = graph().version;
  use(test::drawn(test::walledUp()));
  EXPECT_GT(graph().version, version);
  EXPECT_EQ(pathStatus(pathRequest()), int{Status::NO_ROUTE});
}

TEST_F(Maps, M18_AMapInAnotherFrame) {
  use(test::drawn(test::twoRoomsAndACloset(), "world"));
  EXPECT_EQ(latched<agrid_map::AGrid>("agrid/agrid")->header.frame_id, "world");
  const auto path = ask<agrid_map::PlanPath>("agrid/plan_path", pathRequest());
  EXPECT_EQ(path.path.header.frame_id, "world");
}

TEST_F(Maps, M19_TheSameMapAgainChangesNothing) {
  useTwoRooms();
  const std::uint32_t version = graph().version;
  map_publisher_.publish(test::drawn(test::twoRoomsAndACloset()));
  auto other = test::drawn(test::walledUp());
  use(other);
  EXPECT_EQ(graph().version, version + 1);
}

TEST_F(Maps, M20_APathIsThatOfTheMapThatItWasAskedOn) {
  EXPECT_TRUE(eventually([&] {
    useTwoRooms();
    const std::string former = graph().map_id;
    const auto request = pathRequest();
    const auto response = askBeforeTheMapChanges<agrid_map::PlanPath>(
        "plan_path", request, &agrid_map::PlanPath::Request::goal);
    if (response.status.code == int{Status::NO_TRANSFORM}) return false;  // the map came too late
    EXPECT_EQ(response.status.code, int{Status::SUCCESS}) << response.status.message;
    return response.map_id == former && remarksNewerMap(response.status);
  }));
}

TEST_F(Maps, M20_ARouteIsThatOfTheMapThatItWasAskedOn) {
  EXPECT_TRUE(eventually([&] {
    useTwoRooms();
    agrid_map::PlanAreas::Request request;
    request.start_pose = at(2.5, 3.5);
    request.goal_pose = at(9.5, 3.5);
    const auto response = askBeforeTheMapChanges<agrid_map::PlanAreas>(
        "plan_areas", request, &agrid_map::PlanAreas::Request::goal_pose);
    if (response.status.code == int{Status::NO_TRANSFORM}) return false;
    EXPECT_EQ(response.status.code, int{Status::SUCCESS}) << response.status.message;
    return response.routes.size() == 1 && remarksNewerMap(response.status);
  }));
}

TEST_F(Maps, M22_M23_PatchesChangeTheMapIfTheyFit) {
  useTwoRooms();
  ASSERT_TRUE(eventually([this] { return update_publisher_.getNumSubscribers() >= 2; }));
  map_msgs::OccupancyGridUpdate patch;
  patch.header.frame_id = "map";
  patch.x = 60;
  patch.y = 30;
  patch.width = patch.height = 10;
  patch.data.assign(99, 100);
  update_publisher_.publish(patch);  // a value too few
  patch.data.push_back(100);
  patch.header.frame_id = "odom";
  update_publisher_.publish(patch);
  patch.header.frame_id = "map";
  patch.x = 165;
  update_publisher_.publish(patch);
  patch.x = 60;
  const std::string digest = digestOf(test::drawn(test::walledUp()));
  EXPECT_TRUE(eventually([&] {
    // walls up the door; again, as the map that useTwoRooms sent may arrive later, on another topic
    update_publisher_.publish(patch);
    return graph().map_id == digest;
  }));
}

TEST_F(Maps, M23_APatchBeforeAnyMapIsIgnored) {
  ASSERT_TRUE(eventually([this] { return update_publisher_.getNumSubscribers() >= 2; }));
  map_msgs::OccupancyGridUpdate patch;
  patch.header.frame_id = "map";
  patch.width = patch.height = 1;
  patch.data = {100};
  update_publisher_.publish(patch);
  EXPECT_TRUE(tells("empty", "no map has arrived that could be patched"));
  EXPECT_EQ(ask<agrid_map::GetGraph>("empty/get_graph").status.code, int{Status::NO_MAP});
}

TEST_F(Maps, M24_AfterAFloodOfMapsTheNewestIsInUse) {
  useTwoRooms();
  const std::uint32_t version = graph().version;
  const pid_t process = test::processOf("/agrid");
  const long before = test::kilobytesOf(process);
  constexpr int kMaps = 400;
  auto map = test::drawn(test::twoRoomsAndACloset());
  for (int i = 0; i < kMaps; ++i) {
    map.data.at(200 + static_cast<std::size_t>(i)) = 0;  // each another one
    map_publisher_.publish(map);
    ros::Duration(0.002).sleep();
  }
  EXPECT_TRUE(eventually([&] { return graph().map_id == digestOf(map); }));
  EXPECT_LE(graph().version, version + kMaps);
  EXPECT_LT(test::kilobytesOf(process) - before, 50000);  // no backlog
}

TEST_F(Maps, M1_ABadMapLeavesTheFormerOneInUse) {
  useTwoRooms();
  const auto before = graph();
  auto bad = test::drawn(test::walledUp());
  bad.data.pop_back();
  map_publisher_.publish(bad);
  EXPECT_TRUE(tells("agrid", "values"));
  EXPECT_EQ(graph().version, before.version);
  EXPECT_EQ(pathStatus(pathRequest()), int{Status::SUCCESS});
}

TEST_F(Maps, M16_AnswersWhileANewMapIsBuilt) {
  useTwoRooms();
  agrid::OfficeParams office;
  office.size = 2000;
  std_msgs::Header header;
  header.frame_id = "map";
  const auto map = toMsg(agrid::OccupancyMap(agrid::generateOffice(office).grid), header);
  const std::string digest = digestOf(map);
  map_publisher_.publish(map);
  int answered_before = 0;
  EXPECT_TRUE(eventually([&] {
    const auto now = graph();
    answered_before += now.map_id != digest;
    return now.map_id == digest;
  }));
  EXPECT_GT(answered_before, 0);
  EXPECT_GT(graph().areas.size(), 20U);
}

TEST_F(Maps, M26_SeveralPublishersAreWarnedOfOnceAndTheLastMapWins) {
  ros::CallbackQueue queue;
  ros::NodeHandle nh;
  nh.setCallbackQueue(&queue);
  bool heard = false;
  int warnings = 0;
  const boost::function<void(const rosgraph_msgs::LogConstPtr&)> listen =
      [&](const rosgraph_msgs::LogConstPtr& log) {
        if (log->name != "/crowded") return;
        heard = true;
        warnings += log->msg.find("publishers on the map's topic") != std::string::npos;
      };
  const ros::Subscriber subscriber = nh.subscribe<rosgraph_msgs::Log>("/rosout", 100, listen);
  agrid_map::LabelAt::Request outside;  // is warned of: who hears that will hear what follows too
  outside.point.point.x = -99;
  ASSERT_TRUE(eventually([&] {
    ask<agrid_map::LabelAt>("crowded/label_at", outside);
    queue.callAvailable();
    return heard;
  }));
  const ros::Publisher publisher = nh_.advertise<nav_msgs::OccupancyGrid>("crowded_map", 1, true);
  for (const auto& rows : {test::twoRoomsAndACloset(), test::walledUp()}) {
    const auto map = test::drawn(rows);
    publisher.publish(map);
    EXPECT_TRUE(eventually([&] {
      return ask<agrid_map::GetGraph>("crowded/get_graph").graph.map_id == digestOf(map);
    }));
  }
  EXPECT_TRUE(eventually([&] {
    queue.callAvailable();
    return warnings > 0;
  }));
  EXPECT_EQ(warnings, 1);
}

}  // namespace
}  // namespace agrid_map_ros
