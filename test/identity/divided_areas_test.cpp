// SPDX-License-Identifier: BSD-3-Clause
// Areas that are divided, or become one.
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

TEST(DividedAreas, OfADividedAreaTheLargePartIsTheSame) {
  const SemanticMap before = drawnAreas({"aaaaaaaaaa",  //
                                         "aaaaaaaaaa"});
  const SemanticMap after = drawnAreas({"aaaaaaa#bb",  //
                                        "aaaaaaa#bb"});
  const Recognition found = next(named(before, 1, "kitchen"), after);
  EXPECT_EQ(at(found, after), "1 kitchen, 2 area_2");
  EXPECT_EQ(waiting(found), "");
}

TEST(DividedAreas, OfAnAreaDividedInHalvesNeitherIsTheSameUntilTheWallIsGone) {
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

TEST(DividedAreas, AnAutomaticAreaInPiecesIsForgottenAndItsIdNeverUsedAgain) {
  const SemanticMap whole = drawnAreas({"aaaaaaaaaaaaaaa"});
  const SemanticMap pieces = drawnAreas({"aaa#bbb#ccc#ddd"});
  const Recognition first = recognise({}, "", whole, "map");
  const Recognition divided = next(first.knowledge, pieces);
  EXPECT_EQ(at(divided, pieces), "2 area_2, 3 area_3, 4 area_4, 5 area_5");
  EXPECT_EQ(waiting(divided), "");
  ASSERT_EQ(divided.report.size(), 1U);
  EXPECT_EQ(divided.report[0],
            "area 1 'area_1' is gone: its place is divided, at most 25 % of it are one area");
  const Recognition back = next(divided.knowledge, whole);
  EXPECT_EQ(at(back, whole), "6 area_6");
}

TEST(DividedAreas, OfAnAutomaticAreaDividedInTwoOnePartIsTheSame) {
  const SemanticMap whole = drawnAreas({"aaaaaaaaaaa"});
  const SemanticMap parts = drawnAreas({"aaaa#bbbbbb"});
  const Recognition divided = next(recognise({}, "", whole, "map").knowledge, parts);
  EXPECT_EQ(at(divided, parts), "2 area_2, 1 area_1");
  EXPECT_EQ(at(next(divided.knowledge, whole), whole), "1 area_1");
}

// the best pair alone would leave area 2 without a place
TEST(DividedAreas, AutomaticAreasArePairedSoThatAllInAllMostIsKept) {
  const SemanticMap before = drawnAreas({"aaaaaaaaaabbbbbbbb####"});
  const SemanticMap after = drawnAreas({"aaaaabbbbbbbbbbbbbbbbb"});
  const Recognition found = next(recognise({}, "", before, "map").knowledge, after);
  EXPECT_EQ(at(found, after), "1 area_1, 2 area_2");
}

TEST(DividedAreas, OfSeveralAreasThatBecomeOneTheLargeIsTheSame) {
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

TEST(DividedAreas, OfTwoEqualAreasThatBecomeOneTheGivenNameWaits) {
  const SemanticMap before = drawnAreas({"aaaaa#bbbbb"});
  const SemanticMap after = drawnAreas({"aaaaaaaaaaa"});
  const Recognition found = next(named(before, 1, "kitchen"), after);
  EXPECT_EQ(at(found, after), "2 area_2");
  EXPECT_EQ(waiting(found),
            "1 kitchen: its place is only a part of an area, 50 % of what is known of it\n");
  Knowledge both = named(before, 1, "kitchen");
  both.areas[1].source = TagSource::kInteraction;
  EXPECT_EQ(at(next(both, after), after), "3 area_3");
}

TEST(DividedAreas, AGivenNameNeverLeavesThePointThatWasNamed) {
  const SemanticMap before = drawnAreas({"aaaaaaaaaa"});
  const SemanticMap after = drawnAreas({"aaaaaaa#bb"});
  Knowledge known = named(before, 1, "kitchen");
  known.areas[0].seed_map = Point2(4.75, 0.25);
  const Recognition found = next(known, after);
  EXPECT_EQ(at(found, after), "2 area_2, 3 area_3");
  EXPECT_EQ(waiting(found),
            "1 kitchen: most of its place is one area, the point that was named lies in another\n");
}

TEST(DividedAreas, ToComeBackANameNeedsMoreThanToStay) {
  const SemanticMap whole = drawnAreas({"aaaaaaaaaaaaaaa"});
  const SemanticMap halves = drawnAreas({"aaaaaaa#bbbbbbb"});
  const SemanticMap most = drawnAreas({"aaaaaaaaaa#bbbb"});
  EXPECT_EQ(at(next(named(whole, 1, "kitchen"), most), most), "1 kitchen, 2 area_2");
  const Recognition waits = next(named(whole, 1, "kitchen"), halves);
  EXPECT_EQ(next(waits.knowledge, most).knowledge.pending.size(), 1U);
}

}  // namespace
}  // namespace agrid
