// SPDX-License-Identifier: BSD-3-Clause
#include <sstream>
#include <type_traits>

#include <gtest/gtest.h>

#include "agrid/dialogue/grammar.h"

namespace agrid::dialogue {
namespace {

/// An utterance in one line.
struct Told {
  std::string operator()(const SaidArea& s) const { return "area " + s.name + "/" + s.category; }
  std::string operator()(const SaidDoor& s) const { return "door " + s.name + spot(s.spot); }
  std::string operator()(const SaidObject& s) const {
    return "object " + s.name + "/" + s.category + spot(s.spot);
  }
  std::string operator()(const SaidState& s) const {
    return std::string(s.state == DoorState::kOpen     ? "open "
                       : s.state == DoorState::kClosed ? "closed "
                                                       : "unknown ") +
           which(s.door);
  }
  std::string operator()(const SaidName& s) const { return "rename " + s.thing + "/" + s.name; }
  std::string operator()(const SaidForget& s) const { return "forget " + s.thing; }
  std::string operator()(const SaidForgetDoor& s) const { return "forget door " + which(s.door); }
  std::string operator()(const AskedWhere& s) const { return "where " + s.thing; }
  std::string operator()(const AskedArea&) const { return "which area"; }
  std::string operator()(const AskedHelp&) const { return "help"; }
  std::string operator()(const NotUnderstood&) const { return "?"; }
  std::string operator()(const Question& q) const {
    const std::string what = q.kind ? "kind" + std::to_string(static_cast<int>(*q.kind)) : q.what;
    return relationNames().at(static_cast<std::size_t>(q.relation)) + "(" + what + ", " +
           (q.place_is_robot ? "robot" : q.place) + ")";
  }

