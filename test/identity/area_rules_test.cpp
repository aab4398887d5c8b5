// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "agrid/identity/recognition.h"
#include "identity/drawn_areas.h"

namespace agrid {
namespace {

using test::drawnAreas;
using Rows = std::vector<std::string>;

const Rows kTwoRooms{"#############",  //
                     "#aaaaaabbbbb#",  //
                     "#aaaaaabbbbb#",  //
                     "#aaaaaabbbbb#",  //
                     "#aaaaaabbbbb#",  //
                     "#############"};

/// What is known after a first map, its area `id` named by a person.
Knowledge named(const SemanticMap& map, std::uint32_t id, const std::string& name) {
  Knowledge known = recognise({}, "", map, "map").knowledge;
  for (AreaTag& tag : known.areas) {
    if (tag.id != AreaId{id}) continue;
    tag.name = name;
    tag.source = TagSource::kManual;
  }
  return known;
}

Recognition next(const Knowledge& known, const SemanticMap& map) {
  return recognise(known, "map", map, "map");
}

/// "id name" of the area at each letter of a drawing, in the order of the alphabet.
std::string at(const Recognition& found, const SemanticMap& map) {
  std::string text;
  for (std::size_t i = 0; i < map.area_map.areas.size(); ++i) {
    for (const AreaTag& tag : found.knowledge.areas) {
      const auto pixel = map.map().geometry().pixelAt(tag.seed_map);
      if (!pixel) continue;
      if (map.area_map.pixel_labels[map.map().geometry().index(*pixel)] != i + 1) continue;
      text += (text.empty() ? "" : ", ") + std::to_string(static_cast<std::uint32_t>(tag.id)) +
              " " + tag.name;
    }
  }
  return text;
}

std::string waiting(const Recognition& found) {
  std::string text;
  for (const PendingTag& p : found.knowledge.pending) {
    text += std::to_string(idOf(p.tag)) + " " + nameOf(p.tag) + ": " + p.reason + "\n";
  }
  return text;
}

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

TEST(AreaRules, OfADividedAreaTheLargePartIsTheSame) {
  const SemanticMap before = drawnAreas({"aaaaaaaaaa",  //
                                         "aaaaaaaaaa"});
  const SemanticMap after = drawnAreas({"aaaaaaa#bb",  //
                                        "aaaaaaa#bb"});
  const Recognition found = next(named(before, 1, "kitchen"), after);
  EXPECT_EQ(at(found, after), "1 kitchen, 2 area_2");
  EXPECT_EQ(waiting(found), "");
}

TEST(AreaRules, OfAnAreaDividedInHalvesNeitherIsTheSameUntilTheWallIsGone) {
  const SemanticMap whole = drawnAreas({"aaaaaaaaaaa",  //
                                        "aaaaaaaaaaa"});
  const SemanticMap halves = drawnAreas({"aaaaa#bbbbb",  //
                                         "aaaaa#bbbbb"});
  const Recognition divided = next(named(whole, 1, "kitchen"), halves);
  EXPECT_EQ(at(divided, halves), "2 area_2, 3 area_3");
  EXPECT_EQ(waiting(divided), "1 kitchen: its place is divided, at most 50 % of it are one area\n");
  ASSERT_EQ(divided.report.size(), 1U);
  EXPECT_EQ(divided.report[0],
            "area 1 'kitchen' waits: its place is divided, at most 50 % of it are one area");

  const Recognition still = next(divided.knowledge, halves);
  EXPECT_TRUE(difference(divided.knowledge, still.knowledge).empty());
  EXPECT_TRUE(still.report.empty());

  const Recognition back = next(still.knowledge, whole);
  EXPECT_EQ(at(back, whole), "1 kitchen");
  EXPECT_EQ(waiting(back), "");
  EXPECT_EQ(back.knowledge.next_ids.area, 4U);
}

TEST(AreaRules, AutomaticAreasInDoubtAreForgottenAndTheirIdsNeverUsedAgain) {
  const SemanticMap whole = drawnAreas({"aaaaaaaaaaa"});
  const SemanticMap halves = drawnAreas({"aaaaa#bbbbb"});
  const Recognition first = recognise({}, "", whole, "map");
  const Recognition divided = next(first.knowledge, halves);
  EXPECT_EQ(at(divided, halves), "2 area_2, 3 area_3");
  EXPECT_EQ(waiting(divided), "");
  ASSERT_EQ(divided.report.size(), 1U);
  const Recognition back = next(divided.knowledge, whole);
  EXPECT_EQ(at(back, whole), "4 area_4");
}

TEST(AreaRules, OfSeveralAreasThatBecomeOneTheLargeIsTheSame) {
  const SemanticMap before = drawnAreas({"aaaaaaa#bb",  //
                                         "aaaaaaa#bb"});
  const SemanticMap after = drawnAreas({"aaaaaaaaaa",  //
                                        "aaaaaaaaaa"});
  const Recognition large = next(named(before, 1, "kitchen"), after);
  EXPECT_EQ(at(large, after), "1 kitchen");
  const Recognition small = next(named(before, 2, "closet"), after);
  EXPECT_EQ(at(small, after), "1 area_1");
  EXPECT_EQ(waiting(small),
            "2 closet: its place is only a part of an area, 22 % of what is known of it\n");
  const Recognition parted = next(small.knowledge, before);
  EXPECT_EQ(at(parted, before), "1 area_1, 2 closet");
}

TEST(AreaRules, OfTwoEqualAreasThatBecomeOneNeitherIsTheSame) {
  const SemanticMap before = drawnAreas({"aaaaa#bbbbb"});
  const SemanticMap after = drawnAreas({"aaaaaaaaaaa"});
  const Recognition found = next(named(before, 1, "kitchen"), after);
  EXPECT_EQ(at(found, after), "3 area_3");
  EXPECT_EQ(waiting(found),
            "1 kitchen: its place is only a part of an area, 50 % of what is known of it\n");
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
  const SemanticMap large = drawnAreas({"aaaaaaaa#bb"});
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
