// SPDX-License-Identifier: BSD-3-Clause
#include "rviz_window.h"

namespace agrid_map_rviz::test {
namespace {

TEST_F(RvizWindow, ShowsAreasInColours) {
  EXPECT_TRUE(comesTrue([] {
    const QImage image = picture();
    const QColor left = image.pixelColor(pixelOf(2, 5));
    const QColor right = image.pixelColor(pixelOf(11, 5));
    return left.hsvSaturation() > 40 && right.hsvSaturation() > 40 &&
           std::abs(left.hsvHue() - right.hsvHue()) > 30;
  }));
}

}  // namespace
}  // namespace agrid_map_rviz::test
