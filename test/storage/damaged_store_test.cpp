// SPDX-License-Identifier: BSD-3-Clause
#include <random>

#include <gtest/gtest.h>

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

/// A snapshot with areas 1 and 2, a backup with area 1, and areas 3 to 5 in the newest journal.
class DamagedStore : public testing::Test {
 protected:
  DamagedStore() {
    Store store(folder_.path(), "office");
    for (std::uint32_t id = 1; id <= 5; ++id) {
      store.append(putting(areaNamed(id, "room"), map_.knowledge));
      if (id < 3) store.fold(map_);
    }
  }

  std::string path(const std::string& ending) const { return folder_ / ("office." + ending); }

  StoreContents found() const { return Store(folder_.path(), "office").takeContents(); }

  void expectComplete(const StoreContents& found) const {
    EXPECT_TRUE(difference(found.map.knowledge, map_.knowledge).empty());
  }

  void damage(const std::string& ending, const std::string& text) const {
    folder_.write("office." + ending, text);
  }

  TemporaryFolder folder_;
  StoredMap map_;
};

TEST_F(DamagedStore, S6_ADamagedSnapshotIsKeptAndNothingIsLost) {
  std::mt19937 random(4);
  std::string noise(3000, ' ');
  for (char& c : noise) c = static_cast<char>(random());
  const std::string good = contentsOf(path("yaml"));
  std::string flipped = good;
  flipped[good.find("room")] ^= 2;
  std::string zeroed = good;
  zeroed.replace(good.size() / 2, 64, std::string(64, '\0'));
  int number = 0;
  for (const std::string& bad : {std::string(), good.substr(0, good.size() / 2), flipped, zeroed,
                                 noise, std::string("[1")}) {
    damage("yaml", bad);
    const StoreContents found = this->found();
    ASSERT_EQ(found.errors.size(), 1U) << bad;
    const std::string kept = "yaml.corrupt-" + std::to_string(++number);
    EXPECT_NE(found.errors[0].find(kept), std::string::npos) << found.errors[0];
    EXPECT_EQ(contentsOf(path(kept)), bad);
    expectComplete(found);  // of backup and both journals
  }
}

TEST_F(DamagedStore, S6_AFoldAfterwardsMakesItWholeAndKeepsTheBackup) {
  damage("yaml", "damaged");
  const std::string backup = contentsOf(path("yaml.bak"));
  {
    Store store(folder_.path(), "office");
    store.fold(store.takeContents().map);
  }
  EXPECT_EQ(contentsOf(path("yaml.bak")), backup);
  const StoreContents again = found();
  EXPECT_TRUE(again.errors.empty());
  expectComplete(again);
}

TEST_F(DamagedStore, S6_WithoutABackupWhatTheJournalsSayIsLeftAndLoud) {
  damage("yaml", "damaged");
  damage("yaml.bak", "damaged too");
  fs::remove(path("journal-2"));
  const StoreContents found = this->found();
  EXPECT_FALSE(found.is_new);
  EXPECT_EQ(found.errors.size(), 4U);
  EXPECT_TRUE(fs::exists(path("yaml.corrupt-1")));
  EXPECT_TRUE(fs::exists(path("yaml.bak.corrupt-1")));
  EXPECT_NE(findTag(found.map.knowledge, AreaId{5}), nullptr);
}

TEST_F(DamagedStore, S6_OfAJournalWithADamagedLineTheOthersCount) {
  std::string journal = contentsOf(path("journal-3"));
  const std::size_t line = journal.find('\n', journal.find('\n') + 1) + 1;  // area 4
  journal[line + 30] ^= 1;
  damage("journal-3", journal);
  {
    Store store(folder_.path(), "office");
    const StoreContents found = store.takeContents();
    ASSERT_EQ(found.errors.size(), 2U);
    EXPECT_NE(found.errors[0].find("office.journal-3:3: damaged"), std::string::npos);
    EXPECT_NE(findTag(found.map.knowledge, AreaId{3}), nullptr);
    EXPECT_EQ(findTag(found.map.knowledge, AreaId{4}), nullptr);
    EXPECT_NE(findTag(found.map.knowledge, AreaId{5}), nullptr);
    for (int i = 0; i < 2; ++i) store.fold(found.map);
  }
  EXPECT_EQ(contentsOf(path("journal-3.corrupt-1")), journal);
  EXPECT_TRUE(found().errors.empty());
}

TEST_F(DamagedStore, S3_ATornTailIsDroppedWhereverItEnds) {
  const std::string journal = contentsOf(path("journal-3"));
  for (std::size_t size = 0; size <= journal.size(); ++size) {
    for (const std::size_t zeros : {0, 50}) {
      damage("journal-3", journal.substr(0, size) + std::string(zeros, '\0'));
      Store store(folder_.path(), "office");
      const StoreContents found = store.takeContents();
      EXPECT_TRUE(found.errors.empty()) << size;
      const auto is_whole = [&](std::size_t bytes) { return journal[bytes] == '\n' ? 1U : 0U; };
      std::size_t lines = 0;
      for (std::size_t i = 0; i < size; ++i) lines += is_whole(i);
      if (zeros == 0 && size < journal.size()) lines += is_whole(size);  // only its end is missing
      EXPECT_EQ(found.map.knowledge.areas.size(), 2 + std::max(lines, std::size_t{1}) - 1) << size;
    }
  }
}

