// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "agrid/identity/recognition.h"
#include "identity/drawn_areas.h"
#include "identity/known_areas.h"

namespace agrid {
namespace {

using test::at;
using test::drawnAreas;
using test::named;
using test::next;
using test::waiting;
using Rows = std::vector<std::string>;

const Rows kTwoRooms{"#############",  //
                     "#aaaaaabbbbb#",  //
                     "#aaaaaabbbbb#",  //
                     "#aaaaaabbbbb#",  //
                     "#aaaaaabbbbb#",  //
                     "#############"};

TEST(AreaRules, TheFirstMapGetsIdsFromOne) {
  const SemanticMap map = drawnAreas(kTwoRooms);
  const Recognition found = recognise({}, "", map, "map");
  EXPECT_EQ(at(found, map), "1 area_1, 2 area_2");
  EXPECT_EQ(found.knowledge.next_ids.area, 3U);
  EXPECT_TRUE(found.report.empty());
}

TEST(AreaRules, TheSameMapChangesNothing) {
  const SemanticMap map = drawnAreas(kTwoRooms);
  const Knowledge known = named(map, 2, "kitchen");
  const Recognition found = next(known, map);
  EXPECT_TRUE(difference(known, found.knowledge).empty());
  EXPECT_TRUE(found.report.empty());
}

TEST(AreaRules, ProvisionalIdsOfTheNewMapMeanNothing) {
  const SemanticMap before = drawnAreas(kTwoRooms);
  const SemanticMap after = drawnAreas({"#############",  //
                                        "#bbbbbbaaaaa#",  //
                                        "#bbbbbbaaaaa#",  //
                                        "#bbbbbbaaaaa#",  //
                                        "#bbbbbbaaaaa#",  //
                                        "#############"});
  EXPECT_EQ(at(next(named(before, 1, "kitchen"), after), after), "2 area_2, 1 kitchen");
}

TEST(AreaRules, APropertyOrCategoryStays) {
  const SemanticMap map = drawnAreas(kTwoRooms);
  Knowledge known = named(map, 1, "kitchen");
  known.areas[0].category = "room";
  known.areas[0].properties["floor"] = "2";
  const Recognition found = next(known, drawnAreas(kTwoRooms, 0.5, {{0.3, -0.2}, 0}));
  ASSERT_NE(findTag(found.knowledge, AreaId{1}), nullptr);
  EXPECT_EQ(findTag(found.knowledge, AreaId{1})->category, "room");
  EXPECT_EQ(findTag(found.knowledge, AreaId{1})->properties.at("floor"), "2");
}

TEST(AreaRules, M21_AShiftedAndGrownMapKeepsIds) {
  const SemanticMap before = drawnAreas(kTwoRooms);
  const SemanticMap after = drawnAreas({"################",  //
                                        "#aaaaaabbbbb###?",  //
                                        "#aaaaaabbbbbccc#",  //
                                        "#aaaaaabbbbbccc#",  //
                                        "#aaaaaabbbbb####",  //
                                        "#############???",  //
                                        "#dddddddddddd#??",  //
                                        "##############??"},
                                       0.5, {{0, -1}, 0});
  EXPECT_EQ(at(next(named(before, 1, "kitchen"), after), after),
            "1 kitchen, 2 area_2, 3 area_3, 4 area_4");
}

TEST(AreaRules, AMapOfOtherPixelsAndATurnedOneKeepIds) {
  const SemanticMap before = drawnAreas(kTwoRooms);
  Rows fine;
  for (const std::string& row : kTwoRooms) {
    std::string wide;
    for (const char c : row) wide += std::string(3, c);
    fine.insert(fine.end(), 3, wide);
  }
  const SemanticMap finer = drawnAreas(fine, 0.5 / 3);
  EXPECT_EQ(at(next(named(before, 1, "kitchen"), finer), finer), "1 kitchen, 2 area_2");

  Rows turned(kTwoRooms[0].size(), std::string(kTwoRooms.size(), '#'));  // by 90 degrees
  for (std::size_t y = 0; y < kTwoRooms.size(); ++y) {
    for (std::size_t x = 0; x < kTwoRooms[0].size(); ++x) turned[x][y] = kTwoRooms[y][x];
  }
  const double height = 0.5 * static_cast<double>(kTwoRooms.size());
  const SemanticMap other = drawnAreas(turned, 0.5, {{0, height}, -1.5707963267948966});
  ASSERT_EQ(other.map().geometry().height, 13);
  const SemanticMap mirrored =
      drawnAreas(Rows(turned.rbegin(), turned.rend()), 0.5, {{0, height}, -1.5707963267948966});
  EXPECT_EQ(at(next(named(before, 1, "kitchen"), mirrored), mirrored), "1 kitchen, 2 area_2");
}

TEST(AreaRules, AnAreaThatGrowsTenfoldIsTheSame) {
  const SemanticMap before = drawnAreas({"#????????????????????",  //
                                         "#aa??????????????????",  //
                                         "#aa??????????????????",  //
                                         "#????????????????????"});
  const SemanticMap after = drawnAreas({"#####################",  //
                                        "#aaaaaaaaaaaaaaaaaaaa",  //
                                        "#aaaaaaaaaaaaaaaaaaaa",  //
                                        "#####################"});
  EXPECT_EQ(at(next(named(before, 1, "hall"), after), after), "1 hall");
  EXPECT_EQ(at(next(named(after, 1, "hall"), before), before), "1 hall");
}

TEST(AreaRules, RoomsWithinARingOfCorridorsAreNotTheCorridors) {
  const SemanticMap ring = drawnAreas({"aaaaaaaaa",  //
                                       "a#######a",  //
                                       "a#bb#cc#a",  //
                                       "a#bb#cc#a",  //
                                       "a#bb#cc#a",  //
                                       "a#######a",  //
                                       "aaaaaaaaa"});
  Knowledge known = named(ring, 1, "corridor");
  EXPECT_TRUE(difference(known, next(known, ring).knowledge).empty());

  // neither when the corridor waits for its frame
  const Recognition away = recognise(known, "map", ring, "other");
  EXPECT_EQ(at(away, ring), "4 area_4, 5 area_5, 6 area_6");
  const Recognition back = recognise(away.knowledge, "other", ring, "map");
  EXPECT_EQ(at(back, ring), "1 corridor, 7 area_7, 8 area_8");
}

TEST(AreaRules, ASliverOfAFormerAreaNamesNoNewOne) {
  const SemanticMap before = drawnAreas({"#aaaaaaaaaa????????????"});
  const SemanticMap after = drawnAreas({"???????????aaaaaaaaaaaa"}, 0.5, {{-0.5, 0}, 0});
  const Recognition found = next(named(before, 1, "kitchen"), after);
  EXPECT_EQ(at(found, after), "2 area_2");
  EXPECT_EQ(waiting(found), "1 kitchen: there is hardly an area at its place\n");
}

TEST(AreaRules, ANameGivenToAnAreaBeatsOneThatWaitsForItsPlace) {
  const SemanticMap whole = drawnAreas({"aaaaaaaaaaa"});
  const SemanticMap halves = drawnAreas({"aaaaa#bbbbb"});
  Knowledge known = next(named(whole, 1, "kitchen"), halves).knowledge;
  ASSERT_EQ(known.pending.size(), 1U);
  known.areas[0].source = TagSource::kInteraction;
  known.areas[0].name = "lounge";
  const SemanticMap large = drawnAreas({"aaaaaaa###b"});
  const Recognition found = next(known, large);
  EXPECT_EQ(at(found, large).find("lounge"), 2U) << at(found, large);
  EXPECT_EQ(waiting(found), "1 kitchen: its place is known by another name\n");
}

TEST(AreaRules, ATagThatNeverHadAnOutlineGoesByItsSeed) {
  const SemanticMap map = drawnAreas(kTwoRooms);
  Knowledge known;
  for (const auto& [name, x] :
       {std::pair("kitchen", 5.0), std::pair("other", 4.0), std::pair("outside", 50.0)}) {
    AreaTag tag;
    tag.id = AreaId{known.next_ids.area};
    tag.name = name;
    tag.source = TagSource::kManual;
    tag.seed_map = Point2(x, 1);
    apply(PutTag{tag}, known);
  }
  const Recognition found = next(known, map);
  EXPECT_EQ(at(found, map), "4 area_4, 1 kitchen");
  EXPECT_EQ(waiting(found),
            "2 other: its place is known by another name\n3 outside: it lies in no area\n");
}

TEST(AreaRules, AGivenSeedStaysWhileItLiesInItsArea) {
  const SemanticMap map = drawnAreas(kTwoRooms);
  Knowledge known = named(map, 1, "kitchen");
  known.areas[0].seed_map = Point2(2.25, 1.25);
  EXPECT_EQ(next(known, map).knowledge.areas[0].seed_map, Point2(2.25, 1.25));
  const SemanticMap shrunk = drawnAreas({"#############",  //
                                         "#aaaa##bbbbb#",  //
                                         "#aaaa##bbbbb#",  //
                                         "#############",  //
                                         "#############",  //
                                         "#############"});
  const Recognition found = next(known, shrunk);
  EXPECT_EQ(at(found, shrunk), "1 kitchen, 2 area_2");
  EXPECT_EQ(found.knowledge.areas[0].seed_map, shrunk.area_map.areas[0].anchor_map);
}

TEST(AreaRules, ANewAreaNeverTakesAGivenName) {
  const SemanticMap before = drawnAreas({"aaaaaaa####"});
  const SemanticMap after = drawnAreas({"aaaaaaa#bbb"});
  const Recognition found = next(named(before, 1, "area_2"), after);
  EXPECT_EQ(at(found, after), "1 area_2, 3 area_3");
}

}  // namespace
}  // namespace agrid
