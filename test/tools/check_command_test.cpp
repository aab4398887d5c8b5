// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "agrid/map/map_io.h"
#include "support/ascii_map.h"
#include "support/temporary_folder.h"
#include "tools/stored_fixture.h"

namespace agrid::tools {
namespace {

using test::boxArea;
using test::contentsOf;
using test::StoredText;
using test::TemporaryFolder;
using test::ToolRun;

const std::string kHistory = "00000000000000aa";
const std::string kByHand = "changed by hand since it was saved";

/// The lines found, the reader's one on what a person changed aside.
std::string found(const StoredText& stored) {
  const TemporaryFolder temp;
  const ToolRun run = test::runTool({"check", temp.write("a.yaml", stored.text())});
  EXPECT_EQ(run.code, kFound);
  std::istringstream lines(run.out);
  std::string rest;
  for (std::string line; std::getline(lines, line);) {
    if (line.find(kByHand) == std::string::npos) rest += line + "\n";
  }
  return rest;
}

/// Two rooms with a door between them.
StoredText goodPlace() {
  return {kHistory,
          {boxArea(1, "kitchen", 0, 4), boxArea(2, "hall", 4.2, 10)},
          {"id: 1, name: \"front\", pose: [4.1, 1.5, 0], width: 0.9"},
          {"id: 1, name: \"table\", pose: [1, 1, 0]"}};
}

TEST(CheckCommand, AGoodPlaceHasNothingWrong) { EXPECT_EQ(found(goodPlace()), ""); }

TEST(CheckCommand, NamesThatSeveralThingsOfAKindBear) {
  StoredText place = goodPlace();
  place.areas = {boxArea(1, "Büro", 0, 4), boxArea(2, "BÜRO", 4.2, 10)};
  place.doors[0] = "id: 1, name: \"table\", pose: [4.1, 1.5, 0]";
  place.objects.emplace_back("id: 3, name: \"TABLE\", pose: [2, 1, 0]");
  EXPECT_EQ(found(place),
            "areas 1 'Büro' and 2 'BÜRO' have the same name\n"
            "objects 1 'table' and 3 'TABLE' have the same name\n");
}

TEST(CheckCommand, DoorsWithOneSideOrNoneOrTheSameTwice) {
  StoredText place = goodPlace();
  place.doors.emplace_back("id: 2, pose: [0, 1.5, 0]");
  place.doors.emplace_back("id: 3, pose: [20, 1.5, 0]");
  place.doors.emplace_back("id: 4, pose: [7, 1.5, 0]");
  place.doors.emplace_back("id: 5, pose: [20, 1.5, 0], absent: true");
  EXPECT_EQ(found(place),
            "door 2 has an area on one side only: area 1 'kitchen'\n"
            "door 3 has no area on either side\n"
            "door 4 has the same area on both sides: area 2 'hall'\n");
}

TEST(CheckCommand, ADoorPutDownBesideItsOpeningHasBothSides) {
  StoredText place = goodPlace();
  for (const char* x : {"3.7", "4.5"}) {
    place.doors[0] = "id: 1, pose: [" + std::string(x) + ", 1.5, 3.14]";
    EXPECT_EQ(found(place), "") << x;
  }
}

TEST(CheckCommand, AreasThatNoDoorLeadsTo) {
  StoredText place = goodPlace();
  place.areas.push_back(boxArea(3, "attic", 20, 22));
  EXPECT_EQ(found(place), "area 3 'attic' cannot be reached: no door leads there\n");
  place.areas = {boxArea(1, "kitchen", 0, 4)};
  place.doors.clear();
  EXPECT_EQ(found(place), "") << "the only one";
}

TEST(CheckCommand, SeedsOfTwoAreasInOneOutline) {
  StoredText place = goodPlace();
  place.areas.push_back("id: 3, name: \"nook\", seed: [2, 2], outline: [[4, 3], [4, 4], [3, 4]]");
  place.doors.emplace_back("id: 2, pose: [3.8, 3.1, 1.57]");
  EXPECT_EQ(found(place),
            "the seeds of areas 1 'kitchen' and 3 'nook' lie in one area: 1 'kitchen'\n");
}

TEST(CheckCommand, ObjectsOutsideAndTagsThatWait) {
  StoredText place = goodPlace();
  place.objects[0] = "id: 1, name: \"table\", pose: [1, 7, 0]";
  place.pending = {"kind: door, id: 9, pose: [1, 1, 0], reason: \"two doors are as near\""};
  EXPECT_EQ(found(place),
            "door 9 waits: two doors are as near\n"
            "object 1 'table' lies in no area\n");
}

TEST(CheckCommand, WarningsOfTheReaderAreFindings) {
  const TemporaryFolder temp;
  std::string text = goodPlace().text();
  text.insert(text.find("areas:"), "colour: blue\n");
  const ToolRun run = test::runTool({"check", temp.write("a.yaml", text)});
  EXPECT_EQ(run.code, kFound);
  EXPECT_NE(run.out.find("colour"), std::string::npos) << run.out;
}

TEST(CheckCommand, WithoutOutlinesPlacesAreLeftToTheMap) {
  StoredText place = goodPlace();
  place.areas[1] = "id: 2, name: \"kitchen\", seed: [7, 1]";
  place.doors[0] = "id: 1, pose: [50, 50, 0]";
  EXPECT_EQ(found(place), "areas 1 'kitchen' and 2 'kitchen' have the same name\n");
}

TEST(CheckCommand, BrokenFilesAndMapsAreErrors) {
  const TemporaryFolder temp;
  const std::string good = temp.write("good.yaml", goodPlace().text());
  const std::string broken = temp.write("broken.yaml", "format_version: 1\n");
  EXPECT_EQ(test::runTool({"check", broken}).code, 2);
  EXPECT_EQ(test::runTool({"check", temp / "missing.yaml"}).code, 2);
  EXPECT_EQ(test::runTool({"check", good, "--map", temp / "missing.yaml"}).code, 2);
  saveMap(test::asciiGrid({"....", "...."}, 0.1), temp / "map.yaml");
  EXPECT_EQ(
      test::runTool({"check", good, "--map", temp / "map.yaml", "-p", "min_threshold=-4"}).code, 2);
  EXPECT_EQ(test::runTool({"check"}).code, kWrongUsage);
}

/// Two rooms and a cell that nobody can enter, 0.1 m a pixel.
OccupancyGrid roomsAndCell() {
  std::vector<std::string> rows(
      50, "#" + std::string(58, '.') + std::string(2, '#') + std::string(30, '.') + "#");
  rows.front() = rows.back() = std::string(92, '#');
  for (std::size_t y = 0; y < rows.size(); ++y) {
    if (y < 10 || y > 17) rows[y][29] = rows[y][30] = '#';
  }
  return test::asciiGrid(rows, 0.1);
}

class CheckOnMap : public testing::Test {
 protected:
  void SetUp() override {
    saveMap(roomsAndCell(), temp_ / "map.yaml");
    const ToolRun run = convert("first", {"--save-tags"});
    ASSERT_EQ(run.code, kDone) << run.err;
    stored_ = contentsOf(temp_ / "first/tags.yaml");
  }