TEST_F(DamagedStore, EditsAfterATornTailFollowWhatWasReadNotTheTail) {
  const std::string journal = contentsOf(path("journal-3"));
  damage("journal-3", journal.substr(0, journal.find("id: 4")));  // and area 5 is missing
  StoredMap map;
  {
    Store store(folder_.path(), "office");
    map = store.takeContents().map;
    EXPECT_EQ(map.knowledge.areas.size(), 3U);
    store.append(putting(areaNamed(6, "other"), map.knowledge));
  }
  damage("journal-3", journal);  // as if the tail came back
  EXPECT_TRUE(difference(found().map.knowledge, map.knowledge).empty());
}

TEST_F(DamagedStore, AStaleJournalIsNotAppliedToANewerSnapshot) {
  const std::string journal = contentsOf(path("journal-3"));
  {
    Store store(folder_.path(), "office");
    StoredMap map = store.takeContents().map;
    map.knowledge.areas.clear();
    std::vector<Change> edit;
    for (std::uint32_t id = 1; id <= 5; ++id) edit.emplace_back(DropTag{TagKind::kArea, id});
    store.append(edit);
    for (int i = 0; i < 3; ++i) store.fold(map);
  }
  damage("journal-3", journal);
  EXPECT_TRUE(found().map.knowledge.areas.empty());
}

TEST_F(DamagedStore, JournalsOfAnotherSnapshotAreSetAsideNotAppliedOrLost) {
  const std::string journal = contentsOf(path("journal-3"));
  damage("yaml", "format_version: 1\nareas: [{seed: [1, 2], name: mine}]\nend_of_file: true\n");
  const StoreContents found = this->found();
  EXPECT_EQ(found.map.knowledge.areas.size(), 1U);
  EXPECT_EQ(found.errors.size(), 2U);  // one for each
  EXPECT_EQ(contentsOf(path("journal-3.conflict-1")), journal);
  EXPECT_TRUE(this->found().errors.empty());
}

TEST_F(DamagedStore, S16_WhatAPersonChangesWhileNothingRunsIsTakenWithWhatTheJournalSays) {
  std::string text = contentsOf(path("yaml"));
  text.replace(text.find("\"room\""), 6, "kitchen");
  damage("yaml", text);
  const StoreContents found = this->found();
  EXPECT_TRUE(found.errors.empty());
  ASSERT_EQ(found.warnings.size(), 1U);
  EXPECT_NE(found.warnings[0].find("changed by hand"), std::string::npos);
  EXPECT_EQ(findTag(found.map.knowledge, AreaId{1})->name, "kitchen");
  EXPECT_EQ(found.map.knowledge.areas.size(), 5U);
}

TEST_F(DamagedStore, S16_WhatAPersonChangesMeanwhileIsNotOverwritten) {
  std::string text = contentsOf(path("yaml"));
  text.replace(text.find("\"room\""), 6, "\"kitchen\"");
  {
    Store store(folder_.path(), "office");
    StoredMap map = store.takeContents().map;
    damage("yaml", text);
    for (int i = 0; i < 2; ++i) {
      try {
        store.fold(map);
        FAIL();
      } catch (const StorageError& error) {
        EXPECT_EQ(error.code(), StorageErrorCode::kConflict);
      }
      store.append(putting(areaNamed(6U + static_cast<std::uint32_t>(i), "x"), map.knowledge));
    }
    EXPECT_EQ(contentsOf(path("yaml")), text);
    EXPECT_NE(contentsOf(path("yaml.conflict")).find("{id: 5"), std::string::npos);
  }
  const StoreContents found = this->found();
  EXPECT_TRUE(found.errors.empty());
  EXPECT_EQ(findTag(found.map.knowledge, AreaId{1})->name, "kitchen");
  EXPECT_EQ(found.map.knowledge.areas.size(), 7U);
}

TEST_F(DamagedStore, S16_AFileThatWasOnlyTouchedIsNotChanged) {
  Store store(folder_.path(), "office");
  const StoredMap map = store.takeContents().map;
  const std::string text = contentsOf(path("yaml"));
  fs::remove(path("yaml"));
  damage("yaml", text);
  EXPECT_NO_THROW(store.fold(map));
}

TEST_F(DamagedStore, ARemovedJournalIsMadeUpForByFolding) {
  Store store(folder_.path(), "office");
  StoredMap map = store.takeContents().map;
  store.append(putting(areaNamed(6, "x"), map.knowledge));
  fs::remove(path("journal-4"));
  store.append(putting(areaNamed(7, "y"), map.knowledge));
  EXPECT_TRUE(store.journalIsLong());
  store.fold(map);
  EXPECT_FALSE(store.journalIsLong());
  EXPECT_TRUE(difference(store.loadFrom("office").map.knowledge, map.knowledge).empty());
}

TEST_F(DamagedStore, ToolsReadAnyFileAndChangeNothing) {
  const auto before = test::contentsOfFolder(folder_.path());
  expectComplete(readStoredMap(path("yaml")));
  EXPECT_EQ(readStoredMap(path("yaml.bak")).map.knowledge.areas.size(), 1U);
  EXPECT_EQ(test::contentsOfFolder(folder_.path()), before);
  damage("yaml", "damaged");
  fs::remove(path("yaml.bak"));
  for (const char* ending : {"yaml", "nothing"}) {
    EXPECT_THROW(readStoredMap(path(ending)), StorageError);
  }
}

}  // namespace
}  // namespace agrid
