// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <csignal>

#include <std_msgs/String.h>
#include <std_srvs/Trigger.h>

#include <agrid_map/AddTag.h>
#include <agrid_map/ListTags.h>
#include <agrid_map/LoadMap.h>
#include <agrid_map/Query.h>
#include <agrid_map/RemoveTag.h>
#include <agrid_map/SaveMap.h>
#include <agrid_map/SetDoor.h>

#include "node_process.h"
#include "nodelet_client.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;
using agrid_map::Tag;

/// Talks to the nodelets of agrid_tags.test.
class TagsNodelet : public test::NodeletClient {
 protected:
  TagsNodelet() {
    tag_publisher_ = nh_.advertise<Tag>("agrid/tag", 10);
    say_publisher_ = nh_.advertise<std_msgs::String>("agrid/say", 10);
    click_publisher_ = nh_.advertise<geometry_msgs::PointStamped>("clicked_point", 10);
    said_subscriber_ = nh_.subscribe<std_msgs::String>(
        "agrid/said", 10, [this](const std_msgs::StringConstPtr& m) { said_.push_back(m->data); });
  }
  void SetUp() override {
    useTwoRooms();
    for (const Tag& tag : tags(0)) {
      // without a door that geometry finds, both rooms would be one
      if (tag.source != Tag::AUTOMATIC && tag.type != Tag::DOOR) remove(tag.type, tag.id);
    }
  }

  static Tag tag(std::uint8_t type, const std::string& name, double x, double y,
                 const std::string& frame = "") {
    Tag tag;
    tag.header.frame_id = frame;
    tag.type = type;
    tag.name = name;
    tag.pose.position.x = x;
    tag.pose.position.y = y;
    tag.source = Tag::MANUAL;
    return tag;
  }
  agrid_map::AddTag::Response add(const Tag& tag, bool replace = false) {
    agrid_map::AddTag::Request request;
    request.tag = tag;
    request.replace = replace;
    return ask<agrid_map::AddTag>("agrid/add_tag", request);
  }
  Status remove(std::uint8_t type, std::uint32_t id) {
    agrid_map::RemoveTag::Request request;
    request.type = type;
    request.id = id;
    return ask<agrid_map::RemoveTag>("agrid/remove_tag", request).status;
  }
  std::vector<Tag> tags(std::uint8_t type, const std::string& node = "agrid") {
    agrid_map::ListTags::Request request;
    request.type = type;
    return ask<agrid_map::ListTags>(node + "/list_tags", request).tags;
  }
  bool knows(std::uint8_t type, const std::string& name, const std::string& node = "agrid") {
    const auto all = tags(type, node);
    return std::any_of(all.begin(), all.end(), [&](const Tag& t) { return t.name == name; });
  }
  std::string areaNameAt(double x, double y) {
    const std::uint32_t id = areaAt(x, y);
    for (const auto& area : graph().areas) {
      if (area.id == id) return area.name;
    }
    return "";
  }
  std::string answerTo(const std::string& sentence) {
    EXPECT_TRUE(test::eventually([&] {
      return say_publisher_.getNumSubscribers() > 0 && said_subscriber_.getNumPublishers() > 0;
    }));
    said_.clear();
    std_msgs::String message;
    message.data = sentence;
    say_publisher_.publish(message);
    EXPECT_TRUE(test::eventually([this] {
      ros::spinOnce();
      return !said_.empty();
    }));
    return said_.empty() ? "" : said_.front();
  }

  ros::Publisher tag_publisher_;
  ros::Publisher say_publisher_;
  ros::Publisher click_publisher_;
  ros::Subscriber said_subscriber_;
  std::vector<std::string> said_;
};

TEST_F(TagsNodelet, AnAreaIsNamedAndItsNameTakenBack) {
  const auto added = add(tag(Tag::AREA, "kitchen", 2.5, 3.5));
  ASSERT_EQ(added.status.code, Status::SUCCESS) << added.status.message;
  EXPECT_EQ(areaNameAt(2.5, 3.5), "kitchen");
  EXPECT_EQ(areaAt(2.5, 3.5), added.id);
  EXPECT_EQ(remove(Tag::AREA, added.id).code, Status::SUCCESS);
  EXPECT_NE(areaNameAt(2.5, 3.5), "kitchen");
}

TEST_F(TagsNodelet, ADoorPartsAnAreaAndWithoutItThePartsAreOne) {
  const std::size_t before = graph().areas.size();
  Tag door = tag(Tag::DOOR, "curtain", 4.5, 3.5);
  door.pose.orientation.w = 1;
  agrid_map::AddTag::Request request;
  request.tag = door;
  request.force = true;
  const auto added = ask<agrid_map::AddTag>("agrid/add_tag", request);
  ASSERT_EQ(added.status.code, Status::SUCCESS) << added.status.message;
  EXPECT_EQ(graph().areas.size(), before + 1);
  EXPECT_NE(areaAt(2.5, 3.5), areaAt(5.5, 3.5));
  EXPECT_EQ(remove(Tag::DOOR, added.id).code, Status::SUCCESS);
  EXPECT_EQ(graph().areas.size(), before);
  EXPECT_EQ(areaAt(2.5, 3.5), areaAt(5.5, 3.5));
}

