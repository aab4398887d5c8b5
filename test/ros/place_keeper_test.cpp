// SPDX-License-Identifier: BSD-3-Clause
#include "ros/place_keeper.h"

#include <atomic>
#include <set>
#include <thread>

#include "place_fixture.h"
#include "ros/request_error.h"

namespace agrid_map_ros {
namespace {

using test::twoRoomsAndACloset;
using test::walledUp;
using Place = test::PlaceFixture;

TEST_F(Place, T15_WithoutAMapNothingCanBeSaid) {
  const auto keeper = this->keeper();
  EXPECT_EQ(keeper->snapshot(), nullptr);
  try {
    keeper->edit(put(kitchen()));
    ADD_FAILURE();
  } catch (const RequestError& error) {
    EXPECT_EQ(error.code(), agrid_map::Status::NO_MAP);
  }
  keeper->adopt(draft(twoRoomsAndACloset()));
  EXPECT_NE(areaAt(*keeper, 2.5, 3.5), "kitchen");
}

TEST_F(Place, WhatIsSaidIsInTheNextSnapshotAndAfterARestart) {
  {
    const auto keeper = this->keeper();
    keeper->adopt(draft(twoRoomsAndACloset()));
    const auto answer = keeper->edit(put(kitchen()));
    EXPECT_EQ(areaAt(*keeper, 2.5, 3.5), "kitchen");
    EXPECT_EQ(answer.snapshot, keeper->snapshot());
    EXPECT_EQ(keeper->snapshot()->stamp.version, 2U);
    EXPECT_EQ(changes_, 2);
  }
  const auto keeper = this->keeper();
  keeper->adopt(draft(twoRoomsAndACloset()));
  EXPECT_EQ(areaAt(*keeper, 2.5, 3.5), "kitchen");
  EXPECT_TRUE(failed_.empty());
}

TEST_F(Place, T5_SayingTheSameAgainChangesNothing) {
  const auto keeper = this->keeper();
  keeper->adopt(draft(twoRoomsAndACloset()));
  const auto first = keeper->edit(put(object("fridge")));
  const SnapshotPtr before = keeper->snapshot();
  const auto again = keeper->edit(put(object("fridge")));
  EXPECT_EQ(again.id, first.id);
  EXPECT_EQ(keeper->snapshot(), before);
}

TEST_F(Place, ARefusedEditChangesNothing) {
  const auto keeper = this->keeper();
  keeper->adopt(draft(twoRoomsAndACloset()));
  const SnapshotPtr before = keeper->snapshot();
  EXPECT_THROW(keeper->edit(put(kitchen(500, 3))), agrid::EditError);
  EXPECT_EQ(keeper->snapshot(), before);
}

TEST_F(Place, NamesStayWithTheirPlacesOnAnotherMap) {
  const auto keeper = this->keeper();
  keeper->adopt(draft(twoRoomsAndACloset()));
  const auto id = keeper->edit(put(kitchen())).id;
  keeper->edit(put(object("fridge")));
  keeper->adopt(draft(walledUp()));
  EXPECT_EQ(areaAt(*keeper, 2.5, 3.5), "kitchen");
  EXPECT_EQ(keeper->snapshot()->map->knowledge.objects.size(), 1U);
  EXPECT_EQ(static_cast<std::uint32_t>(agrid::areaAt(*keeper->snapshot()->map, {2.5, 3.5})->id),
            id);
}

TEST_F(Place, S17_ARestartOnAnotherMapKeepsNamesAndIds) {
  std::uint32_t id = 0;
  {
    const auto keeper = this->keeper();
    keeper->adopt(draft(twoRoomsAndACloset()));
    id = keeper->edit(put(kitchen())).id;
  }
  const auto keeper = this->keeper();
  keeper->adopt(draft(walledUp()));
  const agrid::Area* area = agrid::areaAt(*keeper->snapshot()->map, {2.5, 3.5});
  EXPECT_EQ(area->name, "kitchen");
  EXPECT_EQ(static_cast<std::uint32_t>(area->id), id);
}

TEST_F(Place, M18_TagsWaitForTheirFrameAndAreBackWithIt) {
  const auto keeper = this->keeper();
  keeper->adopt(draft(twoRoomsAndACloset()));
  const auto id = keeper->edit(put(kitchen())).id;
  keeper->adopt(draft(twoRoomsAndACloset(), "other"));
  EXPECT_NE(areaAt(*keeper, 2.5, 3.5), "kitchen");
  ASSERT_EQ(keeper->snapshot()->map->knowledge.pending.size(), 1U);
  EXPECT_EQ(keeper->snapshot()->map->knowledge.pending[0].frame_id, "map");
  keeper->adopt(draft(twoRoomsAndACloset()));
  EXPECT_EQ(areaAt(*keeper, 2.5, 3.5), "kitchen");
  EXPECT_EQ(static_cast<std::uint32_t>(agrid::areaAt(*keeper->snapshot()->map, {2.5, 3.5})->id),
            id);
}

TEST_F(Place, S8_TheSecondOnTheSameFileKeepsNothingAndSaysSo) {
  const auto first = keeper();
  const auto second = keeper();
  EXPECT_EQ(failed_.size(), 1U);
  EXPECT_FALSE(second->storageProblem().empty());
  second->adopt(draft(twoRoomsAndACloset()));
  EXPECT_THROW(second->edit(put(kitchen())), RequestError);
  EXPECT_NE(areaAt(*second, 2.5, 3.5), "kitchen");
}

TEST_F(Place, S2_ReadOnlyRefusesEdits) {
  storage_.read_only = true;
  const auto keeper = this->keeper();
  keeper->adopt(draft(twoRoomsAndACloset()));
  EXPECT_THROW(keeper->edit(put(kitchen())), RequestError);
}

TEST_F(Place, S2_InMemoryOnlyWhereThatIsWanted) {
  storage_.persistent = false;
  {
    const auto keeper = this->keeper();
    keeper->adopt(draft(twoRoomsAndACloset()));
    keeper->edit(put(kitchen()));
    EXPECT_EQ(areaAt(*keeper, 2.5, 3.5), "kitchen");
  }
  const auto keeper = this->keeper();
  keeper->adopt(draft(twoRoomsAndACloset()));
  EXPECT_NE(areaAt(*keeper, 2.5, 3.5), "kitchen");
  EXPECT_FALSE(warned_.empty());
}

TEST_F(Place, StoredMapsAreLoadedInPlaceOfWhatIsKnown) {
  const auto keeper = this->keeper();
  keeper->adopt(draft(twoRoomsAndACloset()));
  keeper->edit(put(kitchen()));
  keeper->saveAs("monday");
  keeper->edit(put(object("fridge")));
  const auto newest = keeper->snapshot()->map->knowledge.next_ids.object;
  keeper->load("monday");
  EXPECT_EQ(areaAt(*keeper, 2.5, 3.5), "kitchen");
  EXPECT_TRUE(keeper->snapshot()->map->knowledge.objects.empty());
  EXPECT_EQ(keeper->snapshot()->map->knowledge.next_ids.object, newest) << "no id is used twice";
  EXPECT_THROW(keeper->load("tuesday"), agrid::StorageError);
  EXPECT_THROW(keeper->saveAs("../monday"), agrid::StorageError);
}

TEST_F(Place, T17_WhatManySayAtOnceIsThereExactlyOnce) {
  constexpr int kClients = 64;
  constexpr int kEach = 8;
  const auto keeper = this->keeper();
  keeper->adopt(draft(twoRoomsAndACloset()));
  std::vector<std::thread> clients;
  std::atomic<int> acknowledged{0};
  for (int c = 0; c < kClients; ++c) {
    clients.emplace_back([&, c] {
      for (int i = 0; i < kEach; ++i) {
        const std::string name = std::to_string(c) + "." + std::to_string(i);
        const auto id = keeper->edit(put(object(name))).id;
        ++acknowledged;
        if (i % 4 != 3) continue;
        keeper->edit([id](const Snapshot& snapshot) {
          return agrid::decide(agrid::RemoveTag{agrid::TagKind::kObject, id}, *snapshot.map);
        });
      }
    });
  }
  for (std::thread& client : clients) client.join();
  EXPECT_EQ(acknowledged, kClients * kEach);
  std::set<std::string> expected;
  for (int c = 0; c < kClients; ++c) {
    for (int i = 0; i < kEach; ++i) {
      if (i % 4 != 3) expected.insert(std::to_string(c) + "." + std::to_string(i));
    }
  }
  const auto namesIn = [](const agrid::Knowledge& known) {
    std::vector<std::string> names;
    for (const agrid::ObjectTag& tag : known.objects) names.push_back(tag.name);
    std::sort(names.begin(), names.end());
    return names;
  };
  const std::vector<std::string> wanted(expected.begin(), expected.end());
  EXPECT_EQ(namesIn(keeper->snapshot()->map->knowledge), wanted);
  keeper->saveAs("copy");
  EXPECT_EQ(namesIn(agrid::readStoredMap(folder_.path() + "/copy.yaml").map.knowledge), wanted);
  EXPECT_EQ(namesIn(agrid::readStoredMap(folder_.path() + "/place.yaml").map.knowledge), wanted);
}

TEST_F(Place, M26_MapsThatTakeTurnsDoNotWearTheDisk) {
  const auto keeper = this->keeper();
  const auto one = draft(twoRoomsAndACloset());
  const auto other = draft(walledUp());
  keeper->adopt(std::make_shared<Snapshot>(*one));
  keeper->edit(put(kitchen()));
  keeper->adopt(std::make_shared<Snapshot>(*other));
  const auto begin = std::chrono::steady_clock::now();
  auto before = agrid::test::contentsOfFolder(folder_.path());
  int writes = 0;
  for (int i = 0; i < 40; ++i) {
    keeper->adopt(std::make_shared<Snapshot>(i % 2 == 0 ? *one : *other));
    auto now = agrid::test::contentsOfFolder(folder_.path());
    writes += now != before;
    before = std::move(now);
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  EXPECT_LE(writes, 2 + elapsed.count() / 10);  // ids are reserved ahead, all else waits
  EXPECT_EQ(areaAt(*keeper, 2.5, 3.5), "kitchen");
}

TEST_F(Place, T20_WhatIsSaidWhileAMapIsBuiltIsOnTheNewMap) {
  const auto keeper = this->keeper();
  keeper->adopt(draft(twoRoomsAndACloset()));
  auto next = draft(walledUp());  // made before it was said
  keeper->edit(put(kitchen()));
  keeper->adopt(next);
  EXPECT_EQ(areaAt(*keeper, 2.5, 3.5), "kitchen");
}

TEST_F(Place, PlansFollowADoorThatIsClosed) {
  const auto keeper = this->keeper();
  keeper->adopt(draft(twoRoomsAndACloset()));
  agrid::PlanRequest request;
  request.start.position_map = {2.5, 3.5};
  request.goal = agrid::PlanPoint{{9.5, 3.5}, {}};
  EXPECT_EQ(keeper->snapshot()->planner->plan(request).status, agrid::PlanStatus::kSuccess);
  const agrid::DoorId door = keeper->snapshot()->map->area_map.doors.at(0).id;
  keeper->edit([door](const Snapshot& snapshot) {
    return agrid::decide(agrid::SetDoor{door, agrid::DoorState::kClosed}, *snapshot.map);
  });
  EXPECT_EQ(keeper->snapshot()->planner->plan(request).status, agrid::PlanStatus::kNoRoute);
}

}  // namespace
}  // namespace agrid_map_ros
