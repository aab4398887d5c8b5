// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include <gtest/gtest.h>

#include "agrid/storage.h"
#include "storage/sample_knowledge.h"
#include "storage/stored_place.h"
#include "support/temporary_folder.h"

namespace agrid {
namespace {

namespace fs = std::filesystem;

using test::areaNamed;
using test::codeOf;
using test::contentsOf;
using test::foundIn;
using test::putting;
using test::storedIn;
using test::TemporaryFolder;

TEST(Store, WhatWasAppendedIsThereAfterwardsWithAndWithoutFolding) {
  const TemporaryFolder folder;
  StoredMap map;
  {
    Store store(folder.path(), "office");
    EXPECT_TRUE(store.takeContents().is_new);
    map.frame_id = "map";
    for (std::uint32_t id = 1; id <= 3; ++id) {
      store.append(putting(areaNamed(id, "room"), map.knowledge));
      if (id == 2) store.fold(map);
    }
  }
  const StoreContents found = foundIn(folder.path());
  EXPECT_FALSE(found.is_new);
  EXPECT_TRUE(found.errors.empty());
  EXPECT_TRUE(found.warnings.empty());
  EXPECT_EQ(found.map.frame_id, "map");
  EXPECT_TRUE(difference(found.map.knowledge, map.knowledge).empty());
}

TEST(Store, SeveralEditsAreStoredAtOnceAndEachIsWhole) {
  const TemporaryFolder folder;
  Knowledge known;
  {
    Store store(folder.path(), "office");
    auto both = putting(areaNamed(1, "a"), known);
    both.emplace_back(ReserveIds{{9, 9, 9}});
    agrid::apply(both.back(), known);
    store.append({both, {}, putting(areaNamed(2, "b"), known)});
  }
  EXPECT_TRUE(difference(foundIn(folder.path()).map.knowledge, known).empty());
}

TEST(Store, WhatCouldNotBeReadAgainIsRefused) {
  const TemporaryFolder folder;
  Store store(folder.path(), "office");
  Knowledge known;
  AreaTag area = areaNamed(1, "a");
  area.seed_map.x() = std::numeric_limits<double>::quiet_NaN();
  DoorTag door;
  door.id = DoorId{1};
  door.width = -1;
  ObjectTag object;
  for (const Tag& tag : {Tag(area), Tag(door), Tag(object)}) {
    const std::vector<Change> edit = {Change(std::in_place_type<PutTag>, PutTag{tag})};
    EXPECT_THROW(store.append(edit), std::invalid_argument);
  }
  EXPECT_THROW(store.append(std::vector<Change>{Change(DropTag{TagKind::kDoor, 0})}),
               std::invalid_argument);
  store.append(putting(areaNamed(1, "a"), known));
  EXPECT_TRUE(difference(store.loadFrom("office").map.knowledge, known).empty());
}

TEST(Store, ALongJournalIsDueForFolding) {
  const TemporaryFolder folder;
  Store store(folder.path(), "office");
  StoredMap map;
  EXPECT_FALSE(store.journalIsLong());
  AreaTag area = areaNamed(1, std::string(1 << 20, 'x'));
  store.append(putting(area, map.knowledge));
  EXPECT_TRUE(store.journalIsLong());
  store.fold(map);
  EXPECT_FALSE(store.journalIsLong());
  for (int i = 0; i < 3; ++i) store.fold(map);
  EXPECT_FALSE(fs::exists(folder / "office.journal-1"));
}

TEST(Store, S2_ADirectoryThatIsGoneIsToldWithEveryEdit) {
  const TemporaryFolder folder;
  const std::string place = folder / "store";
  Store store(place, "office");
  Knowledge known;
  store.append(putting(areaNamed(1, "a"), known));
  fs::remove_all(place);
  const auto append = [&] { store.append(putting(areaNamed(2, "b"), known)); };
  EXPECT_EQ(codeOf(append), StorageErrorCode::kIo);
  fs::create_directory(place);
  EXPECT_EQ(codeOf(append), StorageErrorCode::kIo);
  const std::string other_place = folder / "other";
  Store moved(other_place, "office");
  moved.append(putting(areaNamed(1, "a"), known));
  fs::rename(other_place, folder / "elsewhere");
  EXPECT_EQ(codeOf([&] { moved.append(putting(areaNamed(2, "b"), known)); }),
            StorageErrorCode::kIo);
  fs::rename(folder / "elsewhere", other_place);
  EXPECT_NO_THROW(moved.append(putting(areaNamed(2, "b"), known)));
  const StoreOptions no_creation{false, false};
  EXPECT_EQ(codeOf([&] { Store(folder / "none", "office", no_creation); }), StorageErrorCode::kIo);
  EXPECT_EQ(codeOf([&] { Store("/dev/null/store", "office"); }), StorageErrorCode::kPath);
}

TEST(Store, S2_AStoreOpenedForReadingChangesNothing) {
  const TemporaryFolder folder;
  const StoredMap map = storedIn(folder.path());
  folder.write("office.yaml", "damaged");
  const auto before = test::contentsOfFolder(folder.path());
  Store store(folder.path(), "office", {true, true});
  EXPECT_FALSE(store.takeContents().errors.empty());
  EXPECT_EQ(codeOf([&] { store.append(std::vector<Change>{}); }), StorageErrorCode::kReadOnly);
  EXPECT_EQ(codeOf([&] { store.fold(map); }), StorageErrorCode::kReadOnly);
  EXPECT_EQ(codeOf([&] { store.replace(map); }), StorageErrorCode::kReadOnly);
  EXPECT_EQ(test::contentsOfFolder(folder.path()), before);
}

TEST(Store, S7_ANewerVersionIsLeftAlone) {
  const TemporaryFolder folder;
  folder.write("office.yaml", "# x\nformat_version: 2\nwhat: ever\n");
  EXPECT_EQ(codeOf([&] { Store(folder.path(), "office"); }), StorageErrorCode::kVersion);
  const StoredMap map = storedIn(folder.path(), "other");
  const Store store(folder.path(), "other");
  EXPECT_EQ(codeOf([&] { store.saveAs("office", map); }), StorageErrorCode::kVersion);
  EXPECT_EQ(contentsOf(folder / "office.yaml"), "# x\nformat_version: 2\nwhat: ever\n");
}

TEST(Store, S17_TagsOfAnotherMapAreGivenOutWithItsDigest) {
  const TemporaryFolder folder;
  storedIn(folder.path());
  const StoreContents found = foundIn(folder.path());
  EXPECT_EQ(found.map.map_id, "0123");
  EXPECT_EQ(found.map.knowledge.areas.size(), 1U);
}

TEST(Store, AnotherNameTakesAndGivesWhatIsStored) {
  const TemporaryFolder folder;
  StoredMap map = storedIn(folder.path());
  Store store(folder.path(), "office");
  store.saveAs("copy", map);
  storedIn(folder.path(), "copy");  // edits after it
  store.saveAs("copy", map);        // in place of them
  const StoreContents copy = store.loadFrom("copy");
  EXPECT_TRUE(copy.errors.empty());
  EXPECT_TRUE(difference(copy.map.knowledge, map.knowledge).empty());
  EXPECT_EQ(copy.map.map_id, "0123");
  const Store user(folder.path(), "copy");
  EXPECT_EQ(codeOf([&] { store.saveAs("copy", map); }), StorageErrorCode::kLocked);
  EXPECT_NO_THROW(store.loadFrom("copy"));
}

TEST(Store, AReplacedMapDoesNotComeBack) {
  const TemporaryFolder folder;
  StoredMap other;
  {
    storedIn(folder.path());
    Store store(folder.path(), "office");
    store.append(putting(areaNamed(5, "of the former map"), other.knowledge));
    other.knowledge = {};
    agrid::apply(PutTag{areaNamed(9, "of the new one")}, other.knowledge);
    store.replace(other);
    store.append(putting(areaNamed(10, "later"), other.knowledge));
  }
  folder.write("office.yaml", "damaged");
  const StoreContents found = foundIn(folder.path());
  EXPECT_EQ(found.errors.size(), 1U);
  EXPECT_TRUE(difference(found.map.knowledge, other.knowledge).empty());
}

}  // namespace
}  // namespace agrid
