// SPDX-License-Identifier: BSD-3-Clause
#include "ros/thing_lookup.h"

#include <gtest/gtest.h>

#include "ros/request_error.h"
#include "two_rooms.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;

std::string nameOf(const Thing& thing) {
  return std::visit([](const auto* held) { return held->name; }, thing);
}

class ThingLookup : public testing::Test {
 protected:
  /// The names found, or the status and message.
  std::string find(const std::string& word, const LookupScope& scope = {true, true}) {
    std::string result;
    try {
      for (const Thing& thing : findThings(map_, word, scope).things) result += nameOf(thing) + ";";
    } catch (const RequestError& error) {
      return std::to_string(error.code()) + " " + error.what();
    }
    return result;
  }

  agrid::SemanticMap map_ = test::twoRooms();
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
  EXPECT_EQ(find("corridor", {true, false}).front(), '4');
}

TEST_F(ThingLookup, ByGuessedCategoryWhereNobodyGaveOne) {
  map_.area_map.areas[0].category_guess = "room";  // its given category is 'corridor'
  map_.area_map.areas[1].category_guess = "room";
  EXPECT_EQ(find("Room"), "Kitchen;");
  EXPECT_EQ(find("room", {true, false}).front(), '4');
  map_.area_map.areas[1].category_guess = "corridor";
  EXPECT_EQ(find("corridor"), "hall;");
  EXPECT_EQ(find("room").front(), '4');
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

TEST_F(ThingLookup, DoorsOnlyWhereAsked) { EXPECT_EQ(find("pass", {false, true}).front(), '4'); }

TEST_F(ThingLookup, ByIdOfAnAreaUnlessItIsAName) {
  EXPECT_EQ(find("7"), "Kitchen;");
  EXPECT_EQ(find("9").front(), '4');  // an object's
  map_.area_map.areas[0].name = "7";
  EXPECT_EQ(find("7"), "7;");
}

TEST_F(ThingLookup, P7_UnknownNameListsTheClosest) {
  const std::string answer = find("kichen");
  EXPECT_EQ(answer.front(), '4');
  EXPECT_NE(answer.find("are: Kitchen"), std::string::npos) << answer;
  map_.area_map.areas.clear();
  map_.area_map.doors.clear();
  map_.knowledge.objects.clear();
  EXPECT_NE(find("kichen").find("nothing has a name"), std::string::npos);
}

TEST_F(ThingLookup, T8_WordsThatAreNoNames) {
  for (const std::string& bad : {std::string(), std::string(257, 'a'), std::string("a\nb"),
                                 std::string("a\0b", 3), std::string("\xff")}) {
    EXPECT_EQ(find(bad).front(), '2') << bad;
    EXPECT_LT(find(bad).size(), 300U);
  }
}

}  // namespace
}  // namespace agrid_map_ros
