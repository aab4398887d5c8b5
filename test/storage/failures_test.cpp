// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <atomic>
#include <cerrno>
#include <functional>
#include <memory>
#include <optional>

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "agrid/storage.h"
#include "storage/failing_calls.h"
#include "storage/sample_knowledge.h"
#include "support/temporary_folder.h"

namespace agrid {
namespace {

using test::areaNamed;
using test::TemporaryFolder;
using test::WatchedCalls;
using Then = WatchedCalls::Then;

constexpr int kMostCalls = 500;

/// A store with a snapshot, a backup and edits that are only in the journal.
StoredMap preparedIn(const TemporaryFolder& folder) {
  Store store(folder.path(), "office");
  StoredMap map{"a map", "map", {}};
  for (std::uint32_t id = 1; id <= 3; ++id) {
    store.append(test::putting(areaNamed(id, "before"), map.knowledge));
    if (id < 3) store.fold(map);
  }
  return map;
}

/// Opens a store and does all that can be done with it. Each step whose call returns is told to
/// `stored` with what is known then; a step that throws is given up.
/// @return how many steps threw
int doEverything(const TemporaryFolder& folder, StoredMap map,
                 const std::function<void(const StoredMap&)>& stored) {
  int failures = 0;
  std::unique_ptr<Store> store;
  const auto attempt = [&](const std::function<void()>& step) {
    try {
      step();
    } catch (const StorageError& error) {
      ++failures;
      EXPECT_NE(std::string(error.what()).find(folder.path()), std::string::npos) << error.what();
    }
  };
  const auto put = [&](std::uint32_t id) {
    attempt([&] {
      StoredMap changed = map;
      store->append(test::putting(areaNamed(id, "put"), changed.knowledge));
      stored(map = changed);
    });
  };
  attempt([&] { store = std::make_unique<Store>(folder.path(), "office"); });
  if (!store) return failures;
  EXPECT_TRUE(difference(store->takeContents().map.knowledge, map.knowledge).empty());
  for (std::uint32_t id = 10; id < 13; ++id) put(id);
  attempt([&] { store->fold(map); });
  for (std::uint32_t id = 20; id < 22; ++id) put(id);
  attempt([&] { store->saveAs("other", map); });
  attempt([&] { store->loadFrom("office"); });
  attempt([&] { store->fold(map); });
  put(30);
  return failures;
}

void expectStored(const TemporaryFolder& folder, const StoredMap& map, const std::string& when) {
  Store store(folder.path(), "office");
  const StoreContents found = store.takeContents();
  EXPECT_EQ(found.errors, std::vector<std::string>()) << when;
  EXPECT_EQ(difference(found.map.knowledge, map.knowledge).size(), 0U) << when;
  EXPECT_EQ(difference(map.knowledge, found.map.knowledge).size(), 0U) << when;
  for (const auto& [name, text] : test::contentsOfFolder(folder.path())) {
    EXPECT_EQ(name.find("tmp-"), std::string::npos) << name << " stayed, " << when;
  }
}

void failEachCall(int error) {
  int reported = 0;
  int number = 1;
  for (; number < kMostCalls; ++number) {
    const TemporaryFolder folder;
    StoredMap map = preparedIn(folder);
    bool was_reached = false;
    std::string when;
    {
      const WatchedCalls watched(Then::kFail, number, error);
      const int failures =
          doEverything(folder, map, [&map](const StoredMap& stored) { map = stored; });
      was_reached = watched.wasReached();
      reported += failures > 0 ? 1 : 0;
      if (was_reached) {
        when = "call " + std::to_string(number) + ", " +
               watched.names()[static_cast<std::size_t>(number) - 1];
      }
    }
    expectStored(folder, map, when);
    if (!was_reached || testing::Test::HasFailure()) break;
  }
  EXPECT_GT(number, 50);
  EXPECT_LT(number, kMostCalls);
  testing::Test::RecordProperty("calls_failed_error_" + std::to_string(error), number - 1);
  testing::Test::RecordProperty("reported_error_" + std::to_string(error), reported);
  EXPECT_GT(reported, number / 2);  // the others are those that nothing depends on
}

TEST(Store, S1_NothingIsLostWhicheverCallFails) {
  failEachCall(EIO);
  failEachCall(ENOSPC);
}

TEST(Store, S12_ALinkThatTheFileSystemDoesNotKnowIsReplacedByARename) { failEachCall(EPERM); }

// As S1, but the store object lives on: what was refused must not come back, and the first call
// after the disk is well again must succeed.
void goOnOnceTheDiskIsWell(const std::function<void(Store&, StoredMap&)>& go_on) {
  for (int number = 1; number < kMostCalls; ++number) {
    const TemporaryFolder folder;
    StoredMap map = preparedIn(folder);
    std::optional<Store> store(std::in_place, folder.path(), "office");
    bool was_reached = false;
    const auto put = [&](std::uint32_t id) {
      StoredMap changed = map;
      store->append(test::putting(areaNamed(id, "put"), changed.knowledge));
      map = changed;
    };
    {
      const WatchedCalls watched(Then::kFailOn, number, ENOSPC);
      for (std::uint32_t id = 10; id < 16; ++id) {
        try {
          if (id == 12 || id == 14) store->fold(map);
          put(id);
        } catch (const StorageError& error) {
          EXPECT_EQ(error.code(), StorageErrorCode::kIo);
        }
      }
      was_reached = watched.wasReached();
    }
    go_on(*store, map);
    store.reset();
    expectStored(folder, map, "calls from " + std::to_string(number));
    if (!was_reached || testing::Test::HasFailure()) break;
  }
}

TEST(Store, S1_AStoreGoesOnOnceTheDiskIsWell) {
  goOnOnceTheDiskIsWell([](Store& store, StoredMap& map) {
    store.append(test::putting(areaNamed(20, "put"), map.knowledge));
  });
  goOnOnceTheDiskIsWell([](Store& store, StoredMap& map) { store.fold(map); });
}

// After it failed, the former map goes on, after a fold if need be, and nothing of the other is
// left.
TEST(Store, S1_AReplacementHappensOrNot) {
  int refused_edits = 0;
  for (int number = 1; number < kMostCalls; ++number) {
    const TemporaryFolder folder;
    StoredMap map = preparedIn(folder);
    StoredMap other{"another map", "map", {}};
    agrid::apply(PutTag{areaNamed(40, "of the other")}, other.knowledge);
    bool was_reached = false;
    {
      Store store(folder.path(), "office");
      try {
        const WatchedCalls watched(Then::kFail, number, EIO);
        store.replace(other);
        was_reached = watched.wasReached();
        map = other;
      } catch (const StorageError&) {
        was_reached = true;
      }
      StoredMap changed = map;
      const auto edit = test::putting(areaNamed(41, "later"), changed.knowledge);
      try {
        store.append(edit);
      } catch (const StorageError&) {
        ++refused_edits;
        store.fold(map);
        store.append(edit);
      }
      map = changed;
    }
    Store store(folder.path(), "office");
    const StoreContents found = store.takeContents();
    EXPECT_TRUE(difference(found.map.knowledge, map.knowledge).empty()) << number;
    if (!was_reached || HasFailure()) break;
  }
  EXPECT_GT(refused_edits, 0);
  RecordProperty("edits_refused_until_a_fold", refused_edits);
}

TEST(Store, S5_AFileWhoseSyncFailedIsNotSyncedAgain) {
  const TemporaryFolder folder;
  StoredMap map = preparedIn(folder);
  Store store(folder.path(), "office");
  const auto calls_of = [&](Then then, int number) {
    const WatchedCalls watched(then, number, EIO);
    try {
      store.append(test::putting(areaNamed(9, "room"), map.knowledge));
    } catch (const StorageError&) {
      EXPECT_EQ(then, Then::kFail);
    }
    return watched.names();
  };
  calls_of(Then::kSucceed, 0);
  const auto before = calls_of(Then::kSucceed, 0);
  EXPECT_EQ(before, (std::vector<std::string>{"write", "fdatasync"}));
  const auto failed = calls_of(Then::kFail, 2);
  EXPECT_EQ(failed, (std::vector<std::string>{"write", "fdatasync", "ftruncate", "close"}));
  const auto after = calls_of(Then::kSucceed, 0);
  ASSERT_FALSE(after.empty());
  EXPECT_EQ(after.front(), "open");  // of a new journal
  EXPECT_EQ(std::count(after.begin(), after.end(), "fsync directory"), 1);
}

TEST(Store, S4_ASnapshotIsSyncedBeforeItGetsItsNameAndTheDirectoryAfterwards) {
  const TemporaryFolder folder;
  const StoredMap map = preparedIn(folder);
  Store store(folder.path(), "office");
  const WatchedCalls watched(Then::kSucceed);
  store.fold(map);
  std::vector<std::string> calls;
  for (const std::string& name : watched.names()) {
    if (name != "open" && name != "fchmod" && name != "unlink" && name != "read") {
      calls.push_back(name);
    }
  }
  EXPECT_EQ(calls, (std::vector<std::string>{"write", "fsync", "close", "link", "rename", "rename",
                                             "fsync directory", "close"}));
}

TEST(Store, S3_WhereverTheProcessEndsAllThatWasAcknowledgedIsThere) {
  auto* acknowledged = static_cast<std::atomic<int>*>(
      mmap(nullptr, sizeof(int), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  ASSERT_NE(acknowledged, MAP_FAILED);
  const TemporaryFolder unharmed;
  std::vector<StoredMap> steps{preparedIn(unharmed)};
  doEverything(unharmed, StoredMap(steps.front()),
               [&](const StoredMap& stored) { steps.push_back(stored); });
  bool was_reached = true;
  int number = 1;
  for (; was_reached && number < kMostCalls && !HasFailure(); ++number) {
    const TemporaryFolder folder;
    const StoredMap before = preparedIn(folder);
    *acknowledged = 0;
    const pid_t child = fork();
    if (child == 0) {
      const WatchedCalls watched(Then::kEndProcess, number);
      doEverything(folder, before, [&](const StoredMap&) { ++*acknowledged; });
      _exit(1);  // all calls were made
    }
    int status = 0;
    waitpid(child, &status, 0);
    was_reached = WEXITSTATUS(status) == 0;
    Store store(folder.path(), "office");
    const StoreContents found = store.takeContents();
    EXPECT_EQ(found.errors, std::vector<std::string>()) << number;
    const auto is_found = [&](int step) {
      return step < static_cast<int>(steps.size()) &&
             difference(found.map.knowledge, steps[static_cast<std::size_t>(step)].knowledge)
                 .empty();
    };
    EXPECT_TRUE(is_found(*acknowledged) || is_found(*acknowledged + 1)) << "before call " << number;
  }
  EXPECT_GT(number, 50);
  RecordProperty("ends", number - 2);
  munmap(acknowledged, sizeof(int));
}

}  // namespace
}  // namespace agrid
