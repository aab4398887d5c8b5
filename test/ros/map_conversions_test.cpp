// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

#include "agrid_map_ros/conversions.h"
#include "support/ascii_map.h"

namespace agrid_map_ros {
namespace {

using agrid::MapErrorCode;

nav_msgs::OccupancyGrid message(std::uint32_t width = 3, std::uint32_t height = 2) {
  nav_msgs::OccupancyGrid map;
  map.header.frame_id = "map";
  map.info.width = width;
  map.info.height = height;
  map.info.resolution = 0.05F;
  map.info.origin.orientation.w = 1;
  if (std::uint64_t{width} * height < 1000000) map.data.assign(width * height, 0);
  return map;
}

/// With which code a map is refused; none: it is accepted.
std::optional<MapErrorCode> refusal(const nav_msgs::OccupancyGrid& map,
                                    const agrid::MapParams& params = {}) {
  try {
    agrid::OccupancyMap(fromMsg(map, params).grid, params);
  } catch (const agrid::MapError& error) {
    return error.code();
  }
  return std::nullopt;
}

void setQuaternion(nav_msgs::OccupancyGrid& map, double x, double y, double z, double w) {
  auto& q = map.info.origin.orientation;
  q.x = x;
  q.y = y;
  q.z = z;
  q.w = w;
}

TEST(MapOnTheWire, M1_DataShorterThanSize) {
  auto map = message();
  map.data.pop_back();
  EXPECT_EQ(refusal(map), MapErrorCode::kSize);
  try {
    checkMap(map, {});
  } catch (const agrid::MapError& error) {
    EXPECT_NE(std::string(error.what()).find("5 values"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("is 6"), std::string::npos) << error.what();
  }
}

TEST(MapOnTheWire, M2_DataLongerThanSize) {
  auto map = message();
  map.data.push_back(0);
  EXPECT_EQ(refusal(map), MapErrorCode::kSize);
}

TEST(MapOnTheWire, M3_NoPixels) {
  for (const auto& [width, height] :
       std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 0}, {0, 5}, {5, 0}}) {
    EXPECT_EQ(refusal(message(width, height)), MapErrorCode::kSize);
  }
}

TEST(MapOnTheWire, M4_OneRowOrColumn) {
  EXPECT_EQ(refusal(message(1, 1)), std::nullopt);
  EXPECT_EQ(refusal(message(1, 7)), std::nullopt);
  EXPECT_EQ(refusal(message(7, 1)), std::nullopt);
}

TEST(MapOnTheWire, M5_TooManyPixelsAreRefusedBeforeAnythingIsAllocated) {
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
  EXPECT_EQ(refusal(message(65536, 65536)), MapErrorCode::kCap);
  EXPECT_EQ(refusal(message(std::uint32_t{1} << 31, 1)), MapErrorCode::kCap);
  EXPECT_EQ(refusal(message(kMost, kMost)), MapErrorCode::kCap);
  agrid::MapParams params;
  params.max_pixels = 5;
  EXPECT_EQ(refusal(message(), params), MapErrorCode::kCap);
}

TEST(MapOnTheWire, M6_Resolution) {
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float bad : {0.0F, -0.0F, -1.0F, std::nanf(""), infinity, -infinity,
                          std::numeric_limits<float>::denorm_min(), 1e-9F, 1e9F, 0.00099F, 10.1F}) {
    auto map = message();
    map.info.resolution = bad;
    EXPECT_EQ(refusal(map), MapErrorCode::kResolution) << bad;
  }
  for (const float good : {0.001F, 10.0F}) {
    auto map = message();
    map.info.resolution = good;
    EXPECT_EQ(refusal(map), std::nullopt) << good;
  }
}

TEST(MapOnTheWire, M7_OriginPosition) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e6 + 1, -1e6 - 1}) {
    for (const bool in_x : {true, false}) {
      auto map = message();
      (in_x ? map.info.origin.position.x : map.info.origin.position.y) = bad;
      EXPECT_EQ(refusal(map), MapErrorCode::kOrigin) << bad;
    }
  }
}

