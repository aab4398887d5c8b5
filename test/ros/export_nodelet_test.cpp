// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <fstream>
#include <iterator>

#include <agrid_map/AddTag.h>
#include <agrid_map/SaveMap.h>

#include "nodelet_client.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;
using agrid_map::Tag;

/// Talks to the nodelets of agrid_tags.test.
class ExportNodelet : public test::NodeletClient {};

TEST_F(ExportNodelet, OtherFormatsAreSavedBesideWhatIsStored) {
  useTwoRooms();
  agrid_map::AddTag::Request add;
  add.tag.type = Tag::OBJECT;
  add.tag.name = "samovar";
  add.tag.source = Tag::MANUAL;
  add.tag.pose.position.x = 2.5;
  add.tag.pose.position.y = 3.5;
  ASSERT_EQ(ask<agrid_map::AddTag>("agrid/add_tag", add).status.code, Status::SUCCESS);
  std::string directory;
  ASSERT_TRUE(ros::param::get("agrid/storage_dir", directory));
  agrid_map::SaveMap::Request save;
  for (const char* name :
       {"a.geojson", "a.nav2.geojson", "a.graphml", "a.dot", "a.svg", "a.labels.png", "a.pl"}) {
    save.name = name;
    EXPECT_EQ(ask<agrid_map::SaveMap>("agrid/save_map", save).status.code, Status::SUCCESS) << name;
    std::ifstream file(directory + "/" + name, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const bool has_objects = save.name != "a.labels.png" && save.name != "a.nav2.geojson";
    EXPECT_EQ(bytes.find("samovar") != std::string::npos, has_objects) << name;
    EXPECT_FALSE(bytes.empty()) << name;
    EXPECT_EQ(std::remove((directory + "/" + name).c_str()), 0) << name;
  }
  for (const char* bad : {"../x.svg", "/tmp/x.svg", ".svg", "a b.svg", "x.yaml.svg"}) {
    save.name = bad;
    EXPECT_NE(ask<agrid_map::SaveMap>("agrid/save_map", save).status.code, Status::SUCCESS) << bad;
  }
}

}  // namespace
}  // namespace agrid_map_ros
