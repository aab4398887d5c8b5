// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/semantic_map/thing_lookup.h"

#include <gtest/gtest.h>

#include "support/two_rooms.h"

namespace agrid {
namespace {

class ThingLookup : public testing::Test {
 protected:
  /// The names found, or what is wrong and the message.
  std::string find(const std::string& word, const LookupScope& scope = {true, true}) {
    std::string result;
    try {
      for (const Thing& thing : findThings(map_, word, scope).things) result += nameOf(thing) + ";";
    } catch (const LookupError& error) {
      const bool unknown = error.code() == LookupErrorCode::kUnknownName;
      return std::string(unknown ? "unknown: " : "bad: ") + error.what();
    }
    return result;
  }

  SemanticMap map_ = test::twoRooms();
};

TEST_F(ThingLookup, ByNameOfEachKind) {
  EXPECT_EQ(find("hall"), "hall;");
  EXPECT_EQ(find("pass"), "pass;");
  EXPECT_EQ(find("fridge"), "fridge;");
}

TEST_F(ThingLookup, ByAlias) {
  EXPECT_EQ(find("cuisine"), "Kitchen;");
  EXPECT_EQ(find("galley"), "Kitchen;");
}

TEST_F(ThingLookup, WhateverTheCaseUnlessWrittenSo) {
  EXPECT_EQ(find("kitchen"), "Kitchen;");
  EXPECT_EQ(find("KITCHEN"), "Kitchen;");
  map_.area_map.areas[0].name = "kitchen";
  EXPECT_EQ(find("kitchen"), "kitchen;");
  EXPECT_EQ(find("KITCHEN"), "kitchen;Kitchen;");
}

TEST_F(ThingLookup, ByCategoryOnlyWhereAsked) {
  EXPECT_EQ(find("corridor"), "hall;");
  EXPECT_EQ(find("Appliance"), "fridge;");
  EXPECT_EQ(find("corridor", {true, false}).substr(0, 7), "unknown");
}

TEST_F(ThingLookup, ByGuessedCategoryWhereNobodyGaveOne) {
  map_.area_map.areas[0].category_guess = "room";  // its given category is 'corridor'
  map_.area_map.areas[1].category_guess = "room";
  EXPECT_EQ(find("Room"), "Kitchen;");
  EXPECT_EQ(find("room", {true, false}).substr(0, 7), "unknown");
  map_.area_map.areas[1].category_guess = "corridor";
  EXPECT_EQ(find("corridor"), "hall;");
  EXPECT_EQ(find("room").substr(0, 7), "unknown");
  EXPECT_NE(find("corridors").find("are: corridor"), std::string::npos);
}

TEST_F(ThingLookup, SaysThatACategoryIsAGuess) {
  map_.area_map.areas[1].category_guess = "room";
  const FoundThings guessed = findThings(map_, "room", {true, true});
  EXPECT_NE(guessed.remark.find("guess"), std::string::npos);
  EXPECT_EQ(withRemark(guessed, ""), guessed.remark);
  EXPECT_EQ(withRemark(guessed, "why"), guessed.remark + "; why");
  const FoundThings given = findThings(map_, "corridor", {true, true});
  EXPECT_EQ(withRemark(given, "why"), "why");
  EXPECT_EQ(withRemark(given, ""), "");
}

TEST_F(ThingLookup, DoorsOnlyWhereAsked) {
  EXPECT_EQ(find("pass", {false, true}).substr(0, 7), "unknown");
}

TEST_F(ThingLookup, ByIdOfAnAreaUnlessItIsAName) {
  EXPECT_EQ(find("7"), "Kitchen;");
  EXPECT_EQ(find("9").substr(0, 7), "unknown");  // an object's
  map_.area_map.areas[0].name = "7";
  EXPECT_EQ(find("7"), "7;");
}

TEST_F(ThingLookup, P7_UnknownNameListsTheClosest) {
  const std::string answer = find("kichen");
  EXPECT_EQ(answer.substr(0, 7), "unknown");
  EXPECT_NE(answer.find("are: Kitchen"), std::string::npos) << answer;
  map_.area_map.areas.clear();
  map_.area_map.doors.clear();
  map_.knowledge.objects.clear();
  EXPECT_NE(find("kichen").find("nothing has a name"), std::string::npos);
}

TEST_F(ThingLookup, T8_WordsThatAreNoNames) {
  for (const std::string& bad : {std::string(), std::string(257, 'a'), std::string("a\nb"),
                                 std::string("a\0b", 3), std::string("\xff")}) {
    EXPECT_EQ(find(bad).substr(0, 3), "bad") << bad;
    EXPECT_LT(find(bad).size(), 300U);
  }
}

TEST_F(ThingLookup, LettersBeyondAsciiWhateverTheirCase) {
  map_.area_map.areas[0].name = "K\xc3\x9c\x43HE";
  map_.area_map.areas[1].name = "\xd0\x9a\xd1\x83\xd1\x85\xd0\xbd\xd1\x8f";
  EXPECT_EQ(find("k\xc3\xbc\x63he"), "K\xc3\x9c\x43HE;");
  EXPECT_EQ(find("\xd0\xba\xd0\xa3\xd0\xa5\xd0\x9d\xd0\xaf"),
            "\xd0\x9a\xd1\x83\xd1\x85\xd0\xbd\xd1\x8f;");
  map_.area_map.areas[1].category = "\xe5\x8e\xa8\xe6\x88\xbf";  // has no case
  EXPECT_EQ(find("\xe5\x8e\xa8\xe6\x88\xbf"), "\xd0\x9a\xd1\x83\xd1\x85\xd0\xbd\xd1\x8f;");
}

TEST_F(ThingLookup, NamesAndPlacesOfEachKind) {
  const auto only = [&](const std::string& word) {
    return findThings(map_, word, {true, true}).things.at(0);
  };
  EXPECT_EQ(nameOf(only("hall")), "hall");
  EXPECT_EQ(positionOf(only("hall")), Point2(2.5, 2.5));
  EXPECT_EQ(positionOf(only("pass")), Point2(4.5, 2.5));
  EXPECT_EQ(positionOf(only("fridge")), Point2(7.5, 3.5));
  EXPECT_EQ(allNamesOf(only("galley")), (std::vector<std::string>{"Kitchen", "cuisine", "galley"}));
}

}  // namespace
}  // namespace agrid