TEST(MapOnTheWire, M8_ZeroQuaternionIsNoRotationWithOneWarning) {
  auto map = message();
  setQuaternion(map, 0, 0, 0, 0);
  const ReceivedMap received = fromMsg(map);
  EXPECT_EQ(received.grid.geometry.map_from_image.yaw, 0);
  EXPECT_EQ(received.warnings.size(), 1U);
}

TEST(MapOnTheWire, M9_QuaternionNorm) {
  auto map = message();
  setQuaternion(map, 0, 0, std::sin(0.4) * 1.0009, std::cos(0.4) * 1.0009);
  EXPECT_NEAR(fromMsg(map).grid.geometry.map_from_image.yaw, 0.8, 1e-12);
  setQuaternion(map, 0, 0, 0, 1.002);
  EXPECT_EQ(refusal(map), MapErrorCode::kOrigin);
  setQuaternion(map, 0, 0, 0, 0.998);
  EXPECT_EQ(refusal(map), MapErrorCode::kOrigin);
  setQuaternion(map, 0, 0, std::nan(""), 1);
  EXPECT_EQ(refusal(map), MapErrorCode::kOrigin);
  setQuaternion(map, 0, HUGE_VAL, 0, 1);
  EXPECT_EQ(refusal(map), MapErrorCode::kOrigin);
}

TEST(MapOnTheWire, M10_TiltedOrigin) {
  auto map = message();
  setQuaternion(map, std::sin(0.001), 0, 0, std::cos(0.001));  // 2e-3 rad of roll
  EXPECT_EQ(refusal(map), MapErrorCode::kOrigin);
  setQuaternion(map, 0, std::sin(0.001), 0, std::cos(0.001));
  EXPECT_EQ(refusal(map), MapErrorCode::kOrigin);
  setQuaternion(map, 1, 0, 0, 0);  // upside down
  EXPECT_EQ(refusal(map), MapErrorCode::kOrigin);
  setQuaternion(map, std::sin(0.0004), 0, 0, std::cos(0.0004));
  EXPECT_EQ(refusal(map), std::nullopt);
}

TEST(MapOnTheWire, M11_YawTurnsAboutTheOrigin) {
  auto map = message();
  map.info.origin.position.x = 2;
  map.info.origin.position.y = -1;
  setQuaternion(map, 0, 0, std::sin(M_PI / 4), std::cos(M_PI / 4));
  const agrid::MapGeometry geometry = fromMsg(map).grid.geometry;
  const agrid::Point2 center = geometry.center({2, 0});
  EXPECT_NEAR(center.x(), 2 - 0.025, 1e-6);
  EXPECT_NEAR(center.y(), -1 + 0.125, 1e-6);
}

TEST(MapOnTheWire, M12_Frame) {
  auto map = message();
  for (const std::string& bad : {std::string(), std::string("/"), std::string(257, 'm'),
                                 std::string("ma\np"), std::string("map\0x", 5)}) {
    map.header.frame_id = bad;
    EXPECT_EQ(refusal(map), MapErrorCode::kFrame) << bad.size();
  }
  map.header.frame_id = "/map";
  const ReceivedMap received = fromMsg(map);
  EXPECT_EQ(received.frame_id, "map");
  EXPECT_EQ(received.warnings.size(), 1U);
  map.header.frame_id = std::string(256, 'm');
  EXPECT_EQ(refusal(map), std::nullopt);
}