  static std::string which(const WhichDoor& d) {
    return d.name + "/" + d.area + "/" + d.other_area;
  }
  static std::string spot(const Spot& spot) {
    std::ostringstream text;
    text << " side" << static_cast<int>(spot.side);
    if (spot.distance) text << " " << *spot.distance;
    return text.str();
  }
};

std::string told(const std::string& sentence, const Grammar& grammar = englishGrammar()) {
  return std::visit(Told{}, understand(grammar, sentence));
}

TEST(Sentences, Areas) {
  EXPECT_EQ(told("this is the kitchen"), "area kitchen/");
  EXPECT_EQ(told("This is the Kitchen."), "area Kitchen/");
  EXPECT_EQ(told("  please, THIS IS my kitchen,   thank you!! "), "area kitchen/");
  EXPECT_EQ(told("this is room 315"), "area room 315/");
  EXPECT_EQ(told("this is a corridor"), "area /corridor");
  EXPECT_EQ(told("this is called the Blue Room"), "area Blue Room/");
  EXPECT_EQ(told("this room is called lab 2"), "area lab 2/");
  EXPECT_EQ(told("we're in the hall"), "area hall/");
  EXPECT_EQ(told("we\xe2\x80\x99re in the hall"), "area hall/");  // a typographic apostrophe
  EXPECT_EQ(told("hey robot, this is Dr. Smith's office"), "area Dr. Smith's office/");
  EXPECT_EQ(told("this is called \"K\xc3\xbc\x63he\", thanks"), "area K\xc3\xbc\x63he/");
}

TEST(Sentences, T8_NamesOfAnyLanguageAsTheyWereSaid) {
  EXPECT_EQ(told("this is the K\xc3\x9c\x43HE"), "area K\xc3\x9c\x43HE/");
  EXPECT_EQ(told("this is \xe5\x8e\xa8\xe6\x88\xbf\xe3\x80\x82"), "area \xe5\x8e\xa8\xe6\x88\xbf/");
  EXPECT_EQ(told("forget the \xf0\x9f\x8d\xb3"), "forget \xf0\x9f\x8d\xb3");
}

TEST(Sentences, Doors) {
  EXPECT_EQ(told("here is a door"), "door  side0");
  EXPECT_EQ(told("this is a door"), "door  side0");
  EXPECT_EQ(told("here's a door called back door"), "door back door side0");
  EXPECT_EQ(told("here is the kitchen door"), "door kitchen door side0");
  EXPECT_EQ(told("there is a door in front of you"), "door  side1");
  EXPECT_EQ(told("there's a door 1.5 metres ahead"), "door  side1 1.5");
  EXPECT_EQ(told("there is a door on your left"), "door  side2");
  EXPECT_EQ(told("the kitchen door is two m to the right of you"), "door kitchen door side3 2");
  EXPECT_EQ(told("there is a door behind you"), "door  side4");
}

TEST(Sentences, Objects) {
  EXPECT_EQ(told("there is a fridge in front of you"), "object /fridge side1");
  EXPECT_EQ(told("there is a big fridge 2 m in front of me"), "object /big fridge side1 2");
  EXPECT_EQ(told("the fridge is half a metre to your left"), "object fridge/ side2 0.5");
  EXPECT_EQ(told("here is the fridge"), "object fridge/ side0");
  EXPECT_EQ(told("here is an oven"), "object /oven side0");
  EXPECT_EQ(told("the Fridge is here"), "object Fridge/ side0");
  EXPECT_EQ(told("there is a table 1,5 m on your right"), "object /table side3 1.5");
  EXPECT_EQ(told("there is a plant behind you"), "object /plant side4");
  EXPECT_EQ(told("there is a table 1e9 m ahead"), "object /table 1e9 m side1");
}

TEST(Sentences, States) {
  EXPECT_EQ(told("this door is closed"), "closed //");
  EXPECT_EQ(told("the door is locked"), "closed //");
  EXPECT_EQ(told("this door is open now"), "open //");
  EXPECT_EQ(told("door_3 is closed"), "closed door_3//");
  EXPECT_EQ(told("the kitchen door is open"), "open kitchen door/kitchen/");
  EXPECT_EQ(told("the door to the kitchen is closed"), "closed /kitchen/");
  EXPECT_EQ(told("the door between the kitchen and the hall is shut"), "closed /kitchen/hall");
  EXPECT_EQ(told("mark the kitchen door as open"), "open kitchen door/kitchen/");
  EXPECT_EQ(told("I don't know whether this door is open"), "unknown //");
}

TEST(Sentences, WhatIsAskedOfTheRobotIsNotTakenForAFact) {
  EXPECT_EQ(told("open the kitchen door"), "?");
  EXPECT_EQ(told("close the door"), "?");
  EXPECT_EQ(told("this is not the kitchen"), "?");
  EXPECT_EQ(told("there is nothing in front of you"), "?");
  EXPECT_EQ(told("who is behind you"), "?");
}

TEST(Sentences, NamesAndForgetting) {
  EXPECT_EQ(told("this door is called main door"), "rename /main door");
  EXPECT_EQ(told("area_3 is called lab"), "rename area_3/lab");
  EXPECT_EQ(told("rename the lab to workshop"), "rename lab/workshop");
  EXPECT_EQ(told("forget the fridge"), "forget fridge");
  EXPECT_EQ(told("there is no fridge here anymore"), "forget fridge");
  EXPECT_EQ(told("the sofa is gone"), "forget sofa");
  EXPECT_EQ(told("forget this door"), "forget door //");
  EXPECT_EQ(told("there is no door here"), "forget door //");
  EXPECT_EQ(told("forget the kitchen door"), "forget door kitchen door/kitchen/");
  EXPECT_EQ(told("remove the door between hall and bath"), "forget door /hall/bath");
}

TEST(Sentences, Questions) {
  EXPECT_EQ(told("where is the kitchen"), "where kitchen");
  EXPECT_EQ(told("Can you tell me where the kitchen is?"), "where kitchen");
  EXPECT_EQ(told("in which room is the fridge?"), "where fridge");
  EXPECT_EQ(told("where am I?"), "which area");
  EXPECT_EQ(told("which room is this"), "which area");
  EXPECT_EQ(told("what's this"), "which area");
  EXPECT_EQ(told("what can I say?"), "help");
  EXPECT_EQ(told("help"), "help");
}

TEST(Sentences, Relations) {
  EXPECT_EQ(told("what is next to the kitchen"), "next_to(, kitchen)");
  EXPECT_EQ(told("What's near the fridge?"), "near(, fridge)");
  EXPECT_EQ(told("near fridge"), "near(, fridge)");
  EXPECT_EQ(told("what is in the living room"), "in(, living room)");
  EXPECT_EQ(told("which rooms are next to the hall"), "next_to(kind1, hall)");
  EXPECT_EQ(told("is there a fridge near the kitchen"), "near(fridge, kitchen)");
  EXPECT_EQ(told("where is the nearest door"), "nearest_to(kind2, robot)");
  EXPECT_EQ(told("what is the nearest toilet to the lab"), "nearest_to(toilet, lab)");
  EXPECT_EQ(told("what is nearest to the lab"), "nearest_to(, lab)");
  EXPECT_EQ(told("what is north of the hall"), "north_of(, hall)");
  EXPECT_EQ(told("which rooms are east of the hall"), "east_of(kind1, hall)");
  EXPECT_EQ(told("what lies south of the hall"), "south_of(, hall)");
  EXPECT_EQ(told("west of hall"), "west_of(, hall)");
  EXPECT_EQ(told("what is left of the fridge"), "left_of(, fridge)");
  EXPECT_EQ(told("what is to the right of the fridge"), "right_of(, fridge)");
  EXPECT_EQ(told("what is on your left"), "left_of(, robot)");
  EXPECT_EQ(told("what is in front of you"), "in_front_of(, robot)");
  EXPECT_EQ(told("what is in front of the sofa"), "in_front_of(, sofa)");
  EXPECT_EQ(told("which objects are behind the sofa"), "behind(kind3, sofa)");
  EXPECT_EQ(told("what is near you"), "near(, robot)");
}

TEST(Sentences, WhatIsNotUnderstood) {
  for (const std::string& sentence :
       {std::string(), std::string("please"), std::string("   "), std::string("..."),
        std::string("this is"), std::string("this is the"), std::string("\xff\xfe"),
        std::string("make me a coffee"), std::string(513, 'a'),
        "this is " + std::string(600, 'a')}) {
    EXPECT_EQ(told(sentence).substr(0, 1), sentence == "this is the" ? "a" : "?") << sentence;
  }
}

}  // namespace
}  // namespace agrid::dialogue
