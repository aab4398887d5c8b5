// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "agrid/evaluation/office_generator.h"
#include "agrid/map/map_io.h"
#include "support/temporary_folder.h"
#include "tools/commands.h"

namespace agrid::tools {
namespace {

using test::contentsOfFolder;
using test::TemporaryFolder;

int generate(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"agrid_map_tool", "generate"});
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int code = run(arguments);
  testing::internal::GetCapturedStdout();
  testing::internal::GetCapturedStderr();
  return code;
}

TEST(GenerateCommand, FilesGiveTheOfficeBack) {
  const TemporaryFolder temp;
  ASSERT_EQ(generate({"--size", "240", "--seed", "9", "-o", temp / "out"}), kDone);
  OfficeParams params;
  params.size = 240;
  params.seed = 9;
  const Office office = generateOffice(params);
  const LoadedMap loaded = loadMap(temp / "out/office.yaml");
  EXPECT_EQ(loaded.grid.values, office.grid.values);
  EXPECT_TRUE(loaded.warnings.empty());
  const cv::Mat rooms = cv::imread(temp / "out/rooms.png", cv::IMREAD_UNCHANGED);
  ASSERT_EQ(rooms.type(), CV_16UC1);
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 240; ++x) {
      ASSERT_EQ(
          rooms.at<std::uint16_t>(y, x),
          office.rooms[static_cast<std::size_t>(239 - y) * 240 + static_cast<std::size_t>(x)]);
    }
  }
  const std::string doors = test::contentsOf(temp / "out/doors.csv");
  EXPECT_EQ(static_cast<std::size_t>(std::count(doors.begin(), doors.end(), '\n')),
            office.doors_map.size() + 1);
}

TEST(GenerateCommand, SameSeedSameFiles) {
  const TemporaryFolder temp;
  ASSERT_EQ(generate({"--size", "200", "--seed", "4", "-o", temp / "a"}), kDone);
  ASSERT_EQ(generate({"--size", "200", "--seed", "4", "-o", temp / "b"}), kDone);
  ASSERT_EQ(
      generate({"--size", "200", "--seed", "4", "--no-noise", "--no-furniture", "-o", temp / "c"}),
      kDone);
  const auto a = contentsOfFolder(temp / "a");
  EXPECT_EQ(a.size(), 4U);
  EXPECT_EQ(a, contentsOfFolder(temp / "b"));
  auto c = contentsOfFolder(temp / "c");
  EXPECT_NE(a.at("office.pgm"), c.at("office.pgm"));
  EXPECT_EQ(a.at("rooms.png"), c.at("rooms.png"));
}

TEST(GenerateCommand, F28_ExistingOutputNeedsForce) {
  const TemporaryFolder temp;
  ASSERT_EQ(generate({"--size", "100", "-o", temp / "a"}), kDone);
  EXPECT_EQ(generate({"--size", "100", "-o", temp / "a"}), kWrongUsage);
  EXPECT_EQ(generate({"--size", "100", "-o", temp / "a", "--force"}), kDone);
}

}  // namespace
}  // namespace agrid::tools