  ToolRun convert(const std::string& output, const std::vector<std::string>& more) {
    std::vector<std::string> words{"convert", temp_ / "map.yaml", "-o", temp_ / output};
    words.insert(words.end(), more.begin(), more.end());
    return test::runTool(words);
  }

  /// Adds entries to a list of the file, whose checksum goes.
  std::string with(const std::string& key, const std::string& entry) const {
    std::string text = stored_.substr(0, stored_.find("checksum:"));
    const std::string empty = key + ": []\n";
    const auto at = text.find(empty);
    if (at != std::string::npos) text.replace(at, empty.size(), key + ":\n");
    text.insert(text.find(key + ":\n") + key.size() + 2, "  - {" + entry + "}\n");
    return text;
  }

  TemporaryFolder temp_;
  std::string stored_;
};

TEST_F(CheckOnMap, TheGraphTellsWhatOutlinesTell) {
  const std::string file = temp_.write("tags.yaml", stored_);
  const ToolRun by_map = test::runTool({"check", file, "--map", temp_ / "map.yaml"});
  EXPECT_EQ(by_map.code, kFound);
  EXPECT_NE(by_map.out.find("cannot be reached"), std::string::npos) << by_map.out << by_map.err;
  EXPECT_EQ(test::runTool({"check", file}).out, by_map.out);
}

TEST_F(CheckOnMap, SeedsInOneAreaAndObjectsOutside) {
  std::string file =
      temp_.write("tags.yaml",
                  with("areas", "id: 90, name: \"a\", seed: [1, 1]}\n  - {id: 91, seed: [1.5, 1]"));
  ToolRun run = test::runTool({"check", file, "--map", temp_ / "map.yaml"});
  EXPECT_EQ(run.code, kFound);
  EXPECT_NE(run.out.find("lie in one area"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("waits: "), std::string::npos) << "of two given ones, one must wait";
  file = temp_.write("tags.yaml", with("objects", "id: 5, pose: [-4, 1, 0]"));
  run = test::runTool({"check", file, "--map", temp_ / "map.yaml"});
  EXPECT_NE(run.out.find("object 5 lies in no area"), std::string::npos) << run.out;
}

TEST_F(CheckOnMap, ConvertLaysStoredTagsOverTheMap) {
  temp_.write("tags.yaml", with("areas", "id: 90, name: \"kitchen\", seed: [1, 1]"));
  ASSERT_EQ(convert("out", {"--tags", temp_ / "tags.yaml", "--save-tags"}).code, kDone);
  EXPECT_NE(contentsOf(temp_ / "out/graph.json").find("\"kitchen\""), std::string::npos);
  EXPECT_NE(contentsOf(temp_ / "out/tags.yaml").find("\"kitchen\""), std::string::npos);
  ASSERT_EQ(convert("plain", {"--tags", temp_ / "tags.yaml"}).code, kDone);
  EXPECT_EQ(test::contentsOfFolder(temp_ / "plain").count("tags.yaml"), 0U);
  EXPECT_EQ(convert("no", {"--tags", temp_ / "missing.yaml"}).code, kFileFailed);
}

TEST_F(CheckOnMap, ConvertLeavesWhatItSavedAsItIs) {
  ASSERT_EQ(convert("again", {"--tags", temp_ / "first/tags.yaml", "--save-tags"}).code, kDone);
  EXPECT_EQ(contentsOf(temp_ / "again/tags.yaml"), stored_);
}

TEST_F(CheckOnMap, ConvertRecognisesThePlaceOnAnotherMap) {
  temp_.write("tags.yaml", with("objects", "id: 5, name: \"box\", pose: [1, 1, 0]"));
  OccupancyGrid changed = roomsAndCell();
  changed.values[changed.geometry.index({40, 40})] = 100;
  saveMap(changed, temp_ / "map.yaml");
  ASSERT_EQ(convert("out", {"--tags", temp_ / "tags.yaml", "--save-tags"}).code, kDone);
  const ToolRun run = test::runTool({"diff", temp_ / "tags.yaml", temp_ / "out/tags.yaml"});
  EXPECT_EQ(run.code, kFound);
  EXPECT_EQ(run.out.find("the metric map changed"), 0U) << run.out;
  EXPECT_EQ(run.out.find("removed"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace agrid::tools
