// SPDX-License-Identifier: BSD-3-Clause
// Parameters that change while the nodelet runs.
#include <dynamic_reconfigure/Reconfigure.h>
#include <std_srvs/Trigger.h>

#include "nodelet_client.h"

namespace agrid_map_ros {
namespace {

class Tuned : public test::NodeletClient {
 protected:
  using Config = dynamic_reconfigure::Config;

  void TearDown() override {
    set(Config{});  // waits until the last change was taken
    ros::param::set("agrid/robot_radius", 0.2);
    ros::param::set("agrid/canny_low", 1.0);
    EXPECT_TRUE(ask<std_srvs::Trigger>("agrid/rebuild").success);
  }

  static void add(Config& config, const std::string& name, double value) {
    config.doubles.emplace_back();
    config.doubles.back().name = name;
    config.doubles.back().value = value;
  }

  /// @return all values as they are then
  Config set(const Config& config) {
    dynamic_reconfigure::Reconfigure::Request request;
    request.config = config;
    return ask<dynamic_reconfigure::Reconfigure>("agrid/set_parameters", request).config;
  }

  static double numberIn(const Config& config, const std::string& name) {
    for (const auto& number : config.doubles) {
      if (number.name == name) return number.value;
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

  static double onServer(const std::string& name) {
    return ros::param::param<double>("agrid/" + name, -1);
  }
};

TEST_F(Tuned, AChangeBuildsTheMapAnew) {
  useTwoRooms();
  const std::uint32_t version = graph().version;
  EXPECT_EQ(pathStatus(pathRequest()), int{agrid_map::Status::SUCCESS});
  Config wide;
  add(wide, "robot_radius", 0.8);  // the door is 1 m wide
  EXPECT_EQ(numberIn(set(wide), "robot_radius"), 0.8);
  EXPECT_TRUE(test::eventually([&] { return graph().version > version; }));
  EXPECT_EQ(pathStatus(pathRequest()), int{agrid_map::Status::NO_ROUTE});
  EXPECT_EQ(onServer("robot_radius"), 0.8);
}

TEST_F(Tuned, R2_AContradictionChangesNothing) {
  useTwoRooms();
  const std::uint32_t version = graph().version;
  Config crossed;
  add(crossed, "canny_low", 60);  // more than canny_high
  add(crossed, "robot_radius", 0.8);
  const Config now = set(crossed);
  EXPECT_EQ(numberIn(now, "canny_low"), 1);
  EXPECT_EQ(numberIn(now, "robot_radius"), 0.2);
  EXPECT_EQ(onServer("canny_low"), 1);
  use(test::drawn(test::walledUp()));
  EXPECT_EQ(graph().version, version + 1);  // the new map and nothing else
}

TEST_F(Tuned, R6_RebuildShowsWhatWasSetOnTheParameterServer) {
  useTwoRooms();
  ros::param::set("agrid/robot_radius", 0.3);
  EXPECT_TRUE(ask<std_srvs::Trigger>("agrid/rebuild").success);
  EXPECT_EQ(numberIn(set(Config{}), "robot_radius"), 0.3);
}

}  // namespace
}  // namespace agrid_map_ros
