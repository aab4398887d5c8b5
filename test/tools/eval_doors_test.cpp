// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include <gtest/gtest.h>

#include "tools/door_tables.h"
#include "tools/eval_fixture.h"

namespace agrid::tools {
namespace {

using test::TemporaryFolder;

CaseScores withDoors(const std::string& name, const std::vector<JudgedDoor>& doors) {
  CaseScores scores;
  scores.about.name = name;
  scores.doors = doors;
  return scores;
}

JudgedDoor doorOf(double confidence, bool is_true) {
  return {1, DoorKind::kDoor, 1, confidence, is_true};
}

TEST(EvalDoors, EachDoorHasALine) {
  const TemporaryFolder temp;
  drawMap(temp, "office");
  drawWhiteRooms(temp / "office_gt_segmentation.png");
  const Outcome outcome = eval({temp.path(), "--doors", temp / "doors.csv"});
  EXPECT_EQ(outcome.code, kDone) << outcome.err;
  const std::string csv = test::contentsOf(temp / "doors.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2) << csv;
  EXPECT_EQ(cell(csv, "office,1,", "kind"), "DOOR") << csv;
  EXPECT_NEAR(std::stod(cell(csv, "office,1,", "width")), 1, 0.1) << csv;
  const double confidence = std::stod(cell(csv, "office,1,", "confidence"));
  EXPECT_GT(confidence, 0.5) << csv;
  EXPECT_LE(confidence, 1) << csv;
  EXPECT_EQ(cell(csv, "office,1,", "true"), "1") << csv;
  EXPECT_NE(outcome.out.find("| confidence"), std::string::npos) << outcome.out;
}

TEST(EvalDoors, ADoorWhereThereIsNoneIsNotTrue) {
  const TemporaryFolder temp;
  drawMapFolder(temp);
  drawWhiteRooms(temp / "office/rooms_gt.png");
  temp.write("office/doors.csv", "x1,y1,x2,y2\n20,10,40,10\n");
  ASSERT_EQ(eval({temp / "office", "--doors", temp / "doors.csv"}).code, kDone);
  const std::string csv = test::contentsOf(temp / "doors.csv");
  EXPECT_EQ(cell(csv, "office,1,", "true"), "0") << csv;
}

TEST(EvalDoors, WhereTheTrueOnesAreNotAllKnownNoneIsJudged) {
  const TemporaryFolder temp;
  drawMapFolder(temp);
  drawWhiteRooms(temp / "office/rooms_gt.png");
  temp.write("office/doors.yaml",
             "- name: d1\n  door_corner_pt_1: [4.1, 1.5]\n  door_corner_pt_2: [4.1, 2.5]\n");
  ASSERT_EQ(eval({temp / "office", "--doors", temp / "doors.csv"}).code, kDone);
  EXPECT_EQ(test::contentsOf(temp / "doors.csv"), "map,door,kind,width,confidence,true\n");
}

TEST(EvalDoors, OtherViewsAddNoDoors) {
  const TemporaryFolder temp;
  drawMap(temp, "office");
  drawWhiteRooms(temp / "office_gt_segmentation.png");
  ASSERT_EQ(eval({temp.path(), "--doors", temp / "one.csv"}).code, kDone);
  ASSERT_EQ(eval({temp.path(), "--robustness", "--doors", temp / "many.csv"}).code, kDone);
  EXPECT_EQ(test::contentsOf(temp / "many.csv"), test::contentsOf(temp / "one.csv"));
}

TEST(EvalDoors, ScoresAndDoorsNeedFilesOfTheirOwn) {
  const TemporaryFolder temp;
  const Outcome outcome = eval({temp.path(), "--csv", temp / "x", "--doors", temp / "x"});
  EXPECT_EQ(outcome.code, kWrongUsage);
  EXPECT_NE(outcome.err.find("the same file"), std::string::npos) << outcome.err;
}

TEST(EvalDoors, BinsHoldTheirLowerBound) {
  const std::vector<CaseScores> scores{
      withDoors("a", {doorOf(0, false), doorOf(0.5, true), doorOf(0.69, false)}),
      withDoors("b", {doorOf(0.7, true), doorOf(0.9, true), doorOf(0.95, true), doorOf(1, false)})};
  EXPECT_EQ(reliabilityTable(scores),
            "| confidence   | doors |  mean |  true |\n"
            "|--------------|------:|------:|------:|\n"
            "| [0.00, 0.50) |     1 | 0.000 | 0.000 |\n"
            "| [0.50, 0.70) |     2 | 0.595 | 0.500 |\n"
            "| [0.70, 0.80) |     1 | 0.700 | 1.000 |\n"
            "| [0.80, 0.90) |     0 |     - |     - |\n"
            "| [0.90, 0.95) |     1 | 0.900 | 1.000 |\n"
            "| [0.95, 1]    |     2 | 0.975 | 0.500 |\n"
            "| all          |     7 | 0.677 | 0.571 |\n");
}

TEST(EvalDoors, NamesOfMapsCannotBreakTheLines) {
  JudgedDoor door = doorOf(0.25, true);
  door.id = 7;
  door.kind = DoorKind::kPassage;
  door.width = 2.75;
  EXPECT_EQ(doorsCsv({withDoors("a,\"b\"", {door})}),
            "map,door,kind,width,confidence,true\n"
            "\"a,\"\"b\"\"\",7,PASSAGE,2.750,0.250000,1\n");
}

}  // namespace
}  // namespace agrid::tools
