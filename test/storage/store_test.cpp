// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "agrid/storage.h"
#include "storage/sample_knowledge.h"
#include "support/temporary_folder.h"

namespace agrid {
namespace {

namespace fs = std::filesystem;

using test::areaNamed;
using test::contentsOf;
using test::putting;
using test::TemporaryFolder;

template <typename Call>
StorageErrorCode codeOf(Call call) {
  try {
    call();
  } catch (const StorageError& error) {
    return error.code();
  }
  throw std::logic_error("it did not fail");
}

/// Opens a store in a folder, puts an area and folds.
StoredMap storedIn(const std::string& folder, const std::string& name = "office") {
  Store store(folder, name);
  StoredMap map = store.takeContents().map;
  map.frame_id = "map";
  map.map_id = "0123";
  store.append(putting(areaNamed(1, "kitchen"), map.knowledge));
  store.fold(map);
  return map;
}

StoreContents foundIn(const std::string& folder, const std::string& name = "office") {
  return Store(folder, name).takeContents();
}

mode_t modeOf(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 ? status.st_mode & 07777U : 0;
}

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

TEST(Store, S8_OneProcessAtATimeAndAKilledOneIsOutOfTheWay) {
  const TemporaryFolder folder;
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    const Store store(folder.path(), "office");
    if (write(ready[1], "x", 1) != 1) _exit(1);
    pause();
  }
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  EXPECT_EQ(codeOf([&] { Store(folder.path(), "office"); }), StorageErrorCode::kLocked);
  EXPECT_NO_THROW(Store(folder.path(), "office", {true, true}));
  EXPECT_NO_THROW(Store(folder.path(), "other"));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_NO_THROW(Store(folder.path(), "office"));
  close(ready[0]);
  close(ready[1]);
}

TEST(Store, S9_SymbolicLinksAreRefused) {
  const TemporaryFolder folder;
  const std::string victim = folder.write("victim", "precious");
  for (const std::string file : {"a.yaml", "b.lock", "c.yaml.bak", "d.journal-1"}) {
    fs::create_symlink(victim, folder / file);
    EXPECT_EQ(codeOf([&] { Store(folder.path(), file.substr(0, 1)); }), StorageErrorCode::kPath);
  }
  fs::create_directory(folder / "e.yaml");
  EXPECT_EQ(codeOf([&] { Store(folder.path(), "e"); }), StorageErrorCode::kPath);
  ASSERT_EQ(mkfifo((folder / "f.yaml").c_str(), 0600), 0);
  EXPECT_EQ(codeOf([&] { Store(folder.path(), "f"); }), StorageErrorCode::kPath);
  EXPECT_EQ(contentsOf(victim), "precious");
}

TEST(Store, S10_FilesAreForTheirOwnerOnlyWhateverTheUmaskIs) {
  for (const mode_t mask : {0, 0777}) {
    const TemporaryFolder folder;
    const mode_t former = umask(mask);
    if (mask == 0) {
      storedIn(folder / "deep/er");
      EXPECT_EQ(modeOf(folder / "deep"), 0700U);
      EXPECT_EQ(modeOf(folder / "deep/er"), 0700U);
      EXPECT_EQ(modeOf(folder / "deep/er/office.yaml"), 0600U);
      EXPECT_EQ(modeOf(folder / "deep/er/office.journal-1"), 0600U);
      EXPECT_EQ(modeOf(folder / "deep/er/office.lock"), 0600U);
    } else {
      storedIn(folder.path());
      EXPECT_EQ(modeOf(folder / "office.yaml"), 0600U);
    }
    umask(former);
  }
  const TemporaryFolder open_to_all;
  ASSERT_EQ(chmod(open_to_all.path().c_str(), 0777), 0);
  const auto warnings = foundIn(open_to_all.path()).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("everybody may write"), std::string::npos);
}

TEST(Store, S11_OnlyPlainNamesAreTaken) {
  for (const char* name : {"a", "A-1_b.c", "0", "_", "-"}) EXPECT_EQ(checkedName(name), name);
  EXPECT_NO_THROW(checkedName(std::string(64, 'x')));
  for (const std::string& name :
       {std::string(), std::string(65, 'x'), std::string("."), std::string(".."), std::string(".a"),
        std::string("a/b"), std::string("../a"), std::string("/etc/passwd"), std::string("a b"),
        std::string("a\0b", 3), std::string("a\n"), std::string("caf\u00e9"), std::string(";id;"),
        std::string("~"), std::string("$HOME"), std::string("*")}) {
    EXPECT_EQ(codeOf([&] { checkedName(name); }), StorageErrorCode::kPath);
  }
  const TemporaryFolder folder;
  const StoredMap map = storedIn(folder.path());
  const Store store(folder.path(), "office");
  EXPECT_EQ(codeOf([&] { store.saveAs("../x", map); }), StorageErrorCode::kPath);
  EXPECT_EQ(codeOf([&] { store.loadFrom("../x"); }), StorageErrorCode::kPath);
  EXPECT_EQ(codeOf([&] { store.loadFrom("none"); }), StorageErrorCode::kPath);
  EXPECT_FALSE(fs::exists(folder / "none.lock"));
}

TEST(Store, S14_OnlyItsOwnTemporaryFilesAreRemoved) {
  const TemporaryFolder folder;
  folder.write(".office.tmp-0123456789abcdef", "left by a killed process");
  folder.write(".office.tmp-0123456789abcdeX", "not ours");
  folder.write(".other.tmp-0123456789abcdef", "of another map");
  folder.write("office.tmp-0123456789abcdef", "a person's");
  foundIn(folder.path());
  EXPECT_FALSE(fs::exists(folder / ".office.tmp-0123456789abcdef"));
  EXPECT_TRUE(fs::exists(folder / ".office.tmp-0123456789abcdeX"));
  EXPECT_TRUE(fs::exists(folder / ".other.tmp-0123456789abcdef"));
  EXPECT_TRUE(fs::exists(folder / "office.tmp-0123456789abcdef"));
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
