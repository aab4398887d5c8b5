// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "agrid/map/map_io.h"
#include "agrid/storage.h"
#include "support/ascii_map.h"
#include "support/temporary_folder.h"
#include "tools/commands.h"

namespace agrid::tools {
namespace {

using test::contentsOf;
using test::contentsOfFolder;
using test::TemporaryFolder;

struct Outcome {
  int code = 0;
  std::string out;
  std::string err;
};

Outcome runTool(std::vector<std::string> words) {
  words.insert(words.begin(), "agrid_map_tool");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Outcome outcome;
  outcome.code = run(words);
  outcome.out = testing::internal::GetCapturedStdout();
  outcome.err = testing::internal::GetCapturedStderr();
  return outcome;
}

/// A folder with a map of two rooms.
class ExchangeCommands : public testing::Test {
 protected:
  ExchangeCommands() {
    std::vector<std::string> rows(50, "#" + std::string(58, '.') + "#");
    rows.front() = rows.back() = std::string(60, '#');
    for (std::size_t y = 0; y < rows.size(); ++y) {
      if (y < 10 || y > 17) rows[y][29] = rows[y][30] = '#';
    }
    saveMap(test::asciiGrid(rows, 0.1), map_);
  }
  const TemporaryFolder temp_;
  const std::string map_ = temp_ / "map.yaml";
};

TEST_F(ExchangeCommands, ExportWritesWhatIsAskedForTwiceTheSame) {
  const std::vector<std::string> words{"export", map_, "-f",  "svg", "-f",
                                       "nav2",   "-f", "svg", "-o",  temp_ / "a"};
  const Outcome outcome = runTool(words);
  ASSERT_EQ(outcome.code, kDone) << outcome.err;
  EXPECT_EQ(outcome.out, temp_ / "a/map.svg\n" + (temp_ / "a/map.nav2.geojson\n"));
  std::vector<std::string> again = words;
  again.back() = temp_ / "b";
  ASSERT_EQ(runTool(again).code, kDone);
  EXPECT_EQ(contentsOfFolder(temp_ / "a"), contentsOfFolder(temp_ / "b"));
  EXPECT_EQ(contentsOfFolder(temp_ / "a").size(), 2U);
  EXPECT_EQ(runTool(words).code, kWrongUsage) << "the files are there";
}

TEST_F(ExchangeCommands, ExportKnowsItsFormats) {
  const Outcome outcome = runTool({"export", map_, "-f", "osm", "-o", temp_ / "a"});
  EXPECT_EQ(outcome.code, kWrongUsage);
  EXPECT_NE(
      outcome.err.find("there is no format 'osm'; there are geojson, nav2, graphml, dot, svg, "
                       "labels, facts"),
      std::string::npos);
  EXPECT_EQ(runTool({"export", map_, "-o", temp_ / "a"}).code, kWrongUsage);
}

TEST_F(ExchangeCommands, AWideRobotIsToldWhatItsGraphLacks) {
  const Outcome outcome =
      runTool({"export", map_, "-f", "nav2", "--robot-radius", "0.5", "-o", temp_ / "a"});
  EXPECT_EQ(outcome.code, kDone);
  EXPECT_NE(outcome.err.find("has no place for the robot"), std::string::npos) << outcome.err;
}

TEST_F(ExchangeCommands, LabelsOfConvertComeBackAsTags) {
  ASSERT_EQ(runTool({"convert", map_, "-o", temp_ / "c"}).code, kDone);
  const std::string stored = temp_ / "map.agrid.yaml";
  const Outcome outcome =
      runTool({"import", map_, "--labels", temp_ / "c/labels.png", "-o", stored});
  ASSERT_EQ(outcome.code, kDone) << outcome.err;
  EXPECT_EQ(outcome.out, stored + ": 2 areas, 0 doors, 0 objects; mean IoU of areas 1\n");
  const StoreContents contents = readStoredMap(stored);
  EXPECT_TRUE(contents.warnings.empty());
  EXPECT_EQ(contents.map.knowledge.areas.size(), 2U);
  ASSERT_EQ(runTool({"convert", map_, "--tags", stored, "-o", temp_ / "d"}).code, kDone);
  EXPECT_EQ(contentsOf(temp_ / "c/labels.png"), contentsOf(temp_ / "d/labels.png"));
  EXPECT_EQ(runTool({"import", map_, "--labels", temp_ / "c/labels.png", "-o", stored}).code,
            kWrongUsage)
      << "the file is there";
}

TEST_F(ExchangeCommands, ImportRefusesWhatItCannotUse) {
  const std::string out = temp_ / "o.yaml";
  EXPECT_EQ(runTool({"import", map_, "-o", out}).code, kWrongUsage);
  EXPECT_EQ(runTool({"import", map_, "--labels", "a", "--geojson", "b", "-o", out}).code,
            kWrongUsage);
  for (const char* option : {"--labels", "--locations", "--geojson", "--doors", "--objects"}) {
    const Outcome outcome = runTool({"import", map_, option, temp_ / "none", "-o", out});
    EXPECT_EQ(outcome.code, kFileFailed) << option;
    EXPECT_NE(outcome.err.find(temp_ / "none"), std::string::npos) << outcome.err;
  }
  temp_.write("bad.yaml", "- {door_corner_pt_1: [0, 0]}\n");
  EXPECT_EQ(runTool({"import", map_, "--doors", temp_ / "bad.yaml", "-o", out}).code, kFileFailed);
  EXPECT_EQ(contentsOfFolder(temp_ / "").count("o.yaml"), 0U);
}

}  // namespace
}  // namespace agrid::tools
