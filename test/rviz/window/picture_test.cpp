// SPDX-License-Identifier: BSD-3-Clause
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QScreen>
#include <cstdlib>

#include <rviz/view_controller.h>
#include <rviz/view_manager.h>

#include <agrid_map/SetDoor.h>

#include "home.h"
#include "rviz_window.h"

namespace agrid_map_rviz::test {
namespace {

using agrid_map::Tag;

/// The home with names, objects, a closed door, something that waits, and a way through it.
class Home : public RvizWindow {
 protected:
  void SetUp() override {
    use(home());
    const auto name = [this](const char* text, double x, double y) {
      put(Tag::AREA, text, x, y, 0, 0);
    };
    name("hall", 6, 4);
    name("kitchen", 2, 6.5);
    name("living room", 8, 6.5);
    name("bedroom", 2.5, 1.5);
    name("bath", 6.3, 1.5);
    name("office", 9.5, 1.5);
    name("garden", 6, -1);
    put(Tag::OBJECT, "fridge", 0.6, 7.4, 0.7, 0.7);
    put(Tag::OBJECT, "sofa", 10, 5.4, 2, 0.9);
    put(Tag::OBJECT, "printer", 11.3, 0.6, 0.5, 0.5);
    auto* controller = frame_->getManager()->getViewManager()->getCurrent();
    controller->subProp("X")->setValue(6);
    controller->subProp("Y")->setValue(3.4);
    controller->subProp("Scale")->setValue(44);
    ASSERT_TRUE(comesTrue([] { return line("printer") != nullptr; }));
  }

  void put(std::uint8_t type, const char* name, double x, double y, double width, double depth) {
    agrid_map::AddTag::Request request;
    request.tag.type = type;
    request.tag.name = name;
    request.tag.source = Tag::MANUAL;
    request.tag.pose = at(x, y).pose;
    request.tag.pose.orientation.w = 1;
    request.tag.size.x = width;
    request.tag.size.y = depth;
    const auto response = ask<agrid_map::AddTag>("agrid/add_tag", request);
    ASSERT_EQ(response.status.code, agrid_map::Status::SUCCESS) << response.status.message;
  }
  /// How many colours that are none of the map's cover a good part of the picture.
  static int colours(const QImage& image) {
    std::map<int, int> pixels_of_hue;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const QColor color = image.pixelColor(x, y);
        if (color.hsvSaturation() > 25) ++pixels_of_hue[color.hsvHue() / 12];
      }
    }
    int count = 0;
    for (const auto& hue : pixels_of_hue)
      count += hue.second > image.width() * image.height() / 100;
    return count;
  }
};

TEST_F(Home, ShowsAWholeHome) {
  for (const agrid_map::Door& door : now().doors) {
    const bool to_bath = door.jambs[0].x > 5.5 && door.jambs[0].x < 7.4 && door.jambs[0].y < 4;
    agrid_map::SetDoor::Request request;
    request.door = door.name;
    request.state = to_bath ? agrid_map::Door::CLOSED : agrid_map::Door::OPEN;
    if (to_bath || door.jambs[0].y > 5.5) ask<agrid_map::SetDoor>("agrid/set_door", request);
  }
  widget<QComboBox>("start")->setCurrentText("kitchen");
  choose({"office"});
  press("plan");
  ASSERT_TRUE(comesTrue([] { return answer().contains("hall → office"); }));
  press("routes");
  auto* routes = widget<QListWidget>("route_list");
  ASSERT_TRUE(comesTrue([&] { return routes->count() == 2; }));
  routes->setCurrentRow(1);
  QTest::qWait(500);
  EXPECT_GE(colours(picture()), 4);
  // doc/images is made of these runs
  if (const char* file = std::getenv("AGRID_RVIZ_PICTURE")) {
    QTest::qWait(1000);
    EXPECT_TRUE(qApp->primaryScreen()->grabWindow(0).save(file)) << file;
  }
  EXPECT_NE(line("garden"), nullptr) << "it waits: it is not on the map yet";
}

}  // namespace
}  // namespace agrid_map_rviz::test
