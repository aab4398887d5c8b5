// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "agrid/storage.h"
#include "support/temporary_folder.h"
#include "tools/stored_fixture.h"

namespace agrid::tools {
namespace {

using test::boxArea;
using test::StoredText;
using test::TemporaryFolder;
using test::ToolRun;

/// Only what is printed for the two, the reader's warnings aside.
ToolRun diff(const std::string& a, const std::string& b) {
  const TemporaryFolder temp;
  return test::runTool({"diff", temp.write("a.yaml", a), temp.write("b.yaml", b)});
}

std::string said(const StoredText& a, const StoredText& b) {
  const ToolRun run = diff(a.text(), b.text());
  EXPECT_EQ(run.code, run.out.empty() ? kDone : kFound) << run.err;
  return run.out;
}

const std::string kKitchen = boxArea(1, "kitchen", 0, 4);
const std::string kHall = boxArea(2, "hall", 4.2, 10);
const std::string kDoor = "id: 1, name: \"front\", pose: [4.1, 1.5, 0], width: 0.9";

TEST(DiffCommand, EqualFilesDifferNowhere) {
  const StoredText a{"00000000000000aa", {kKitchen, kHall}, {kDoor}, {"id: 1, pose: [1, 1, 0]"}};
  EXPECT_EQ(said(a, a), "");
}

TEST(DiffCommand, AreasAddedRemovedRenamedAndOfOtherCategory) {
  const StoredText a{"00000000000000aa", {kKitchen, kHall, boxArea(3, "attic", 20, 22)}};
  const StoredText b{"00000000000000aa",
                     {boxArea(1, "galley", 0, 4), boxArea(2, "hall", 4.2, 10, ", category: room"),
                      boxArea(12, "shed", 30, 32)}};
  EXPECT_EQ(said(a, b),
            "area 1 'kitchen' was renamed to 'galley'\n"
            "area 2 'hall' changed its category from none to 'room'\n"
            "area 3 'attic' was removed\n"
            "area 12 'shed' was added\n");
}

TEST(DiffCommand, AreasSplitAndMerged) {
  const StoredText whole{"00000000000000aa", {boxArea(1, "kitchen", 0, 10)}};
  const StoredText parts{"00000000000000aa",
                         {boxArea(1, "kitchen", 0, 6), boxArea(5, "pantry", 6, 10)}};
  EXPECT_EQ(said(whole, parts),
            "area 1 'kitchen' has its seed moved by 2.00 m\n"
            "area 1 'kitchen' was split into areas 1 'kitchen' and 5 'pantry'\n");
  EXPECT_EQ(said(parts, whole),
            "area 1 'kitchen' has its seed moved by 2.00 m\n"
            "areas 1 'kitchen' and 5 'pantry' were merged into area 1 'kitchen'\n");
}

TEST(DiffCommand, ARoomWithinARingIsNoPartOfIt) {
  const StoredText a{"00000000000000aa", {boxArea(1, "ring", 0, 10), boxArea(2, "room", 4, 6)}};
  StoredText b = a;
  b.areas[1] = boxArea(2, "cell", 4, 6);
  EXPECT_EQ(said(a, b), "area 2 'room' was renamed to 'cell'\n");
}

TEST(DiffCommand, AnOutlineThatGrew) {
  const StoredText a{"00000000000000aa", {boxArea(1, "hall", 0, 4, ", source: automatic")}};
  const StoredText b{"00000000000000aa", {boxArea(1, "hall", 0, 5, ", source: automatic")}};
  EXPECT_EQ(said(a, b),
            "area 1 'hall' changed its outline from 12.0 to 15.0 m^2, 12.0 m^2 in common\n");
}

TEST(DiffCommand, DoorsAddedRemovedMovedChangedAndAbsent) {
  const std::string h = "00000000000000aa";
  const StoredText a{h,
                     {},
                     {kDoor, "id: 2, pose: [9, 1, 0]", "id: 3, pose: [12, 1, 0]",
                      "id: 4, pose: [15, 1, 0], state: open", "id: 6, pose: [19, 1, 0], width: 1"}};
  const StoredText b{
      h,
      {},
      {"id: 1, name: \"front\", pose: [4.1, 2.02, 0], width: 0.9",
       "id: 2, pose: [9, 1, 0], absent: true", "id: 4, pose: [15, 1, 0], state: closed",
       "id: 5, pose: [17, 1, 0]", "id: 6, pose: [19, 1, 3.14159265], width: 1.2"}};
  EXPECT_EQ(said(a, b),
            "door 1 'front' was moved by 0.52 m\n"
            "door 2 is said to be absent now\n"
            "door 3 was removed\n"
            "door 4 changed its state from open to closed\n"
            "door 5 was added\n"
            "door 6 changed its width from 1.00 to 1.20 m\n");
}

TEST(DiffCommand, ObjectsAddedRemovedMovedAndRenamed) {
  const std::string h = "00000000000000aa";
  const StoredText a{
      h,
      {},
      {},
      {"id: 1, name: \"table\", pose: [1, 1, 0]", "id: 2, name: \"bed\", pose: [2, 1, 0]",
       "id: 3, name: \"sofa\", pose: [3, 1, 0]"}};
  const StoredText b{
      h,
      {},
      {},
      {"id: 1, name: \"table\", pose: [1, 4, 1.5707963]", "id: 2, name: \"cot\", pose: [2, 1, 0]",
       "id: 4, name: \"lamp\", pose: [5, 1, 0], properties: {\"floor\": \"2\"}"}};
  EXPECT_EQ(said(a, b),
            "object 1 'table' was moved by 3.00 m\n"
            "object 1 'table' was turned by 90 degrees\n"
            "object 2 'bed' was renamed to 'cot'\n"
            "object 3 'sofa' was removed\n"
            "object 4 'lamp' was added\n");
}

TEST(DiffCommand, TagsThatWaitNowOrNoMore) {
  const std::string h = "00000000000000aa";
  const std::string waiting = ", kind: area, reason: \"no wall there\"";
  const StoredText a{
      h, {kKitchen}, {}, {}, {kHall + waiting, boxArea(3, "attic", 20, 22) + waiting}};
  const StoredText b{h, {kHall}, {}, {}, {kKitchen + waiting}};
  EXPECT_EQ(said(a, b),
            "area 1 'kitchen' waits now: no wall there\n"
            "area 2 'hall' waits no more\n"
            "area 3 'attic' waited and was removed\n");
}

TEST(DiffCommand, WithoutCommonHistoryPlacesTellWhatIsTheSame) {
  const StoredText a{"00000000000000aa",
                     {kKitchen, kHall},
                     {kDoor, "id: 2, pose: [9, 1, 0]"},
                     {"id: 1, name: \"table\", pose: [1, 1, 0]"}};
  const StoredText b{
      "00000000000000bb",
      {boxArea(1, "hall", 4.2, 10), boxArea(2, "galley", 0.1, 4)},
      {"id: 1, pose: [9, 1.1, 0]", "id: 2, name: \"front\", pose: [4.1, 1.5, 0], width: 0.9"},
      {"id: 7, name: \"Table\", pose: [3, 1, 0]"}};
  EXPECT_EQ(said(a, b),
            "area 1 'kitchen' has its seed moved by 0.05 m\n"
            "area 1 'kitchen' was renamed to 'galley'\n"
            "door 2 was moved by 0.10 m\n"
            "object 1 'table' was moved by 2.00 m\n"
            "object 1 'table' was renamed to 'Table'\n");
}

TEST(DiffCommand, ACopyUnderAnotherHistoryKeepsItsIds) {
  const StoredText a{"00000000000000aa", {kKitchen, kHall}, {kDoor}};
  StoredText b{"00000000000000bb", {kKitchen, kHall}, {}};
  b.doors = {"id: 1, name: \"front\", pose: [4.1, 2.9, 0], width: 0.9"};
  EXPECT_EQ(said(a, b), "door 1 'front' was moved by 1.40 m\n") << "too far to be known by place";
}

TEST(DiffCommand, EditsInTheJournalCount) {
  const TemporaryFolder temp;
  StoredMap map;
  map.frame_id = "map";
  Store(temp.path(), "a").replace(map);
  Store b(temp.path(), "b");
  b.replace(map);
  ObjectTag table;
  table.id = ObjectId{1};
  table.name = "line\nbreak";
  b.append({PutTag{table}});
  const ToolRun run = test::runTool({"diff", temp / "a.yaml", temp / "b.yaml"});
  EXPECT_EQ(run.code, kFound);
  EXPECT_EQ(run.out, "object 1 'line\\x0abreak' was added\n") << "a sentence is a line";
}

TEST(DiffCommand, WhatIsDamagedCannotBeCompared) {
  const TemporaryFolder temp;
  const std::string good = temp.write("a.yaml", StoredText{}.text());
  temp.write("b.yaml.bak", StoredText{}.text());
  const std::string damaged = temp.write("b.yaml", "format_version: 1\n");
  const ToolRun run = test::runTool({"diff", good, damaged});
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("damaged: "), std::string::npos) << run.err;
  const ToolRun check = test::runTool({"check", damaged});
  EXPECT_EQ(check.code, kFound);
  EXPECT_NE(check.out.find("damaged: "), std::string::npos) << check.out;
}

TEST(DiffCommand, BrokenAndMissingFilesAreErrors) {
  const TemporaryFolder temp;
  const std::string good = temp.write("good.yaml", StoredText{}.text());
  const std::string broken = temp.write("broken.yaml", "format_version: 1\nareas:\n  - {id: x}\n");
  const std::string newer = temp.write("newer.yaml", "format_version: 9\nend_of_file: true\n");
  for (const std::string& bad : {broken, newer, temp / "missing.yaml", temp / "no/dir.yaml"}) {
    for (const auto& files : {std::vector<std::string>{good, bad}, {bad, good}}) {
      const ToolRun run = test::runTool({"diff", files[0], files[1]});
      EXPECT_EQ(run.code, 2) << bad;
      EXPECT_EQ(run.out, "");
      EXPECT_NE(run.err.find("agrid_map_tool: " + temp.path()), std::string::npos) << run.err;
    }
  }
  EXPECT_EQ(test::runTool({"diff", good}).code, kWrongUsage);
  EXPECT_EQ(test::runTool({"diff", good, good, good}).code, kWrongUsage);
}

}  // namespace
}  // namespace agrid::tools