TEST_F(TagsNodelet, AClosedDoorIsNotPlannedThrough) {
  EXPECT_EQ(pathStatus(pathRequest()), Status::SUCCESS);
  agrid_map::SetDoor::Request request;
  request.door = graph().doors.at(0).name;
  request.state = agrid_map::Door::CLOSED;
  EXPECT_EQ(ask<agrid_map::SetDoor>("agrid/set_door", request).status.code, Status::SUCCESS);
  EXPECT_EQ(pathStatus(pathRequest()), Status::NO_ROUTE);
  request.state = agrid_map::Door::OPEN;
  EXPECT_EQ(ask<agrid_map::SetDoor>("agrid/set_door", request).status.code, Status::SUCCESS);
  EXPECT_EQ(pathStatus(pathRequest()), Status::SUCCESS);
  request.door = "no such door";
  EXPECT_EQ(ask<agrid_map::SetDoor>("agrid/set_door", request).status.code, Status::UNKNOWN_NAME);
  request.state = 7;
  EXPECT_EQ(ask<agrid_map::SetDoor>("agrid/set_door", request).status.code,
            Status::INVALID_REQUEST);
}

TEST_F(TagsNodelet, T14_TagsInOtherFramesAreBroughtToTheMaps) {
  place("camera", 9.0, 3.0, M_PI / 2);
  ASSERT_TRUE(test::eventually([&] {
    return add(tag(Tag::OBJECT, "fridge", 0.5, -0.5, "camera")).status.code == Status::SUCCESS;
  }));
  const auto objects = graph().objects;
  ASSERT_EQ(objects.size(), 1U);
  EXPECT_NEAR(objects[0].pose.position.x, 9.5, 1e-9);
  EXPECT_NEAR(objects[0].pose.position.y, 3.5, 1e-9);
  EXPECT_EQ(objects[0].area, areaAt(9.5, 3.5));
  placeRobot(2.5, 3.5);
  ASSERT_TRUE(test::eventually([&] {
    return add(tag(Tag::AREA, "315", 0, 0, "base_link")).status.code == Status::SUCCESS;
  }));
  EXPECT_EQ(areaNameAt(2.5, 3.5), "315");
  EXPECT_EQ(add(tag(Tag::OBJECT, "x", 0, 0, "nowhere")).status.code, Status::NO_TRANSFORM);
  EXPECT_EQ(add(tag(9, "x", 1, 1)).status.code, Status::INVALID_REQUEST);
}

TEST_F(TagsNodelet, T1_T2_T6_T13_WhatCannotBeIsRefusedEachWithItsConstant) {
  EXPECT_EQ(add(tag(Tag::OBJECT, "x", NAN, 0)).status.code, Status::INVALID_REQUEST);
  EXPECT_EQ(add(tag(Tag::OBJECT, "x", 900, 0)).status.code, Status::OUTSIDE);
  EXPECT_EQ(add(tag(Tag::AREA, "a\nb", 2.5, 3.5)).status.code, Status::INVALID_REQUEST);
  EXPECT_EQ(add(tag(Tag::AREA, "kitchen", 2.5, 3.5)).status.code, Status::SUCCESS);
  EXPECT_EQ(add(tag(Tag::AREA, "kitchen", 9.5, 3.5)).status.code, Status::NAME_TAKEN);
  EXPECT_EQ(remove(Tag::OBJECT, 4711).code, Status::UNKNOWN_NAME);
  EXPECT_EQ(remove(0, 1).code, Status::INVALID_REQUEST);
}

TEST_F(TagsNodelet, TagsAndClicksComeOverTopics) {
  ASSERT_TRUE(test::eventually([this] {
    return tag_publisher_.getNumSubscribers() > 0 && click_publisher_.getNumSubscribers() > 0;
  }));
  tag_publisher_.publish(tag(Tag::AREA, "lab", 9.5, 3.5));
  EXPECT_TRUE(test::eventually([&] { return knows(Tag::AREA, "lab"); }));
  geometry_msgs::PointStamped click;
  click.header.frame_id = "map";
  click.point.x = 3;
  click.point.y = 3;
  click_publisher_.publish(click);
  EXPECT_TRUE(test::eventually([&] { return graph().objects.size() == 1; }));
}

