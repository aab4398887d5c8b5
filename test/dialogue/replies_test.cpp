// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/dialogue/replies.h"

#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "drawn_home.h"
#include "map/utf8.h"

namespace agrid::dialogue {
namespace {

class Replies : public testing::Test {
 protected:
  Reply say(const std::string& sentence) {
    return respond(englishGrammar(), map_, sentence, robot_, params_);
  }
  std::string answer(const std::string& sentence) {
    const Reply reply = say(sentence);
    EXPECT_FALSE(reply.edit) << sentence;
    return reply.sentence;
  }
  template <typename T>
  T put(const std::string& sentence) {
    const Reply reply = say(sentence);
    if (!reply.edit) ADD_FAILURE() << sentence << ": " << reply.sentence;
    const auto* edit = reply.edit ? std::get_if<TagToPut>(&*reply.edit) : nullptr;
    stays_ = edit && edit->stays;
    return edit ? std::get<T>(edit->tag) : T();
  }
  std::string dropped(const std::string& sentence) {
    const Reply reply = say(sentence);
    const auto* edit = reply.edit ? std::get_if<TagToDrop>(&*reply.edit) : nullptr;
    if (!edit) return reply.sentence;
    return std::to_string(static_cast<int>(edit->kind)) + ":" + std::to_string(edit->id);
  }
  std::string state(const std::string& sentence) {
    const Reply reply = say(sentence);
    const auto* edit = reply.edit ? std::get_if<StateToSet>(&*reply.edit) : nullptr;
    if (!edit) return reply.sentence;
    return std::to_string(static_cast<int>(edit->door)) + ":" +
           std::to_string(static_cast<int>(edit->state));
  }

