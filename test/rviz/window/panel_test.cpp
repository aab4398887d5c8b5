// SPDX-License-Identifier: BSD-3-Clause
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Path.h>

#include "rviz_window.h"

namespace agrid_map_rviz::test {
namespace {

using agrid_map::Door;
using agrid_map::Tag;

class Panel : public RvizWindow {
 protected:
  void SetUp() override {
    RvizWindow::SetUp();
    widget<QLineEdit>("search")->clear();
    widget<QComboBox>("start")->setCurrentIndex(0);
    left_ = areaAt(2.5, 3.5);
    right_ = areaAt(9.5, 3.5);
  }
  void renameLeft(const QString& name) {
    choose({areaAt(2.5, 3.5)});
    press("rename");
    type(name);
  }
  QString door() { return QString::fromStdString(now().doors.at(0).name); }
  bool doorBecomes(std::uint8_t state) {
    return comesTrue([&] { return now().doors.at(0).state == state; });
  }
  std::uint32_t putFridge() {
    agrid_map::AddTag::Request request;
    request.tag.type = Tag::OBJECT;
    request.tag.category = "fridge";
    request.tag.source = Tag::MANUAL;
    request.tag.pose = at(2, 5).pose;
    request.tag.pose.orientation.w = 1;
    const auto id = ask<agrid_map::AddTag>("agrid/add_tag", request).id;
    EXPECT_TRUE(comesTrue([] { return line("fridge") != nullptr; }));
    return id;
  }
  static bool says(const QString& text) {
    return comesTrue([&] { return answer().contains(text); });
  }

