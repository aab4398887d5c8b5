// SPDX-License-Identifier: BSD-3-Clause
// Many plans at once, plans while the map is replaced, plans while the nodelet is unloaded.
#include <atomic>
#include <future>
#include <map>
#include <vector>

#include <gtest/gtest.h>
#include <nodelet/NodeletLoad.h>
#include <nodelet/NodeletUnload.h>

#include "nodelet_client.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;
using test::eventually;

class PlanLoad : public test::NodeletClient {
 protected:
  /// A plan of a planner that never stops before its time is over.
  agrid_map::PlanPath::Request slowRequest(double timeout) {
    auto request = pathRequest();
    request.planner = "LBTRRT";
    request.timeout = timeout;
    return request;
  }
  /// -1: no answer.
  static int statusOf(const std::string& node, agrid_map::PlanPath::Request request) {
    agrid_map::PlanPath::Response response;
    return ros::service::call(node + "/plan_path", request, response) ? response.status.code : -1;
  }
};

TEST_F(PlanLoad, P13_SomeRunSomeWaitTheRestIsBusyAndQuestionsAreAnswered) {
  useTwoRooms();
  auto slow = pathRequest();
  slow.goal.header.frame_id = "nowhere";  // waits for the transform as long as it may
  std::vector<std::future<int>> calls;
  for (int i = 0; i < 40; ++i) {
    calls.push_back(std::async(std::launch::async, [&] { return statusOf("agrid", slow); }));
  }
  EXPECT_EQ(graph().areas.size(), 3U);
  std::map<int, int> counts;
  for (auto& call : calls) ++counts[call.get()];
  EXPECT_GE(counts[Status::NO_TRANSFORM], 3);  // one runs and two wait
  EXPECT_GE(counts[Status::BUSY], 1);
  EXPECT_EQ(counts[Status::NO_TRANSFORM] + counts[Status::BUSY], 40);
  EXPECT_EQ(pathStatus(pathRequest()), int{Status::SUCCESS});
}

TEST_F(PlanLoad, P16_M20_APlanEndsOnTheMapItBeganWithAndSaysSo) {
  const auto first = test::drawn(test::twoRoomsAndACloset());
  auto second = first;
  second.data.at(second.data.size() / 2 + 7) = -1;
  const std::string remark = "a newer map has been built meanwhile";
  bool remarked = false;
  for (const double timeout : {2.0, 8.0, 32.0}) {  // until it is longer than building a map
    use(first);
    auto running = std::async(std::launch::async, [&, timeout] {
      return ask<agrid_map::PlanPath>("agrid/plan_path", slowRequest(timeout));
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    use(second);
    const auto response = running.get();
    remarked = response.status.message.find(remark) != std::string::npos;
    if (!remarked) continue;
    EXPECT_EQ(response.map_id, digestOf(first));
    EXPECT_EQ(response.status.code, int{Status::SUCCESS}) << response.status.message;
    break;
  }
  EXPECT_TRUE(remarked);
}

TEST_F(PlanLoad, P14_UnloadingCancelsThePlansThatRunAndThoseThatWait) {
  for (const char* name : {"loaded/max_parallel_plans", "loaded/max_queued_plans"}) {
    ros::param::set(name, 1);
  }
  ros::param::set("loaded/timeout", 60.0);
  ros::param::set("loaded/static_map_wait", 0.0);
  useTwoRooms();
  nodelet::NodeletLoad::Request load;
  load.name = "/loaded";
  load.type = "agrid_map/AGridNodelet";
  ASSERT_TRUE(ask<nodelet::NodeletLoad>("manager/load_nodelet", load).success);
  ASSERT_TRUE(
      eventually([&] { return statusOf("loaded", pathRequest()) == int{Status::SUCCESS}; }));
  std::atomic<bool> busy{false};
  const auto insist = [&] {
    int status = statusOf("loaded", slowRequest(60));
    while (status == int{Status::BUSY}) {
      busy = true;
      status = statusOf("loaded", slowRequest(60));
    }
    return status;
  };
  const auto begin = std::chrono::steady_clock::now();
  std::vector<std::future<int>> calls;
  for (int i = 0; i < 3; ++i) calls.push_back(std::async(std::launch::async, insist));
  EXPECT_TRUE(eventually([&] { return busy.load(); }));  // so one runs and one waits
  nodelet::NodeletUnload::Request unload;
  unload.name = load.name;
  EXPECT_TRUE(ask<nodelet::NodeletUnload>("manager/unload_nodelet", unload).success);
  std::map<int, int> counts;
  for (auto& call : calls) ++counts[call.get()];
  EXPECT_GE(counts[Status::CANCELLED], 2);
  EXPECT_EQ(counts[Status::CANCELLED] + counts[-1], 3);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
}

}  // namespace
}  // namespace agrid_map_ros