TEST_F(TagsNodelet, SentencesNameAndAsk) {
  placeRobot(2.5, 3.5);
  ASSERT_TRUE(test::eventually([&] {
    answerTo("this is the kitchen");
    return areaNameAt(2.5, 3.5) == "kitchen";
  }));
  answerTo("there is a fridge in front of you");
  EXPECT_EQ(graph().objects.size(), 1U);
  EXPECT_NE(answerTo("which room is this").find("kitchen"), std::string::npos);
  EXPECT_FALSE(answerTo("colourless green ideas").empty());
  agrid_map::Query::Request question;
  question.question = "in kitchen";
  const auto answer = ask<agrid_map::Query>("agrid/query", question);
  EXPECT_EQ(answer.status.code, Status::SUCCESS) << answer.status.message;
  EXPECT_EQ(answer.things.size(), 1U);
  answerTo("forget the fridge");
  EXPECT_TRUE(graph().objects.empty());
}

TEST_F(TagsNodelet, S11_MapsAreSavedAndLoadedByName) {
  add(tag(Tag::AREA, "kitchen", 2.5, 3.5));
  agrid_map::SaveMap::Request save;
  save.name = "monday.yaml";
  EXPECT_EQ(ask<agrid_map::SaveMap>("agrid/save_map", save).status.code, Status::SUCCESS);
  const std::uint32_t id = areaAt(2.5, 3.5);
  remove(Tag::AREA, id);
  agrid_map::LoadMap::Request load;
  load.name = "monday.yaml";
  EXPECT_EQ(ask<agrid_map::LoadMap>("agrid/load_map", load).status.code, Status::SUCCESS);
  EXPECT_EQ(areaNameAt(2.5, 3.5), "kitchen");
  EXPECT_EQ(areaAt(2.5, 3.5), id);
  for (const char* bad : {"../x.yaml", "/etc/passwd.yaml", ".x.yaml", "x.txt", "none.yaml"}) {
    load.name = save.name = bad;
    EXPECT_NE(ask<agrid_map::LoadMap>("agrid/load_map", load).status.code, Status::SUCCESS) << bad;
  }
}

TEST_F(TagsNodelet, L2_AllThatWasAcknowledgedIsThereAfterTheNodeIsKilled) {
  const auto added = add(tag(Tag::AREA, "kitchen", 2.5, 3.5));
  const auto fridge = add(tag(Tag::OBJECT, "fridge", 3, 3));
  ASSERT_EQ(fridge.status.code, Status::SUCCESS);
  ASSERT_EQ(kill(test::processOf("/agrid"), SIGKILL), 0);
  ASSERT_TRUE(test::eventually([&] {
    agrid_map::GetGraph service;
    return ros::service::call("agrid/get_graph", service) &&
           service.response.status.code == Status::SUCCESS;
  }));
  EXPECT_EQ(areaNameAt(2.5, 3.5), "kitchen");
  EXPECT_EQ(areaAt(2.5, 3.5), added.id);
  agrid_map::Query::Request question;
  question.question = "in kitchen";
  EXPECT_EQ(ask<agrid_map::Query>("agrid/query", question).things.size(), 1U);
  EXPECT_EQ(add(tag(Tag::OBJECT, "oven", 2, 2)).id, fridge.id + 1);
}

TEST_F(TagsNodelet, L12_TwoInstancesKnowTheirOwn) {
  add(tag(Tag::AREA, "kitchen", 2.5, 3.5));
  EXPECT_FALSE(knows(Tag::AREA, "kitchen", "other/agrid"));
}

TEST_F(TagsNodelet, RebuildKeepsWhatPeopleSaid) {
  const auto added = add(tag(Tag::AREA, "kitchen", 2.5, 3.5));
  const std::uint32_t version = graph().version;
  EXPECT_TRUE(ask<std_srvs::Trigger>("agrid/rebuild").success);
  EXPECT_TRUE(test::eventually([&] { return graph().version > version; }));
  EXPECT_EQ(areaNameAt(2.5, 3.5), "kitchen");
  EXPECT_EQ(areaAt(2.5, 3.5), added.id);
}

TEST_F(TagsNodelet, M21_OffTheMapATagWaitsAndComesBack) {
  add(tag(Tag::OBJECT, "fridge", 9.5, 3.5));
  std::vector<std::string> rows = test::twoRoomsAndACloset();
  for (std::string& row : rows) row = row.substr(0, 7);
  use(test::drawn(rows));
  const auto small = graph();
  EXPECT_TRUE(small.objects.empty());
  ASSERT_EQ(small.pending.size(), 1U);
  EXPECT_EQ(small.pending[0].name, "fridge");
  useTwoRooms();
  EXPECT_EQ(graph().objects.size(), 1U);
  EXPECT_TRUE(graph().pending.empty());
}

}  // namespace
}  // namespace agrid_map_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "agrid_tags_nodelet_test");
  ros::start();
  return RUN_ALL_TESTS();
}
