// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "agrid/map/map_io.h"
#include "support/ascii_map.h"
#include "support/temporary_folder.h"
#include "tools/commands.h"

namespace agrid::tools {
namespace {

std::string contentOf(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

class PlanCommand : public testing::Test {
 protected:
  void SetUp() override {
    // The wall below is at the top in the image; the lower room is closed.
    saveMap(test::asciiGrid({"............", "............", "############", "............",
                             "............", "............"},
                            0.05),
            folder_.path("map.yaml"));
    folder_.write("pairs.csv",
                  "id,start_x_px,start_y_px,goal_x_px,goal_y_px\n"
                  "0,2,4,9,4\n1,2,1,2,4\n2,3,2,9,4\n3,2,4,3,2\n4,5,4,5,4\n");
  }
  int plan(std::vector<std::string> more) const {
    std::vector<std::string> words{
        "agrid_map_tool",          "plan", folder_.path("map.yaml"), "--pairs",
        folder_.path("pairs.csv"), "-o",   folder_.path("out.csv")};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  /// The rows without their milliseconds.
  std::vector<std::string> rows() const {
    std::ifstream file(folder_.path("out.csv"));
    std::vector<std::string> rows;
    for (std::string row; std::getline(file, row);) rows.push_back(row.substr(0, row.rfind(',')));
    return rows;
  }
  test::TemporaryFolder folder_;
};

TEST_F(PlanCommand, WritesARowForEachPairAndAFileForEachPath) {
  ASSERT_EQ(plan({"--robot-radius", "0.02", "--paths", folder_.path("paths")}), kDone);
  EXPECT_EQ(rows(), (std::vector<std::string>{"id,status,length_px", "0,SUCCESS,7.000000",
                                              "1,NO_ROUTE,", "2,START_INVALID,", "3,GOAL_INVALID,",
                                              "4,SUCCESS,0.000000"}));
  EXPECT_EQ(contentOf(folder_.path("paths/0.csv")), "x_px,y_px\n2,4\n9,4\n");
  EXPECT_EQ(contentOf(folder_.path("paths/4.csv")), "x_px,y_px\n5,4\n");
  EXPECT_FALSE(std::filesystem::exists(folder_.path("paths/1.csv")));
}

TEST_F(PlanCommand, SaysByItsExitCodeWhatFailed) {
  EXPECT_EQ(plan({"--robot-radius", "-1"}), kWrongUsage);
  EXPECT_EQ(plan({"--robot-radius", "wide"}), kWrongUsage);
  EXPECT_EQ(plan({"--planner", "Teleport"}), kFailed);
  std::filesystem::remove(folder_.path("pairs.csv"));
  EXPECT_EQ(plan({}), kFileFailed);
  EXPECT_FALSE(std::filesystem::exists(folder_.path("out.csv")));
}

TEST(PlanPairs, OfARealMapAreAnsweredTrulyAndTouchNothing) {
  const std::string shared = AGRID_SHARED;
  const std::string map = shared + "/maps/bormann/lab_ipa";
  const std::string pairs = shared + "/bench/planning_pairs/lab_ipa.csv";
  if (!std::filesystem::exists(pairs)) GTEST_SKIP() << "no pairs at " << pairs;
  const std::string python = "/usr/bin/python3 ";
  if (std::system((python + "-c 'import cv2, numpy, scipy'").c_str()) != 0) {
    GTEST_SKIP() << "the checker needs python3-opencv, python3-numpy and python3-scipy";
  }
  const test::TemporaryFolder folder;
  const std::string out = folder.path("out.csv");
  const std::string paths = folder.path("paths");
  ASSERT_EQ(run({"agrid_map_tool", "plan", map + ".yaml", "--pairs", pairs, "--robot-radius", "0.2",
                 "-o", out, "--paths", paths}),
            kDone);
  const auto tests = std::filesystem::path(AGRID_TEST_DATA).parent_path();
  const std::string checker = (tests / "tools" / "check_paths.py").string() + " ";
  EXPECT_EQ(
      std::system((python + checker + map + ".png " + pairs + " " + out + " " + paths).c_str()), 0);
}

}  // namespace
}  // namespace agrid::tools
