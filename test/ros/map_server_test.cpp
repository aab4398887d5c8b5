// SPDX-License-Identifier: BSD-3-Clause
#include "agrid_map_ros/map_server.h"

#include <gtest/gtest.h>
#include <nav_msgs/LoadMap.h>

#include "agrid_map_ros/conversions.h"
#include "support/map_files.h"

namespace agrid_map_ros {
namespace {

using agrid::FileErrorCode;
using agrid::OccupancyMap;
using agrid::test::expectFileError;
using agrid::test::MapFolder;
using agrid::test::mapYaml;
using agrid::test::smallPgm;

agrid::LoadedMap loadedWith(const std::string& line) {
  return MapFolder(smallPgm(), mapYaml(line)).load();
}

TEST(MapServer, MessageIsMapServers) {
  const auto message = mapServerMessage(loadedWith("origin: [-1.5, 2.25, 0.7]"), "floor");
  EXPECT_EQ(message.header.frame_id, "floor");
  EXPECT_TRUE(message.header.stamp.isZero());
  EXPECT_EQ(message.info.width, 3u);
  EXPECT_EQ(message.info.height, 1u);
  EXPECT_EQ(message.info.resolution, 0.05f);
  EXPECT_EQ(message.info.origin.position.x, -1.5);
  EXPECT_EQ(message.info.origin.position.y, 2.25);
  EXPECT_EQ(message.info.origin.position.z, 0);
  EXPECT_EQ(message.info.origin.orientation.x, 0);
  EXPECT_EQ(message.info.origin.orientation.y, 0);
  EXPECT_EQ(message.info.origin.orientation.z, 0.34289780259132385);
  EXPECT_EQ(message.info.origin.orientation.w, 0.939372718334198);
  EXPECT_EQ(message.data, (std::vector<std::int8_t>{0, -1, 100}));
}

TEST(MapServer, AMapFromTheMessageHasTheFingerprintOfTheFile) {
  for (const std::string yaw : {"0", "0.7", "-0.7", "3.14159265", "1.5707963", "6.5", "-100.25"}) {
    const agrid::LoadedMap loaded = loadedWith("origin: [-1.5, 2.25, " + yaw + "]");
    const ReceivedMap received = fromMsg(mapServerMessage(loaded, "map"));
    EXPECT_EQ(OccupancyMap(received.grid).digest(), OccupancyMap(loaded.grid).digest()) << yaw;
  }
}

TEST(MapServer, PathsOfUrls) {
  EXPECT_EQ(pathOfUrl("/a/b%20c.yaml"), "/a/b%20c.yaml");
  EXPECT_EQ(pathOfUrl("b.yaml"), "b.yaml");
  EXPECT_EQ(pathOfUrl("a/b://c.yaml"), "a/b://c.yaml");
  EXPECT_EQ(pathOfUrl(""), "");
  EXPECT_EQ(pathOfUrl("file:///a/b%20c%C3%a9.yaml"), "/a/b c\xC3\xA9.yaml");
  EXPECT_EQ(pathOfUrl("file://localhost/a.yaml"), "/a.yaml");
  EXPECT_EQ(pathOfUrl("file:///%2541"), "/%41");
}

TEST(MapServer, UrlsThatAreRefused) {
  const auto expectRefused = [](const std::string& part, const std::string& url) {
    expectFileError(FileErrorCode::kPath, part, [&url] { pathOfUrl(url); });
  };
  expectRefused("only file:// URLs", "http://host/a.yaml");
  expectRefused("only file:// URLs", "package://agrid_map/a.yaml");
  expectRefused("another host", "file://host/a.yaml");
  expectRefused("absolute path", "file://a.yaml");
  for (const std::string end : {"%", "%4", "%4g", "%g4"}) {
    expectRefused("hexadecimal", "file:///a" + end);
  }
  expectRefused("\\x1b", "http://\x1B[2J");
}

TEST(MapServer, ResultsOfFailures) {
  using Response = nav_msgs::LoadMap::Response;
  EXPECT_EQ(loadMapResult(FileErrorCode::kPath), Response::RESULT_MAP_DOES_NOT_EXIST);
  EXPECT_EQ(loadMapResult(FileErrorCode::kYaml), Response::RESULT_INVALID_MAP_METADATA);
  EXPECT_EQ(loadMapResult(FileErrorCode::kImage), Response::RESULT_INVALID_MAP_DATA);
  EXPECT_EQ(loadMapResult(FileErrorCode::kIo), Response::RESULT_UNDEFINED_FAILURE);
}

}  // namespace
}  // namespace agrid_map_ros
