// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tools/eval_fixture.h"

namespace agrid::tools {
namespace {

using test::TemporaryFolder;

TEST(EvalCommand, ScoresPlainAndFurnishedPlansApart) {
  const TemporaryFolder temp;
  drawMap(temp, "office");
  drawMap(temp, "office_furnitures", true);
  drawWhiteRooms(temp / "office_gt_segmentation.png");
  const Outcome outcome = eval({temp.path(), "--csv", temp / "scores.csv"});
  EXPECT_EQ(outcome.code, kDone) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("| plain"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("| furnished"), std::string::npos) << outcome.out;
  const std::string csv = test::contentsOf(temp / "scores.csv");
  for (const char* name : {"office,plain,as given,", "office_furnitures,furnished,as given,"}) {
    EXPECT_GT(std::stod(cell(csv, name, "iou_all")), 0.97) << csv;
    EXPECT_EQ(cell(csv, name, "f1_50"), "1.000000") << csv;
    EXPECT_EQ(cell(csv, name, "door_precision"), "1.000000") << csv;
    EXPECT_EQ(cell(csv, name, "door_recall"), "1.000000") << csv;
    EXPECT_EQ(cell(csv, name, "areas"), "2") << csv;
  }
  EXPECT_LT(std::stod(cell(csv, "office_furnitures,", "recall")),
            std::stod(cell(csv, "office_furnitures,", "recall_free")));
}

TEST(EvalCommand, ReadsEveryFormatOfRoomsAlike) {
  const TemporaryFolder temp;
  drawMapFolder(temp);
  const auto iou = [&](const std::string& file) {
    const Outcome outcome = eval({temp.path(), "--csv", temp / "scores.csv"});
    EXPECT_EQ(outcome.code, kDone) << file << outcome.err;
    std::filesystem::remove(temp / ("office/" + file));
    return cell(test::contentsOf(temp / "scores.csv"), "office,folder,", "iou_all");
  };
  drawWhiteRooms(temp / "office/rooms_gt.png");
  const std::string white = iou("rooms_gt.png");
  EXPECT_GT(std::stod(white), 0.97);

  cv::Mat3b coloured(kHeight, kWidth, cv::Vec3b(90, 90, 90));
  coloured(kLeft).setTo(cv::Scalar(200, 20, 20));
  coloured(kRight).setTo(cv::Scalar(20, 20, 200));
  cv::imwrite(temp / "office/rooms_gt.png", coloured);
  EXPECT_EQ(iou("rooms_gt.png"), white);

  cv::Mat1w numbers(kHeight, kWidth, std::uint16_t{0});
  numbers(kLeft) = 700;
  numbers(kRight) = 3;
  cv::imwrite(temp / "office/rooms.png", numbers);
  EXPECT_EQ(iou("rooms.png"), white);

  cv::Mat1b locations(kHeight, kWidth, std::uint8_t{255});
  locations(kLeft) = 0;
  locations(kRight) = 1;
  cv::imwrite(temp / "office/locations.png", locations);
  EXPECT_EQ(iou("locations.png"), white);

  temp.write("office/rooms.yaml",
             "- {name: left, polygon: [[0.5, 0.5], [4.0, 0.5], [4.0, 3.5], [0.5, 3.5]]}\n"
             "- {name: right, polygon: [[4.2, 0.5], [8.0, 0.5], [8.0, 3.5], [4.2, 3.5]]}\n");
  EXPECT_EQ(iou("rooms.yaml"), white);
}

TEST(EvalCommand, PolygonsMayCoverWalls) {
  const TemporaryFolder temp;
  drawMapFolder(temp);
  temp.write("office/rooms.yaml",
             "- {name: left, polygon: [[0, 0], [4.1, 0], [4.1, 3.5], [0, 3.5]]}\n"
             "- {name: right, polygon: [[4.1, 0], [8.5, 0], [8.5, 3.5], [4.1, 3.5]]}\n"
             "- {name: wall, polygon: [[0, 3.5], [8.5, 3.5], [8.5, 4], [0, 4]]}\n");
  ASSERT_EQ(eval({temp / "office", "--csv", temp / "scores.csv"}).code, kDone);
  const std::string csv = test::contentsOf(temp / "scores.csv");
  EXPECT_EQ(cell(csv, "office,", "rooms"), "2");
  EXPECT_EQ(cell(csv, "office,", "door_recall"), "1.000000") << "nothing leads through the wall";
}

TEST(EvalCommand, DoorsFromFilesCountWhereTheyAre) {
  const TemporaryFolder temp;
  drawMapFolder(temp);
  drawWhiteRooms(temp / "office/rooms_gt.png");
  const auto scores = [&] {
    EXPECT_EQ(eval({temp / "office", "--csv", temp / "scores.csv"}).code, kDone);
    return test::contentsOf(temp / "scores.csv");
  };
  temp.write("office/doors.csv", "x1,y1,x2,y2\n81.5,30,81.5,49\n20,10,40,10\n");
  std::string csv = scores();
  EXPECT_EQ(cell(csv, "office,", "door_recall"), "0.500000") << csv;
  EXPECT_EQ(cell(csv, "office,", "door_precision"), "1.000000") << csv;
  temp.write("office/doors.yaml",
             "- name: d1\n  door_corner_pt_1: [4.1, 1.5]\n  door_corner_pt_2: [4.1, 2.5]\n");
  csv = scores();
  EXPECT_EQ(cell(csv, "office,", "door_recall"), "1.000000") << csv;
  EXPECT_EQ(cell(csv, "office,", "door_precision"), "") << "the list need not be complete";
}

TEST(EvalCommand, TruthMayLieApart) {
  const TemporaryFolder maps;
  const TemporaryFolder truth;
  drawMapFolder(maps);
  std::filesystem::create_directory(truth / "office");
  drawWhiteRooms(truth / "office/rooms_gt.png");
  EXPECT_EQ(eval({maps.path()}).code, kFileFailed);
  EXPECT_EQ(eval({maps.path(), "--truth", truth.path()}).code, kDone);
  EXPECT_EQ(eval({maps / "office", "--truth", truth / "office"}).code, kDone);
}

TEST(EvalCommand, GeneratedOfficesScoreThemselves) {
  const TemporaryFolder temp;
  testing::internal::CaptureStdout();
  ASSERT_EQ(run({"agrid_map_tool", "generate", "--size", "300", "-o", temp / "office"}), kDone);
  testing::internal::GetCapturedStdout();
  const Outcome outcome = eval({temp / "office/", "--csv", temp / "scores.csv"});
  EXPECT_EQ(outcome.code, kDone) << outcome.err;
  const std::string csv = test::contentsOf(temp / "scores.csv");
  EXPECT_GT(std::stod(cell(csv, "office,folder,", "iou_all")), 0.5) << csv;
}

TEST(EvalCommand, RobustnessShowsEachView) {
  const TemporaryFolder temp;
  drawMap(temp, "office");
  drawWhiteRooms(temp / "office_gt_segmentation.png");
  const Outcome outcome = eval({temp.path(), "--robustness", "--csv", temp / "scores.csv"});
  EXPECT_EQ(outcome.code, kDone) << outcome.err;
  const std::string csv = test::contentsOf(temp / "scores.csv");
  for (const char* view : {"as given", "turned by 7 deg", "turned by 45 deg", "at 0.1 m",
                           "at 0.025 m", "with noise"}) {
    EXPECT_NE(outcome.out.find(view), std::string::npos) << outcome.out;
    EXPECT_GT(std::stod(cell(csv, std::string("office,plain,") + view, "mcc")), 0.95) << csv;
  }
}

TEST(EvalCommand, TheNumberOfThreadsChangesNothing) {
  const TemporaryFolder temp;
  for (const char* name : {"a", "b", "c"}) {
    drawMap(temp, name, name[0] == 'b');
    drawWhiteRooms(temp / (std::string(name) + "_gt_segmentation.png"));
  }
  const Outcome one = eval({temp.path(), "--threads", "1"});
  const Outcome many = eval({temp.path(), "--threads", "5"});
  EXPECT_EQ(one.code, kDone);
  EXPECT_EQ(one.out, many.out);
}

TEST(EvalCommand, ThePapersMethodAndParametersAreTaken) {
  const TemporaryFolder temp;
  drawMap(temp, "office");
  drawWhiteRooms(temp / "office_gt_segmentation.png");
  EXPECT_EQ(eval({temp.path(), "--method", "paper"}).code, kDone);
  // With islands of this size dropped nothing is left.
  const Outcome nothing = eval({temp.path(), "-p", "min_island_size=1e6"});
  EXPECT_NE(nothing.out.find("|  0.0000 |"), std::string::npos) << nothing.out;
}

TEST(EvalCommand, MapsWithoutTruthAreToldAndPassedOver) {
  const TemporaryFolder temp;
  drawMap(temp, "office");
  drawMap(temp, "other");
  drawWhiteRooms(temp / "office_gt_segmentation.png");
  const Outcome outcome = eval({temp.path()});
  EXPECT_EQ(outcome.code, kDone);
  EXPECT_EQ(outcome.err, "warning: other: no truth, passed over\n");
}

TEST(EvalCommand, F28_FoldersWithoutMapsOrTruthFail) {
  const TemporaryFolder temp;
  Outcome outcome = eval({temp.path()});
  EXPECT_EQ(outcome.code, kFileFailed);
  EXPECT_NE(outcome.err.find(temp.path() + ": no maps there"), std::string::npos) << outcome.err;
  drawMap(temp, "office");
  outcome = eval({temp.path()});
  EXPECT_EQ(outcome.code, kFileFailed);
  EXPECT_NE(outcome.err.find("no map has truth"), std::string::npos) << outcome.err;
  EXPECT_EQ(eval({temp / "none"}).code, kFileFailed);
  EXPECT_EQ(eval({temp.path(), "--truth", temp / "none"}).code, kFileFailed);
}

TEST(EvalCommand, F28_WrongTruthIsOneClearLine) {
  const TemporaryFolder temp;
  drawMapFolder(temp);
  const auto expectFailure = [&](const std::string& file, const std::string& part) {
    const Outcome outcome = eval({temp.path(), "--csv", temp / "scores.csv"});
    EXPECT_EQ(outcome.code, kFileFailed) << file;
    EXPECT_EQ(outcome.out, "") << file;
    EXPECT_NE(outcome.err.find(file), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(temp / "scores.csv"));
  };
  cv::imwrite(temp / "office/rooms_gt.png", cv::Mat1b(3, 4));
  expectFailure("rooms_gt.png", "4 x 3 pixels, the map has 170 x 80");
  temp.write("office/rooms_gt.png", "no picture");
  expectFailure("rooms_gt.png", "cannot be read");
  temp.write("office/rooms.yaml", "- {name: a}\n");
  expectFailure("rooms.yaml:1", "no key 'polygon'");
  temp.write("office/rooms.yaml", "\n- {polygon: [[0, 0], [1, 1]]}\n");
  expectFailure("rooms.yaml:2", "three points");
  temp.write("office/rooms.yaml", "- {polygon: [[0, 0], [1, 1], [2]]}\n");
  expectFailure("rooms.yaml:1", "[x, y]");
  temp.write("office/rooms.yaml", "- {polygon: [[0, 0], [1, 1], [2, .nan]]}\n");
  expectFailure("rooms.yaml:1", "finite");
  temp.write("office/rooms.yaml", "rooms: 3\n");
  expectFailure("rooms.yaml:1", "is no list");
  temp.write("office/rooms.yaml", "- [\n");
  expectFailure("rooms.yaml", "rooms.yaml:");
  temp.write("office/rooms.yaml", "[]");
  temp.write("office/doors.csv", "1,2,3\n");
  expectFailure("doors.csv:1", "x1,y1,x2,y2");
  temp.write("office/doors.csv", "x1,y1,x2,y2\n1,2,3,wide\n");
  expectFailure("doors.csv:2", "'wide' is no number");
}

}  // namespace
}  // namespace agrid::tools