TEST(MapOnTheWire, M13_ValuesOutOfRangeAreUnknownOrRefused) {
  auto map = message();
  map.data = {-2, 101, -128, 127, -1, 100};
  const agrid::OccupancyMap taken(fromMsg(map).grid);
  EXPECT_FALSE(taken.warnings().empty());
  EXPECT_EQ(taken.at({0, 0}), agrid::Occupancy::kUnknown);
  EXPECT_EQ(taken.at({2, 1}), agrid::Occupancy::kOccupied);
  agrid::MapParams strict;
  strict.strict_values = true;
  EXPECT_EQ(refusal(map, strict), MapErrorCode::kValue);
}

TEST(MapOnTheWire, M25_StampDoesNotMatter) {
  auto map = message();
  const std::string digest = agrid::OccupancyMap(fromMsg(map).grid).digest();
  map.header.stamp = ros::Time(1e9);
  map.header.seq = 7;
  EXPECT_EQ(agrid::OccupancyMap(fromMsg(map).grid).digest(), digest);
}

TEST(MapOnTheWire, ThereAndBack) {
  const agrid::OccupancyMap map = agrid::test::asciiMap({"#.?", "..#"}, 0.25, {{1.5, -2.25}, 0.7});
  std_msgs::Header header;
  header.frame_id = "world";
  const ReceivedMap back = fromMsg(toMsg(map, header));
  EXPECT_EQ(back.frame_id, "world");
  EXPECT_EQ(agrid::OccupancyMap(back.grid).pixels(), map.pixels());
  EXPECT_EQ(back.grid.geometry.resolution, 0.25);
  EXPECT_NEAR(back.grid.geometry.map_from_image.yaw, 0.7, 1e-12);
  EXPECT_EQ(back.grid.geometry.map_from_image.position, agrid::Point2(1.5, -2.25));
}

// --- patches -------------------------------------------------------------------------------------

map_msgs::OccupancyGridUpdate update(int x, int y, std::uint32_t width, std::uint32_t height,
                                     std::size_t values) {
  map_msgs::OccupancyGridUpdate patch;
  patch.header.frame_id = "map";
  patch.x = x;
  patch.y = y;
  patch.width = width;
  patch.height = height;
  patch.data.assign(values, 100);
  return patch;
}

TEST(MapOnTheWire, PatchReplacesItsRectangle) {
  const auto result = patched(message(4, 3), update(1, 1, 2, 2, 4));
  const std::vector<std::int8_t> expected = {0, 0, 0, 0, 0, 100, 100, 0, 0, 100, 100, 0};
  EXPECT_EQ(result.data, expected);
}

TEST(MapOnTheWire, M22_PatchThatDoesNotFit) {
  const auto map = message(4, 3);
  constexpr std::uint32_t kHuge = std::uint32_t{1} << 31;
  for (const auto& bad :
       {update(-1, 0, 2, 2, 4), update(0, -1, 2, 2, 4), update(3, 0, 2, 2, 4),
        update(0, 2, 2, 2, 4), update(0, 0, 2, 2, 3), update(0, 0, 2, 2, 5), update(0, 0, 0, 2, 0),
        update(0, 0, 2, 0, 0), update(0, 0, kHuge, kHuge, 0), update(0, 0, kHuge, 2, 0),
        update(std::numeric_limits<int>::max(), 0, kHuge + kHuge - 1, 1, 4)}) {
    try {
      patched(map, bad);
      ADD_FAILURE() << "accepted at " << bad.x << ", " << bad.y;
    } catch (const agrid::MapError& error) {
      EXPECT_EQ(error.code(), MapErrorCode::kSize);
    }
  }
}

TEST(MapOnTheWire, M23_PatchInAnotherFrame) {
  auto patch = update(0, 0, 1, 1, 1);
  patch.header.frame_id = "odom";
  try {
    patched(message(), patch);
    ADD_FAILURE();
  } catch (const agrid::MapError& error) {
    EXPECT_EQ(error.code(), MapErrorCode::kFrame);
  }
  patch.header.frame_id = "/map";
  EXPECT_EQ(patched(message(), patch).data[0], 100);
}

}  // namespace
}  // namespace agrid_map_ros
