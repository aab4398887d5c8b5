// SPDX-License-Identifier: BSD-3-Clause
#include <QInputDialog>
#include <QLineEdit>
#include <cmath>

#include "rviz_window.h"

namespace agrid_map_rviz::test {
namespace {

using agrid_map::Tag;

class Tool : public RvizWindow {
 protected:
  void SetUp() override {
    RvizWindow::SetUp();
    tools().setCurrentTool(tool("agrid_map/TagTool"));
    key(Qt::Key_A);
  }
  void TearDown() override { tools().setCurrentTool(tools().getDefaultTool()); }

  static rviz::ToolManager& tools() { return *frame_->getManager()->getToolManager(); }
  static void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(view(), key, modifiers);
  }
  static QString action() {
    return tool("agrid_map/TagTool")
        ->getPropertyContainer()
        ->subProp("Action")
        ->getValue()
        .toString();
  }
  /// Types into the dialog that asks for a name.
  static void nameIt(const QString& name) {
    QInputDialog* dialog = nullptr;
    ASSERT_TRUE(comesTrue([&] {
      dialog = frame_->findChild<QInputDialog*>("tag_name");
      return dialog != nullptr && dialog->isVisible();
    }));
    auto* field = dialog->findChild<QLineEdit*>();
    QTest::keyClicks(field, name);
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_TRUE(comesTrue([] { return !frame_->findChild<QInputDialog*>("tag_name"); }));
  }
};

TEST_F(Tool, AClickNamesAnArea) {
  const QString before = areaAt(9.5, 3.5);
  click(9.5, 2.5);
  nameIt("lab");
  EXPECT_TRUE(becomesCalled(9.5, 3.5, "lab"));
  key(Qt::Key_U);
  EXPECT_TRUE(becomesCalled(9.5, 3.5, before));
}

TEST_F(Tool, AClickDropsAnObject) {
  key(Qt::Key_O);
  click(2, 5);
  nameIt("fridge");
  ASSERT_TRUE(comesTrue([this] { return now().objects.size() == 1; }));
  EXPECT_EQ(now().objects[0].category, "fridge");
  EXPECT_NEAR(now().objects[0].pose.position.x, 2, 0.1);
  EXPECT_NEAR(now().objects[0].pose.position.y, 5, 0.1);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(comesTrue([this] { return now().objects.empty(); }));
}

TEST_F(Tool, ADragPutsADoorIntoThePassage) {
  choose({areaAt(2.5, 3.5), areaAt(9.5, 3.5)});
  press("join");
  ASSERT_TRUE(areasBecome(2));
  key(Qt::Key_D);
  drag(6.4, 4.3, 6.6, 2.9);
  ASSERT_TRUE(areasBecome(3));
  const auto door = now().doors.at(0);
  EXPECT_NEAR(door.jambs[0].x, 6.5, 0.6) << "in the passage";
  EXPECT_NEAR(door.width, 1, 0.11) << "from jamb to jamb, however far the mouse went";
}

TEST_F(Tool, AClickCountsInTheFixedFrame) {
  geometry_msgs::TransformStamped world_from_map;
  world_from_map.header.stamp = ros::Time::now();
  world_from_map.header.frame_id = "world";
  world_from_map.child_frame_id = "map";
  world_from_map.transform.translation.x = 10;
  world_from_map.transform.rotation.z = world_from_map.transform.rotation.w = std::sqrt(0.5);
  broadcaster_.sendTransform(world_from_map);
  frame_->getManager()->setFixedFrame("world");
  QTest::qWait(100);
  key(Qt::Key_O);
  // (2, 4) of the map, a quarter turn to the left
  click(10 - 4, 2);
  nameIt("plant");
  EXPECT_TRUE(comesTrue([this] { return now().objects.size() == 1; }));
  frame_->getManager()->setFixedFrame("map");
  ASSERT_EQ(now().objects.size(), 1U);
  EXPECT_NEAR(now().objects[0].pose.position.x, 2, 0.1);
  EXPECT_NEAR(now().objects[0].pose.position.y, 4, 0.1);
}

TEST_F(Tool, AShortDragIsNoDoor) {
  const auto doors = given(Tag::DOOR).size();
  key(Qt::Key_D);
  drag(3, 3, 3.02, 3);
  QTest::qWait(200);
  EXPECT_EQ(given(Tag::DOOR).size(), doors);
}

TEST_F(Tool, KeysChooseTheAction) {
  key(Qt::Key_D);
  EXPECT_EQ(action(), "door");
  key(Qt::Key_O);
  EXPECT_EQ(action(), "object");
  key(Qt::Key_S);
  EXPECT_EQ(action(), "split");
  key(Qt::Key_A);
  EXPECT_EQ(action(), "area");
  key(Qt::Key_Escape);
  EXPECT_NE(tools().getCurrentTool(), tool("agrid_map/TagTool"));
}

}  // namespace
}  // namespace agrid_map_rviz::test