  SemanticMap map_ = test::drawnHome();
  std::optional<Pose2> robot_ = Pose2{{2, 4.8}, 0};  // in the kitchen, looking to the right
  DialogueParams params_;
  bool stays_ = false;
};

TEST_F(Replies, NamesTheAreaTheRobotIsIn) {
  const auto tag = put<AreaTag>("this is the Galley");
  EXPECT_EQ(tag.id, AreaId{1});
  EXPECT_EQ(tag.name, "Galley");
  EXPECT_EQ(tag.category, "");
  EXPECT_EQ(tag.source, TagSource::kInteraction);
  EXPECT_TRUE(stays_);
  EXPECT_EQ(say("this is the Galley").sentence, "This is Galley.");
}

TEST_F(Replies, ACategoryNamesWhatHasNoGivenName) {
  const auto automatic = put<AreaTag>("this is a kitchen");
  EXPECT_EQ(automatic.category, "kitchen");
  EXPECT_EQ(automatic.name, "kitchen");
  map_.area_map.areas[0].source = TagSource::kManual;
  EXPECT_EQ(put<AreaTag>("this is a kitchen").name, "");
  EXPECT_EQ(say("this is a kitchen").sentence, "I have noted that this is a kitchen.");
  robot_->position = {3, 3};
  EXPECT_EQ(put<AreaTag>("this is a Kitchen").name, "Kitchen_2");  // kitchen is taken
}

TEST_F(Replies, OutsideOfAllAreasASeedIsLaid) {
  robot_ = Pose2{{-3, -4}, 0};
  const auto tag = put<AreaTag>("this is the yard");
  EXPECT_EQ(tag.id, AreaId{});
  EXPECT_EQ(tag.seed_map, Point2(-3, -4));
  EXPECT_FALSE(stays_);
  EXPECT_EQ(answer("where am I"), "We are in no room that I know.");
}

TEST_F(Replies, DoorsLieWhereTheyAreSaidToBe) {
  robot_ = Pose2{{2, 5}, M_PI / 2};
  const auto here = put<DoorTag>("here is a door");
  EXPECT_EQ(here.id, DoorId{});
  EXPECT_EQ(here.pose_map.position, Point2(2, 5));
  EXPECT_DOUBLE_EQ(here.pose_map.yaw, M_PI / 2);
  const auto left = put<DoorTag>("there is a door on the left");
  EXPECT_TRUE(left.pose_map.position.isApprox(Point2(1, 5)));
  EXPECT_DOUBLE_EQ(left.pose_map.yaw, M_PI);  // it leads away from the robot
  EXPECT_EQ(put<DoorTag>("here is a door called exit").name, "exit");
}

TEST_F(Replies, ObjectsLieAtTheSaidOrTheUsualDistance) {
  const auto ahead = put<ObjectTag>("there is a table in front of you");
  EXPECT_EQ(ahead.name, "table");
  EXPECT_EQ(ahead.category, "table");
  EXPECT_TRUE(ahead.pose_map.position.isApprox(Point2(3, 4.8)));
  EXPECT_NEAR(std::remainder(ahead.pose_map.yaw - M_PI, 2 * M_PI), 0, 1e-9);  // it faces the robot
  EXPECT_TRUE(put<ObjectTag>("there is a table 0.5 m on your left")
                  .pose_map.position.isApprox(Point2(2, 5.3)));
  EXPECT_TRUE(
      put<ObjectTag>("there is a table behind you").pose_map.position.isApprox(Point2(1, 4.8)));
  EXPECT_EQ(put<ObjectTag>("here is a table").pose_map.position, Point2(2, 4.8));
  params_.object_distance = 0.3;
  EXPECT_TRUE(
      put<ObjectTag>("there is a table on the right").pose_map.position.isApprox(Point2(2, 4.5)));
  EXPECT_EQ(say("here is a table").sentence, "I have noted table in kitchen.");
}

TEST_F(Replies, ASecondOneGetsANameOfItsOwn) {
  EXPECT_EQ(put<ObjectTag>("here is a Fridge").name, "Fridge_2");
}

TEST_F(Replies, WhatIsKnownMoves) {
  const auto tag = put<ObjectTag>("the Fridge is here");
  EXPECT_EQ(tag.id, ObjectId{1});
  EXPECT_EQ(tag.name, "fridge");
  EXPECT_EQ(tag.category, "appliance");
  EXPECT_EQ(tag.size, Point2(0.4, 0.4));
  EXPECT_EQ(tag.pose_map.position, Point2(2, 4.8));
  EXPECT_EQ(say("the fridge is here").sentence, "fridge is in kitchen now.");
  EXPECT_EQ(answer("the appliance is here"), "'appliance' can be fridge and oven. Which one?");
}

TEST_F(Replies, StatesOfDoors) {
  EXPECT_EQ(state("this door is closed"), "1:2");
  EXPECT_EQ(say("this door is closed").sentence, "I have noted that kitchen door is closed.");
  EXPECT_EQ(state("door_3 is open"), "3:1");
  EXPECT_EQ(state("the kitchen door is open"), "1:1");
  EXPECT_EQ(state("the bath door is closed"), "4:2");  // of an area with one door
  EXPECT_EQ(state("the door to the bedroom is closed"), "3:2");
  EXPECT_EQ(state("the door between the hall and the living room is closed"), "2:2");
  EXPECT_EQ(state("the door between the bath and the kitchen is closed"),
            "I know no door of bath and kitchen.");
  EXPECT_EQ(state("the fridge door is closed").substr(0, 26), "I know no door of fridge.");
  robot_ = Pose2{{11.5, 3}, 0};
  EXPECT_EQ(state("the door to the hall is closed").substr(0, 13), "'hall' can be");
  robot_ = Pose2{{7.6, 2.6}, 0};
  EXPECT_EQ(state("the door to the hall is closed"), "4:2");  // the one beside the robot
  EXPECT_EQ(state("this door is closed"), "4:2");
  params_.door_reach = 0.1;
  EXPECT_EQ(state("this door is closed"), "There is no door within 0.1 m of me.");
}

TEST_F(Replies, Forgetting) {
  EXPECT_EQ(dropped("forget the fridge"), "3:1");
  EXPECT_EQ(dropped("forget the hall"), "1:3");
  EXPECT_EQ(dropped("forget door_3"), "2:3");
  EXPECT_EQ(dropped("forget this door"), "2:1");
  EXPECT_EQ(dropped("there is no door here"), "2:1");
  EXPECT_EQ(dropped("forget the appliance"), "'appliance' can be fridge and oven. Which one?");
  EXPECT_EQ(say("forget the fridge").sentence, "I have forgotten fridge.");
}

TEST_F(Replies, Renaming) {
  EXPECT_EQ(put<DoorTag>("this door is called back door").id, DoorId{1});
  EXPECT_TRUE(stays_);
  EXPECT_EQ(put<AreaTag>("hall is called lobby").name, "lobby");
  EXPECT_EQ(put<ObjectTag>("rename the oven to stove").id, ObjectId{2});
  EXPECT_EQ(say("rename the oven to stove").sentence, "oven is called stove now.");
}

TEST_F(Replies, WhereThingsAre) {
  EXPECT_EQ(answer("where is the fridge"), "fridge is in kitchen, 0.9 m away behind me.");
  EXPECT_EQ(answer("where is the living room"),
            "living room is next to hall, 3.0 m away ahead of me.");
  EXPECT_EQ(answer("where is the kitchen"), "We are in kitchen right now.");
  EXPECT_EQ(answer("where is door_3"),
            "door_3 is between hall and bedroom, 2.6 m away on my right.");
  EXPECT_EQ(
      answer("where is the appliance"),
      "oven is in kitchen, 0.5 m away on my left. fridge is in kitchen, 0.9 m away behind me.");
  robot_.reset();
  EXPECT_EQ(answer("where is the fridge"), "fridge is in kitchen.");
  EXPECT_EQ(answer("where am I"), "I do not know where I am.");
}

TEST_F(Replies, WhichRoom) {
  EXPECT_EQ(answer("which room is this"), "We are in kitchen.");
  robot_->position = {3, 3};
  EXPECT_EQ(answer("which room is this"), "We are in hall, a corridor.");
}

TEST_F(Replies, RelationsInSentences) {
  EXPECT_EQ(answer("what is in the kitchen"), "There is fridge and oven in kitchen.");
  EXPECT_EQ(answer("what is in the bath"), "I know of nothing in bath.");
  EXPECT_EQ(answer("which rooms are next to the kitchen"),
            "There is living room (0.5 m) and hall (0.5 m) next to kitchen.");
  robot_->position.y() = 4.97;
  EXPECT_EQ(answer("where is the nearest door"), "There is kitchen door (1.2 m) nearest to me.");
  params_.most_named = 1;
  EXPECT_EQ(answer("which rooms are next to the hall"),
            "There is kitchen (0.5 m) and 3 more next to hall.");
  EXPECT_EQ(say("which rooms are next to the hall").things.size(), 4U);
}

TEST_F(Replies, P7_UnknownNamesAreAnsweredWithTheClosest) {
  EXPECT_EQ(answer("where is the kichen"),
            "I do not know 'kichen'. I know kitchen, oven and bath.");
  EXPECT_EQ(answer("forget the frigde").substr(0, 40), "I do not know 'frigde'. I know fridge, b");
  map_.area_map.areas.clear();
  map_.area_map.doors.clear();
  map_.knowledge.objects.clear();
  EXPECT_EQ(answer("where is Bob"), "I do not know 'Bob', nothing has a name yet.");
}

TEST_F(Replies, T8_NamesThatCannotBe) {
  EXPECT_EQ(answer("this is \xe2\x80\xaegpj"), "That cannot be a name.");
  EXPECT_EQ(answer("this is " + std::string(300, 'a')), "That cannot be a name.");
  EXPECT_EQ(answer("where is \xe2\x80\xaegpj"), "That cannot be a name.");
  EXPECT_EQ(put<AreaTag>("this is the \xe5\x8e\xa8\xe6\x88\xbf").name, "\xe5\x8e\xa8\xe6\x88\xbf");
}

TEST_F(Replies, WhatIsNotUnderstoodIsAnsweredWithWhatIs) {
  EXPECT_EQ(answer("make coffee"),
            "I did not understand 'make coffee'. Say 'help' to hear what I understand.");
  EXPECT_NE(answer("help").find("'this is the kitchen'"), std::string::npos);
  EXPECT_LT(answer(std::string(100000, 'x')).size(), 300U);
}

TEST_F(Replies, WithoutAPoseWhatIsSaidHereIsNotDone) {
  robot_.reset();
  for (const char* sentence : {"this is the kitchen", "here is a door", "here is a table",
                               "this door is closed", "what is left of the fridge"}) {
    EXPECT_EQ(answer(sentence), "I do not know where I am.") << sentence;
  }
  EXPECT_EQ(state("door_3 is open"), "3:1");
}

TEST_F(Replies, Queries) {
  const auto ask = [&](const std::string& text) {
    return answerQuery(englishGrammar(), map_, text, robot_, params_);
  };
  for (const char* text : {"near oven", "near(oven)", "What is near the oven?"}) {
    const QueryAnswer answer = ask(text);
    EXPECT_EQ(answer.status, QueryStatus::kAnswered);
    EXPECT_EQ(test::namesOf(answer.things), "fridge;kitchen door;hall;") << text;
    EXPECT_EQ(answer.distances.size(), 3U);
  }
  EXPECT_EQ(test::namesOf(ask("where is the hall").things), "hall;");
  EXPECT_EQ(test::namesOf(ask("where am I").things), "kitchen;");
  EXPECT_EQ(ask("make coffee").status, QueryStatus::kNotUnderstood);
  EXPECT_EQ(ask("this is the kitchen").status, QueryStatus::kNotUnderstood);  // no edit by asking
  EXPECT_THROW(ask("near kichen"), LookupError);
  robot_.reset();
  EXPECT_EQ(ask("left_of fridge").status, QueryStatus::kNoPose);
  EXPECT_TRUE(std::isnan(ask("where is the hall").distances.at(0)));
}

TEST_F(Replies, BadParametersAreNamed) {
  params_.door_reach = std::nan("");
  EXPECT_THROW(say("help"), std::invalid_argument);
  EXPECT_NE(problemOf(params_).find("door_reach"), std::string::npos);
  params_ = {};
  params_.relations.near = -1;
  EXPECT_NE(problemOf(params_).find("near"), std::string::npos);
  params_ = {};
  params_.most_named = 0;
  EXPECT_NE(problemOf(params_).find("most_named"), std::string::npos);
  EXPECT_EQ(problemOf(DialogueParams{}), "");
}

TEST_F(Replies, RandomWordsNeverDoHarm) {
  const std::vector<std::string> words = {
      "this",  "is",    "the",          "a",       "kitchen", "door",  "fridge", "here",
      "there", "not",   "in",           "of",      "you",     "left",  "closed", "2",
      "m",     "where", "near",         "nearest", "what",    "to",    "no",     "{",
      "*",     "\xff",  "\xe2\x80\xae", ",",       "'",       "forget"};
  std::mt19937 random(11);
  for (int i = 0; i < 3000; ++i) {
    std::string sentence;
    const std::size_t count = random() % 12;
    for (std::size_t k = 0; k < count; ++k) sentence += words[random() % words.size()] + " ";
    const Reply reply = say(sentence);
    EXPECT_FALSE(reply.sentence.empty());
    EXPECT_TRUE(codePointsOf(reply.sentence)) << sentence;
  }
}

TEST_F(Replies, RandomBytesNeverDoHarm) {
  std::mt19937 random(12);
  for (int i = 0; i < 3000; ++i) {
    std::string sentence(random() % 80, ' ');
    for (char& c : sentence) c = static_cast<char>(random());
    EXPECT_TRUE(codePointsOf(say("where is " + sentence).sentence));
    EXPECT_TRUE(codePointsOf(say(sentence).sentence));
  }
}

TEST_F(Replies, RefusalsAndNoMap) {
  EXPECT_EQ(refusal(englishGrammar(), "the name is taken"), "I cannot do that: the name is taken.");
  EXPECT_EQ(noMapYet(englishGrammar()), "I have no map yet.");
}

}  // namespace
}  // namespace agrid::dialogue