  QString left_, right_;
};

TEST_F(Panel, SearchHidesWhatDoesNotMatch) {
  QTest::keyClicks(widget<QLineEdit>("search"), right_.toUpper());
  EXPECT_FALSE(line(right_)->isHidden());
  EXPECT_TRUE(line(left_)->isHidden());
  EXPECT_FALSE(line(door())->isHidden()) << "the areas beside a door are in its line";
}

TEST_F(Panel, RenamesAnAreaAndTakesItBack) {
  renameLeft("kitchen");
  EXPECT_TRUE(becomesCalled(2.5, 3.5, "kitchen"));
  EXPECT_TRUE(comesTrue([] { return line("kitchen") != nullptr; }));
  press("undo");
  EXPECT_TRUE(becomesCalled(2.5, 3.5, left_));
}

TEST_F(Panel, RefusedNamesAreSentencesAndDoNotStayInTheList) {
  renameLeft("kitchen");
  ASSERT_TRUE(comesTrue([] { return line("kitchen") != nullptr; }));
  choose({right_});
  press("rename");
  type("Kitchen");
  EXPECT_TRUE(says("'")) << answer().toStdString();
  EXPECT_TRUE(answer().contains("kitchen", Qt::CaseInsensitive)) << answer().toStdString();
  EXPECT_NE(line(right_), nullptr);
  EXPECT_EQ(areaAt(9.5, 3.5), right_);
}

TEST_F(Panel, GivesACategoryAndTakesItBack) {
  const auto category = [this] { return now().areas.at(0).category; };
  choose({QString::fromStdString(now().areas.at(0).name)});
  press("category");
  type("office");
  EXPECT_TRUE(comesTrue([&] { return category() == "office"; }));
  ASSERT_TRUE(says("office"));
  press("undo");
  EXPECT_TRUE(comesTrue([&] { return category().empty(); }));
}

TEST_F(Panel, ClosesAndOpensADoor) {
  choose({door()});
  press("close");
  EXPECT_TRUE(doorBecomes(Door::CLOSED));
  ASSERT_TRUE(says("closed"));
  press("open");
  EXPECT_TRUE(doorBecomes(Door::OPEN));
  ASSERT_TRUE(says("open"));
  press("undo");
  EXPECT_TRUE(doorBecomes(Door::CLOSED));
  ASSERT_TRUE(says("taken back"));
  press("undo");
  EXPECT_TRUE(doorBecomes(Door::UNKNOWN));
}

TEST_F(Panel, JoinsTwoAreasAndPartsThemAgain) {
  choose({left_, right_});
  press("join");
  EXPECT_TRUE(areasBecome(2));
  ASSERT_TRUE(says("joined"));
  press("undo");
  EXPECT_TRUE(areasBecome(3));
}

TEST_F(Panel, SaysThatAreasWithoutADoorCannotBeJoined) {
  choose({left_, areaAt(14.5, 3.5)});
  press("join");
  EXPECT_TRUE(says("no door joins"));
}

TEST_F(Panel, DeletesAnObjectAndBringsItBack) {
  putFridge();
  choose({"fridge"});
  press("delete");
  EXPECT_TRUE(comesTrue([this] { return now().objects.empty(); }));
  EXPECT_TRUE(comesTrue([] { return line("fridge") == nullptr; }));
  ASSERT_TRUE(says("deleted: fridge"));
  press("undo");
  ASSERT_TRUE(comesTrue([this] { return now().objects.size() == 1; }));
  EXPECT_EQ(now().objects[0].category, "fridge");
  EXPECT_NEAR(now().objects[0].pose.position.y, 5, 1e-6);
}

TEST_F(Panel, PartsAnAreaByALineAndTakesItBack) {
  press("split");
  EXPECT_EQ(frame_->getManager()->getToolManager()->getCurrentTool(), tool("agrid_map/TagTool"));
  drag(1, 2.2, 6, 2.2);
  EXPECT_TRUE(areasBecome(4));
  ASSERT_TRUE(says("parted"));
  press("undo");
  EXPECT_TRUE(areasBecome(3));
}

TEST_F(Panel, PlansFromAnArea) {
  nav_msgs::Path path;
  const auto subscriber = nh_.subscribe<nav_msgs::Path>(
      "agrid/plan", 1, [&](const nav_msgs::PathConstPtr& message) { path = *message; });
  widget<QComboBox>("start")->setCurrentText(left_);
  choose({right_});
  press("plan");
  EXPECT_TRUE(comesTrue([&] { return path.poses.size() > 1; }));
  EXPECT_TRUE(says(left_ + " → " + right_));
}

TEST_F(Panel, SendsTheRobotToAnArea) {
  placeRobot(2.5, 3.5);
  std::vector<geometry_msgs::PoseStamped> goals;
  const auto subscriber = nh_.subscribe<geometry_msgs::PoseStamped>(
      "move_base_simple/goal", 1,
      [&](const geometry_msgs::PoseStampedConstPtr& message) { goals.push_back(*message); });
  choose({right_});
  ASSERT_TRUE(comesTrue([&] { return subscriber.getNumPublishers() == 1; }));
  press("go");
  ASSERT_TRUE(comesTrue([&] { return !goals.empty(); }));
  EXPECT_EQ(goals[0].header.frame_id, "map");
  EXPECT_EQ(areaAt(goals[0].pose.position.x, goals[0].pose.position.y), right_);
}

TEST_F(Panel, ShowsTheWaysThere) {
  widget<QComboBox>("start")->setCurrentText(left_);
  choose({right_});
  press("routes");
  auto* routes = widget<QListWidget>("route_list");
  ASSERT_TRUE(comesTrue([&] { return routes->count() == 1; }));
  EXPECT_TRUE(routes->item(0)->text().contains(left_ + " → " + right_));
}

TEST_F(Panel, SaysWhyThereIsNoWay) {
  widget<QComboBox>("start")->setCurrentText(left_);
  choose({areaAt(14.5, 3.5)});
  press("plan");
  EXPECT_TRUE(says("connect")) << answer().toStdString();
}

TEST_F(Panel, FollowsEachNewMapAndKeepsWhatIsTyped) {
  choose({left_});
  press("rename");
  auto* editor = list()->viewport()->findChild<QLineEdit*>();
  ASSERT_NE(editor, nullptr);
  QTest::keyClicks(editor, "lab");
  const QString closet = areaAt(14.5, 3.5);
  std::vector<std::string> rows = agrid_map_ros::test::twoRoomsAndACloset();
  for (std::string& row : rows) row.resize(13);
  use(agrid_map_ros::test::drawn(rows));
  EXPECT_TRUE(comesTrue([&] { return line(closet) == nullptr; }));
  ASSERT_EQ(list()->viewport()->findChild<QLineEdit*>(), editor);
  QTest::keyClick(editor, Qt::Key_Return);
  EXPECT_TRUE(becomesCalled(2.5, 3.5, "lab"));
}

}  // namespace
}  // namespace agrid_map_rviz::test
