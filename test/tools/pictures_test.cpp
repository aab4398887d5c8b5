// SPDX-License-Identifier: BSD-3-Clause
#include "tools/pictures.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "agrid/pipeline.h"
#include "exchange/area_colors.h"
#include "support/ascii_map.h"

namespace agrid::tools {
namespace {

SemanticMap threeRooms() {
  std::vector<std::string> rows(30, "#" + std::string(88, '.') + "#");
  rows.front() = rows.back() = std::string(90, '#');
  for (const std::size_t wall : {30U, 60U}) {
    for (std::size_t y = 0; y < rows.size(); ++y) {
      if (y < 11 || y > 18) rows[y][wall] = '#';
    }
  }
  const auto map = std::make_shared<const OccupancyMap>(test::asciiGrid(rows, 0.1));
  return annotate(extractStructure(map, {}), {}, {});
}

double share(const cv::Mat& picture, const cv::Vec3b& color) {
  const auto same = std::count_if(picture.begin<cv::Vec3b>(), picture.end<cv::Vec3b>(),
                                  [&](const cv::Vec3b& c) { return c == color; });
  return static_cast<double>(same) / static_cast<double>(picture.total());
}

TEST(Pictures, SmallMapsAreEnlargedAndKeepTheirShape) {
  const SemanticMap map = threeRooms();
  for (const cv::Mat& picture : {drawWalls(map.structure), drawGrid(map.structure), drawAreas(map),
                                 drawGraph(map), drawEdges(cv::Mat::zeros(30, 90, CV_8UC1))}) {
    EXPECT_EQ(picture.size(), cv::Size(720, 240));
    EXPECT_EQ(picture.type(), CV_8UC3);
  }
}

TEST(Pictures, HugeMapsAreReduced) {
  const cv::Mat picture = drawEdges(cv::Mat::zeros(100, 9000, CV_8UC1));
  EXPECT_EQ(picture.cols, 4000);
  EXPECT_NEAR(picture.rows, 44, 1);
}

TEST(Pictures, OverviewShowsTheMapTwice) {
  const cv::Mat overview = drawOverview(threeRooms());
  EXPECT_EQ(overview.cols, 720);  // a wide map: one above the other
  EXPECT_EQ(overview.rows, 2 * 240 + 12);
  const cv::Mat before = overview.rowRange(0, 240);
  const cv::Mat after = overview.rowRange(252, 492);
  const auto colored = [](const cv::Mat& part) {
    return std::count_if(part.begin<cv::Vec3b>(), part.end<cv::Vec3b>(),
                         [](const cv::Vec3b& c) { return c[0] != c[1] || c[1] != c[2]; });
  };
  EXPECT_EQ(colored(before), 0);
  EXPECT_GT(colored(after), 240 * 720 / 2);
}

TEST(Pictures, AreasAreFilledWithTheirColors) {
  const SemanticMap map = threeRooms();
  ASSERT_EQ(map.area_map.areas.size(), 3U);
  const cv::Mat picture = drawAreas(map);
  for (const cv::Vec3b& color : areaColors(map.area_map)) {
    EXPECT_GT(share(picture, color), 0.2);
    EXPECT_LT(share(picture, color), 0.34);
  }
}

TEST(Pictures, DoorsAreBlueWhereTheyAre) {
  const SemanticMap map = threeRooms();
  const cv::Mat picture = drawAreas(map);
  ASSERT_EQ(map.area_map.doors.size(), 2U);
  for (const Door& door : map.area_map.doors) {
    const Point2 middle = door.jambs_map.midpoint() * 80;  // 8 px a pixel of 0.1 m
    const auto color =
        picture.at<cv::Vec3b>(static_cast<int>(240 - middle.y()), static_cast<int>(middle.x()));
    EXPECT_GT(color[0], color[2] + 80);
  }
}

TEST(AreaColors, NeighboursDifferAndIdsKeepTheirColors) {
  AreaMap map;
  for (std::uint32_t id = 1; id <= 40; ++id) {
    Area area;
    area.id = AreaId{id};
    map.areas.push_back(area);
  }
  const std::vector<cv::Vec3b> alone = areaColors(map);
  for (std::uint32_t a = 1; a <= 40; ++a) {
    for (std::uint32_t step : {1U, 5U, 8U, 13U}) {  // hues of such ids lie close together
      if (a + step > 40) continue;
      Door door;
      door.areas = {AreaId{a}, AreaId{a + step}};
      map.doors.push_back(door);
    }
  }
  const std::vector<cv::Vec3b> colors = areaColors(map);
  EXPECT_EQ(colors, areaColors(map));
  EXPECT_EQ(colors.front(), alone.front());
  for (const Door& door : map.doors) {
    const cv::Vec3b& a = colors[static_cast<std::size_t>(door.areas[0]) - 1];
    const cv::Vec3b& b = colors[static_cast<std::size_t>(door.areas[1]) - 1];
    EXPECT_GT(cv::norm(cv::Vec3i(a), cv::Vec3i(b), cv::NORM_INF), 15);
  }
}

}  // namespace
}  // namespace agrid::tools
