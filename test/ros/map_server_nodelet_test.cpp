// SPDX-License-Identifier: BSD-3-Clause
#include <atomic>
#include <string>

#include <gtest/gtest.h>
#include <nav_msgs/GetMap.h>
#include <nav_msgs/LoadMap.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>

namespace {

using Results = nav_msgs::LoadMap::Response;
const ros::Duration kPatience(30);

nav_msgs::OccupancyGridConstPtr latched(const std::string& ns) {
  return ros::topic::waitForMessage<nav_msgs::OccupancyGrid>(ns + "/map", kPatience);
}

nav_msgs::LoadMap::Response changeMap(const std::string& ns, const std::string& url) {
  nav_msgs::LoadMap call;
  call.request.map_url = url;
  call.response.result = 77;
  EXPECT_TRUE(ros::service::waitForService(ns + "/change_map", kPatience));
  EXPECT_TRUE(ros::service::call(ns + "/change_map", call)) << url;
  return call.response;
}

std::string inFolder(const std::string& name) {
  std::string folder;
  ros::param::get("~folder", folder);
  return folder + "/" + name;
}

nav_msgs::OccupancyGrid staticMap(const std::string& ns) {
  nav_msgs::GetMap call;
  EXPECT_TRUE(ros::service::waitForService(ns + "/static_map", kPatience));
  EXPECT_TRUE(ros::service::call(ns + "/static_map", call));
  return call.response.map;
}

const std::vector<std::int8_t> kFirst = {100, 100, 100, 100, 0, -1, -1, 0, 0, 0, 0, 0};
const std::vector<std::int8_t> kSecond = {100, 0};

TEST(MapServerNodelet, OffersTheMapAsMapServerDoes) {
  const auto map = latched("open");
  ASSERT_TRUE(map);
  EXPECT_EQ(map->header.frame_id, "floor");
  EXPECT_EQ(map->data, kFirst);
  EXPECT_EQ(map->info.width, 4u);
  EXPECT_EQ(map->info.resolution, 0.05f);
  EXPECT_EQ(map->info.origin.orientation.z, 0.34289780259132385);
  EXPECT_FALSE(map->info.map_load_time.isZero());
  EXPECT_GE(map->header.stamp, map->info.map_load_time);
  const auto metadata =
      ros::topic::waitForMessage<nav_msgs::MapMetaData>("open/map_metadata", kPatience);
  ASSERT_TRUE(metadata);
  EXPECT_EQ(*metadata, map->info);
  EXPECT_EQ(staticMap("open"), *map);
}

TEST(MapServerNodelet, ChangesTheMapAndKeepsItWhenAChangeFails) {
  ASSERT_TRUE(latched("open"));
  std::atomic<int> maps{0};
  ros::NodeHandle nh;
  const auto subscriber = nh.subscribe<nav_msgs::OccupancyGrid>(
      "open/map", 10, [&maps](const nav_msgs::OccupancyGridConstPtr&) { ++maps; });
  for (int i = 0; i < 300 && maps == 0; ++i) ros::WallDuration(0.1).sleep();
  ASSERT_EQ(maps, 1);

  const auto changed = changeMap("open", "file://" + inFolder("second.yaml"));
  EXPECT_EQ(changed.result, Results::RESULT_SUCCESS);
  EXPECT_EQ(changed.map.data, kSecond);
  for (int i = 0; i < 300 && maps == 1; ++i) ros::WallDuration(0.1).sleep();
  EXPECT_EQ(maps, 2);
  EXPECT_EQ(staticMap("open").data, kSecond);

  EXPECT_EQ(changeMap("open", inFolder("nope.yaml")).result, Results::RESULT_MAP_DOES_NOT_EXIST);
  EXPECT_EQ(changeMap("open", inFolder("broken_no_origin.yaml")).result,
            Results::RESULT_INVALID_MAP_METADATA);
  EXPECT_EQ(changeMap("open", inFolder("broken_image.yaml")).result,
            Results::RESULT_INVALID_MAP_DATA);
  EXPECT_EQ(changeMap("open", "http://host/map.yaml").result, Results::RESULT_MAP_DOES_NOT_EXIST);
  EXPECT_EQ(staticMap("open").data, kSecond);

  EXPECT_EQ(changeMap("open", inFolder("first.yaml")).result, Results::RESULT_SUCCESS);
  for (int i = 0; i < 300 && maps == 2; ++i) ros::WallDuration(0.1).sleep();
  EXPECT_EQ(maps, 3);  // nothing was published of the changes that failed
  EXPECT_EQ(latched("open")->data, kFirst);
}

TEST(MapServerNodelet, F11_ChangeMapReadsOnlyUnderMapDir) {
  for (const std::string& path : {std::string("/etc/passwd"), inFolder("../served/../../x.yaml"),
                                  std::string("/etc/nothing")}) {
    const auto response = changeMap("open", path);
    EXPECT_EQ(response.result, Results::RESULT_MAP_DOES_NOT_EXIST) << path;
    EXPECT_TRUE(response.map.data.empty());
  }
}

TEST(MapServerNodelet, F11_ChangeMapIsRefusedWithoutMapDir) {
  ASSERT_TRUE(latched("closed"));
  EXPECT_EQ(changeMap("closed", inFolder("second.yaml")).result, Results::RESULT_UNDEFINED_FAILURE);
  EXPECT_EQ(staticMap("closed").data, kFirst);
  EXPECT_EQ(staticMap("closed").header.frame_id, "map");
}

TEST(MapServerNodelet, F1_AMissingFileLeavesANodeWithoutAMap) {
  EXPECT_EQ(changeMap("empty", inFolder("nope.yaml")).result, Results::RESULT_MAP_DOES_NOT_EXIST);
  EXPECT_FALSE(ros::service::exists("empty/static_map", false));
  EXPECT_EQ(changeMap("empty", inFolder("first.yaml")).result, Results::RESULT_SUCCESS);
  EXPECT_EQ(staticMap("empty").data, kFirst);
}

TEST(MapServerNodelet, R1_AParameterOfTheWrongTypeIsNotTakenForItsDefault) {
  EXPECT_EQ(changeMap("mistaken", inFolder("first.yaml")).result,
            Results::RESULT_UNDEFINED_FAILURE);
  EXPECT_FALSE(ros::service::exists("mistaken/static_map", false));
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "map_server_nodelet_test");
  ros::AsyncSpinner spinner(1);
  spinner.start();
  return RUN_ALL_TESTS();
}
