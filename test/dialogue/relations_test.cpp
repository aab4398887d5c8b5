// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/dialogue/relations.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "drawn_home.h"

namespace agrid::dialogue {
namespace {

class Relations : public testing::Test {
 protected:
  std::string ask(const std::string& terse, std::optional<Pose2> robot = {},
                  const RelationParams& params = {}) {
    const auto question = terseQuestion(terse);
    if (!question) return "not understood";
    std::vector<Thing> things;
    distances_.clear();
    for (const Related& related : findRelated(map_, *question, robot, params)) {
      things.push_back(related.thing);
      distances_.push_back(related.distance);
    }
    return test::namesOf(things);
  }

  SemanticMap map_ = test::drawnHome();
  std::vector<double> distances_;
};

TEST_F(Relations, In) {
  EXPECT_EQ(ask("in kitchen"), "fridge;oven;");
  EXPECT_EQ(ask("in(bedroom)"), "bed;");
  EXPECT_EQ(ask("in hall"), "");
  EXPECT_EQ(ask("in(door, hall)"), "kitchen door;door_2;door_3;door_4;");
  EXPECT_EQ(ask("in(appliance, kitchen)"), "fridge;oven;");
  EXPECT_EQ(ask("in(appliance, bedroom)"), "");
  EXPECT_EQ(ask("in robot", Pose2{{2, 5}, 0}), "fridge;oven;");
  EXPECT_EQ(ask("in robot", Pose2{{-2, 5}, 0}), "");
}

TEST_F(Relations, InAnObject) {
  map_.knowledge.objects.push_back(map_.knowledge.objects.at(0));
  map_.knowledge.objects.back().name = "pillow";
  map_.knowledge.objects.back().pose_map.position = {2.9, 1};
  EXPECT_EQ(ask("in bed"), "pillow;");
  EXPECT_EQ(ask("in pillow"), "");
}

TEST_F(Relations, AnObjectThatIsAnObstacleBelongsToTheAreaAroundIt) {
  std::vector<std::uint16_t> labels = map_.area_map.pixel_labels.vector();
  for (std::uint16_t& label : labels) {
    if (label == 1) label = 0;  // the kitchen's pixels
  }
  map_.area_map.pixel_labels = std::move(labels);
  EXPECT_EQ(ask("in kitchen"), "fridge;oven;");
}

TEST_F(Relations, NearByOutlinesNotCenters) {
  EXPECT_EQ(ask("near fridge"), "oven;kitchen door;hall;");
  EXPECT_NEAR(distances_.at(0), 0.6, 1e-9);
  // its box reaches to 0.5 m from the door though its centre is farther away
  EXPECT_EQ(ask("near(door, bed)"), "door_3;");
  EXPECT_NEAR(distances_.at(0), 0.75, 1e-9);
  EXPECT_EQ(ask("near(area, kitchen)"), "living room;hall;bedroom;");
  EXPECT_NEAR(distances_.at(0), 0.5, 1e-9);
  EXPECT_NEAR(distances_.at(1), 0.5, 1e-9);
  EXPECT_NEAR(distances_.at(2), 2, 1e-9);
}

TEST_F(Relations, NearIsAParameter) {
  RelationParams params;
  params.near = 1.9;
  EXPECT_EQ(ask("near(area, kitchen)", {}, params), "living room;hall;");
}

TEST_F(Relations, WhatIsBehindAWallIsNotNear) {
  map_.knowledge.objects.at(2).pose_map.position = {5.6, 5.5};  // the sofa, close to the kitchen
  map_.knowledge.objects.at(2).size = {1, 1};
  map_.knowledge.objects.at(1).pose_map.position = {4.2, 5.5};  // the oven, on the other side
  EXPECT_EQ(ask("near oven").find("sofa"), std::string::npos);
  EXPECT_NE(ask("near kitchen").find("sofa"), std::string::npos);
}

TEST_F(Relations, NearTheRobot) {
  EXPECT_EQ(ask("near robot", Pose2{{2, 4.8}, 0}), "oven;fridge;kitchen door;hall;");
}

TEST_F(Relations, NextTo) {
  EXPECT_EQ(ask("next_to(area, kitchen)"), "living room;hall;");  // a wall between; a door between
  EXPECT_EQ(ask("next_to kitchen"), "kitchen door;living room;hall;");
  EXPECT_EQ(ask("next_to(area, kitchen door)"), "kitchen;hall;");
  EXPECT_EQ(ask("next_to fridge"), "");
  RelationParams params;
  params.next_to = 0.1;
  EXPECT_EQ(ask("next_to(area, kitchen)", {}, params), "hall;");
  params.next_to = 0.7;
  EXPECT_EQ(ask("next_to fridge", {}, params), "oven;");
}

TEST_F(Relations, NearestTo) {
  EXPECT_EQ(ask("nearest_to fridge"), "oven;");
  EXPECT_EQ(ask("nearest_to(door, fridge)"), "kitchen door;");
  EXPECT_EQ(ask("nearest_to(area, fridge)"), "kitchen;");  // it is in it
  EXPECT_EQ(ask("nearest_to(appliance, living room)"), "oven;");
  EXPECT_EQ(ask("nearest_to(corridor, bed)"), "hall;");
  EXPECT_EQ(ask("nearest_to(door, robot)", Pose2{{11, 3}, 0}), "door_4;");
}

TEST_F(Relations, DirectionsOfTheCompass) {
  EXPECT_EQ(ask("north_of(area, hall)"), "kitchen;living room;");
  EXPECT_EQ(ask("south_of(area, hall)"), "bedroom;bath;");
  EXPECT_EQ(ask("east_of(area, kitchen)"), "living room;hall;bath;");
  EXPECT_EQ(ask("west_of(area, living room)"), "kitchen;");
  EXPECT_EQ(ask("west_of(object, oven)"), "fridge;");
  EXPECT_EQ(ask("north_of kitchen"), "");
}

TEST_F(Relations, NorthCanBeElsewhere) {
  RelationParams params;
  params.north_yaw_deg = 0;  // along +x
  EXPECT_EQ(ask("north_of(area, kitchen)", {}, params), "living room;hall;bath;");
  EXPECT_EQ(ask("west_of(area, hall)", {}, params), "kitchen;living room;");
}

TEST_F(Relations, TheSectorIsAParameter) {
  map_.knowledge.objects.at(1).pose_map.position = {2, 6};  // 0.5 m up and 1 m to the right of it
  EXPECT_EQ(ask("east_of(object, fridge)"), "oven;sofa;");
  RelationParams params;
  params.sector_half_angle_deg = 20;
  EXPECT_EQ(ask("east_of(object, fridge)", {}, params), "sofa;");
}

TEST_F(Relations, SidesAreSeenFromTheRobot) {
  const Pose2 below{{1.5, 4.2}, 0};  // it looks up at the fridge wherever it heads to
  EXPECT_EQ(ask("right_of(object, fridge)", below), "oven;");
  EXPECT_EQ(ask("left_of(object, oven)", below), "fridge;");
  const Pose2 above{{1.5, 7}, 0};
  EXPECT_EQ(ask("left_of(object, fridge)", above), "oven;");
  const Pose2 left{{0.6, 5.5}, 0};
  EXPECT_EQ(ask("behind(object, fridge)", left), "oven;");
  EXPECT_EQ(ask("in_front_of(object, oven)", left), "fridge;");
  EXPECT_EQ(ask("in_front_of(object, fridge)", left), "");
}

TEST_F(Relations, OnlyWhatIsWithinTheRangeIsOnASide) {
  const Pose2 left{{0.6, 5.3}, 0};
  EXPECT_EQ(ask("behind(object, oven)", left), "");  // the sofa is 5.8 m away
  RelationParams params;
  params.side_range = 6;
  EXPECT_EQ(ask("behind(object, oven)", left, params), "sofa;");
}

TEST_F(Relations, TheRobotsOwnSides) {
  const Pose2 robot{{1.5, 5.5}, 0};
  EXPECT_EQ(ask("in_front_of(object, robot)", robot), "oven;");
  EXPECT_EQ(ask("behind(object, robot)", robot), "fridge;");
  const Pose2 turned{{1.5, 5.5}, M_PI / 2};
  EXPECT_EQ(ask("left_of(object, robot)", turned), "fridge;");
  EXPECT_EQ(ask("right_of(object, robot)", turned), "oven;");
}

TEST_F(Relations, P7_UnknownWords) {
  EXPECT_THROW(ask("near frigde"), LookupError);
  EXPECT_THROW(ask("near(chair, fridge)"), LookupError);
  EXPECT_THROW(ask("near \xff"), LookupError);
}

TEST_F(Relations, WithoutARobotOrWithBadParameters) {
  EXPECT_THROW(ask("left_of fridge"), std::invalid_argument);
  EXPECT_THROW(ask("near robot"), std::invalid_argument);
  RelationParams params;
  params.near = std::nan("");
  EXPECT_THROW(ask("near fridge", {}, params), std::invalid_argument);
  for (double RelationParams::*field :
       {&RelationParams::near, &RelationParams::next_to, &RelationParams::side_range,
        &RelationParams::sector_half_angle_deg, &RelationParams::north_yaw_deg}) {
    RelationParams bad;
    bad.*field = -1e4;
    EXPECT_NE(problemOf(bad).find("must be in"), std::string::npos);
  }
  EXPECT_EQ(problemOf(RelationParams{}), "");
}

TEST(TerseQuestion, Forms) {
  for (const char* text : {"near fridge", " Near  fridge ", "near(fridge)", "near (fridge)",
                           "NEAR(X, fridge)", "near( _ ,fridge)"}) {
    const auto question = terseQuestion(text);
    ASSERT_TRUE(question) << text;
    EXPECT_EQ(question->relation, Relation::kNear);
    EXPECT_EQ(question->place, "fridge") << text;
    EXPECT_EQ(question->what, "");
    EXPECT_FALSE(question->kind);
  }
  EXPECT_EQ(terseQuestion("near(door, fridge)")->kind, TagKind::kDoor);
  EXPECT_EQ(terseQuestion("near(oven, living room)")->what, "oven");
  EXPECT_EQ(terseQuestion("in_front_of living room")->place, "living room");
  EXPECT_TRUE(terseQuestion("left_of Robot")->place_is_robot);
  for (const char* text : {"", " ", "near", "near()", "near(", "near(a", "near(a,)", "nearby x",
                           "what is near", "(", "()"}) {
    EXPECT_FALSE(terseQuestion(text)) << text;
  }
}

TEST(TerseQuestion, EveryRelationHasAName) {
  for (const std::string& name : relationNames()) {
    ASSERT_TRUE(terseQuestion(name + " x"));
    EXPECT_EQ(relationNames().at(static_cast<std::size_t>(terseQuestion(name + " x")->relation)),
              name);
  }
}

}  // namespace
}  // namespace agrid::dialogue
