// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/tags/knowledge.h"

#include <random>

#include <gtest/gtest.h>

namespace agrid {
namespace {

AreaTag area(std::uint32_t id, const std::string& name) {
  AreaTag tag;
  tag.id = AreaId{id};
  tag.name = name;
  return tag;
}

DoorTag door(std::uint32_t id) {
  DoorTag tag;
  tag.id = DoorId{id};
  return tag;
}

void expectEqual(const Knowledge& a, const Knowledge& b) {
  EXPECT_EQ(a.areas, b.areas);
  EXPECT_EQ(a.doors, b.doors);
  EXPECT_EQ(a.objects, b.objects);
  ASSERT_EQ(a.pending.size(), b.pending.size());
  for (std::size_t i = 0; i < a.pending.size(); ++i) EXPECT_EQ(a.pending[i].tag, b.pending[i].tag);
  EXPECT_EQ(a.next_ids.area, b.next_ids.area);
  EXPECT_EQ(a.next_ids.door, b.next_ids.door);
  EXPECT_EQ(a.next_ids.object, b.next_ids.object);
}

TEST(Knowledge, ATagReplacesTheOneOfItsKindAndId) {
  Knowledge knowledge;
  apply(PutTag{area(3, "kitchen")}, knowledge);
  apply(PutTag{area(1, "hall")}, knowledge);
  apply(PutTag{door(3)}, knowledge);
  apply(PutTag{area(3, "galley")}, knowledge);
  ASSERT_EQ(knowledge.areas.size(), 2U);
  EXPECT_EQ(knowledge.areas[0].name, "hall");
  EXPECT_EQ(findTag(knowledge, AreaId{3})->name, "galley");
  EXPECT_NE(findTag(knowledge, DoorId{3}), nullptr);
  EXPECT_EQ(findTag(knowledge, AreaId{2}), nullptr);
}

TEST(Knowledge, AnIdIsNeverFreeAgain) {
  Knowledge knowledge;
  apply(PutTag{area(5, "kitchen")}, knowledge);
  apply(DropTag{TagKind::kArea, 5}, knowledge);
  EXPECT_TRUE(knowledge.areas.empty());
  EXPECT_EQ(knowledge.next_ids.area, 6U);
  EXPECT_EQ(knowledge.next_ids.door, 1U);
  apply(ReserveIds{{4, 9, 1}}, knowledge);
  EXPECT_EQ(knowledge.next_ids.area, 6U);
  EXPECT_EQ(knowledge.next_ids.door, 9U);
}

TEST(Knowledge, ATagIsEitherHeldOrPending) {
  Knowledge knowledge;
  apply(PutTag{area(2, "kitchen")}, knowledge);
  apply(DeferTag{{area(2, "kitchen"), "map", "no such place"}}, knowledge);
  EXPECT_TRUE(knowledge.areas.empty());
  ASSERT_EQ(knowledge.pending.size(), 1U);
  apply(PutTag{area(2, "kitchen")}, knowledge);
  EXPECT_EQ(knowledge.areas.size(), 1U);
  EXPECT_TRUE(knowledge.pending.empty());
}

TEST(Knowledge, WhatDiffersIsATagThatSaysSomethingElse) {
  Knowledge knowledge;
  apply(PutTag{area(2, "kitchen")}, knowledge);
  Knowledge other = knowledge;
  EXPECT_TRUE(difference(knowledge, other).empty());
  other.areas[0].outline_map = {{0, 0}, {1, 0}, {0, 1}};
  EXPECT_EQ(difference(knowledge, other).size(), 1U);
  other = knowledge;
  apply(PutTag{door(1)}, other);
  Knowledge moved = other;
  moved.doors[0].absent = true;
  EXPECT_EQ(difference(other, moved).size(), 1U);
}

/// A few random changes of few ids, so that every case is met.
Knowledge changed(Knowledge knowledge, std::mt19937& random) {
  for (int i = 0; i < 6; ++i) {
    const auto id = static_cast<std::uint32_t>(1 + random() % 5);
    const Tag tag = random() % 2 ? Tag(area(id, std::to_string(random() % 3))) : Tag(door(id));
    switch (random() % 4) {
      case 0:
        apply(DropTag{kindOf(tag), id}, knowledge);
        break;
      case 1:
        apply(DeferTag{{tag, "map", {}}}, knowledge);
        break;
      default:
        apply(PutTag{tag}, knowledge);
    }
  }
  return knowledge;
}

TEST(Knowledge, TheDifferenceLeadsFromOneToTheOtherHoweverOftenItIsApplied) {
  std::mt19937 random(1);
  Knowledge before;
  for (int trial = 0; trial < 500; ++trial) {
    const Knowledge after = changed(before, random);
    Knowledge replayed = before;
    const std::vector<Change> changes = difference(before, after);
    for (int times = 0; times < 2; ++times) {
      for (const Change& change : changes) apply(change, replayed);
      expectEqual(replayed, after);
    }
    before = after;
  }
}

}  // namespace
}  // namespace agrid
