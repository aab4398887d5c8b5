// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <cmath>
#include <iostream>

#include <OgreRenderWindow.h>
#include <OgreViewport.h>
#include <rviz/display_group.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <visualization_msgs/MarkerArray.h>

#include <agrid_map/AGrid.h>

#include "rviz_window.h"

namespace agrid_map_rviz::test {
namespace {

class Display : public RvizWindow {
 protected:
  static rviz::Property& display() {
    rviz::DisplayGroup* root = frame_->getManager()->getRootDisplayGroup();
    for (int i = 0; i < root->numDisplays(); ++i) {
      if (root->getDisplayAt(i)->getClassId() == "agrid_map/SemanticMap") {
        return *root->getDisplayAt(i);
      }
    }
    throw std::runtime_error("the display was not loaded");
  }
  static void set(const char* property, const QVariant& value) {
    display().subProp(property)->setValue(value);
  }
  static QString statusOf(const char* part) {
    return display().childAt(0)->subProp(part)->getValue().toString();
  }
  static void setFixedFrame(const QString& frame) { frame_->getManager()->setFixedFrame(frame); }
  /// The colour of the area at a place, as ~markers gives it.
  std_msgs::ColorRGBA colorAt(double x, double y) {
    const auto markers = latched<visualization_msgs::MarkerArray>("agrid/markers");
    for (const auto& marker : markers->markers) {
      for (std::size_t i = 0; marker.ns == "areas" && i < marker.points.size(); i += 6) {
        const auto& low = marker.points[i];
        const auto& high = marker.points[i + 2];
        if (low.x <= x && x < high.x && low.y <= y && y < high.y) return marker.colors[i];
      }
    }
    ADD_FAILURE() << "no area at " << x << ", " << y;
    return {};
  }
  /// Whether a place of the view, a white floor, shows an area's colour laid over it.
  static bool shows(const QPoint& pixel, const std_msgs::ColorRGBA& area) {
    const QColor seen = picture().pixelColor(pixel);
    const auto near = [&](int value, float channel) {
      return std::abs(value - 255 * (0.55 + 0.45 * static_cast<double>(channel))) < 16;
    };
    return near(seen.red(), area.r) && near(seen.green(), area.g) && near(seen.blue(), area.b);
  }
  static int differences(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
      for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y);
    }
    return count;
  }
};

TEST_F(Display, FillsAreasWithTheColoursOfTheirIds) {
  for (const double x : {2.0, 9.0, 14.5}) {
    const auto color = colorAt(x, 5);
    EXPECT_TRUE(comesTrue([&] { return shows(pixelOf(x, 5), color); })) << x;
  }
}

TEST_F(Display, EachPartHasItsSwitch) {
  agrid_map::AddTag::Request fridge;
  fridge.tag.type = agrid_map::Tag::OBJECT;
  fridge.tag.source = agrid_map::Tag::MANUAL;
  fridge.tag.name = "fridge";
  fridge.tag.pose = at(10, 5).pose;
  fridge.tag.pose.orientation.w = 1;
  ask<agrid_map::AddTag>("agrid/add_tag", fridge);
  ASSERT_EQ(pathStatus(pathRequest()), agrid_map::Status::SUCCESS);
  ASSERT_TRUE(comesTrue([] { return line("fridge") != nullptr; }));
  QTest::qWait(300);
  const QImage all = picture();
  ASSERT_EQ(differences(all, picture()), 0) << "nothing moves";
  for (const char* part : {"Areas", "Names", "Doors", "Objects", "Graph", "Plan"}) {
    set(part, false);
    EXPECT_GT(differences(all, picture()), 20) << part;
    set(part, true);
    EXPECT_EQ(differences(all, picture()), 0) << part;
  }
  set("Cells", true);
  EXPECT_GT(differences(all, picture()), 500);
  set("Cells", false);
}

TEST_F(Display, LiesWhereTheMapLiesInTheFixedFrame) {
  geometry_msgs::TransformStamped world_from_map;
  world_from_map.header.stamp = ros::Time::now();
  world_from_map.header.frame_id = "world";
  world_from_map.child_frame_id = "map";
  world_from_map.transform.translation.x = 10;
  world_from_map.transform.rotation.z = world_from_map.transform.rotation.w = std::sqrt(0.5);
  broadcaster_.sendTransform(world_from_map);
  setFixedFrame("world");
  const auto color = colorAt(9.5, 5);
  // a quarter turn to the left: (x, y) of the map lies at (10 - y, x)
  EXPECT_TRUE(comesTrue([&] { return shows(pixelOf(10 - 5, 9.5), color); }));
  setFixedFrame("map");
  EXPECT_TRUE(comesTrue([&] { return shows(pixelOf(9.5, 5), color); }));
}

/// An A-Grid of 1000 x 1000 cells, with an area for every ten columns.
agrid_map::AGrid manyCells() {
  constexpr std::uint32_t kSide = 1000;
  agrid_map::AGrid grid;
  grid.header.frame_id = "map";
  grid.origin.orientation.w = 1;
  for (std::uint32_t i = 0; i <= kSide; ++i) grid.x.push_back(0.2 * i + (i % 2) * 0.05);
  grid.y = grid.x;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    grid.labels.push_back(1 + (i % kSide) / 10 + 100 * (i / kSide / 10));
  }
  grid.occupancy.resize(grid.labels.size());
  return grid;
}

using Clock = std::chrono::steady_clock;
double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// How long it takes to draw the view once [ms].
double frameTime(rviz::RenderPanel& view) {
  constexpr int kFrames = 30;
  Ogre::RenderTarget& target = *view.getViewport()->getTarget();
  const auto start = Clock::now();
  for (int i = 0; i < kFrames; ++i) target.update();
  return millisecondsSince(start) / kFrames;
}

TEST_F(Display, AMillionCellsDoNotStallIt) {
  const double small = frameTime(*view());
  set("Node", "big");
  ros::Publisher publisher = nh_.advertise<agrid_map::AGrid>("big/agrid", 1, true);
  auto* controller = frame_->getManager()->getViewManager()->getCurrent();
  controller->subProp("X")->setValue(101);
  controller->subProp("Y")->setValue(101);
  controller->subProp("Scale")->setValue(4);
  publisher.publish(manyCells());
  double longest = 0;
  const bool shown = comesTrue([&] {
    const auto start = Clock::now();
    QTest::qWait(1);
    longest = std::max(longest, millisecondsSince(start));
    return statusOf("Areas") == "1000000 cells";
  });
  EXPECT_TRUE(shown);
  const QImage image = picture();
  // two neighbouring areas
  const QColor left = image.pixelColor(pixelOf(100, 101));
  const QColor right = image.pixelColor(pixelOf(102, 101));
  EXPECT_GT(left.hsvSaturation(), 40);
  EXPECT_GT(std::abs(left.red() - right.red()) + std::abs(left.green() - right.green()) +
                std::abs(left.blue() - right.blue()),
            40);
  const double large = frameTime(*view());
  for (const char* property : {"Cells", "Areas"}) set(property, property == std::string("Cells"));
  const double lines = frameTime(*view());
  set("Cells", false);
  set("Areas", true);
  set("Node", "agrid");
  std::cout << "a frame: " << small << " ms; of a million cells: " << large
            << " ms, their lines: " << lines << " ms; the window waited at most " << longest
            << " ms while they came\n";
}

}  // namespace
}  // namespace agrid_map_rviz::test
