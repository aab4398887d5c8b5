// SPDX-License-Identifier: BSD-3-Clause
#include <csignal>
#include <cstring>

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include "agrid/storage.h"
#include "storage/sample_knowledge.h"
#include "support/temporary_folder.h"

namespace agrid {
namespace {

using test::areaNamed;
using test::TemporaryFolder;

/// Appends until the disk takes no more, and a few times after; what was stored is in `map`.
/// @return the number of refusals
int appendUntilRefused(Store& store, StoredMap& map) {
  int refusals = 0;
  for (std::uint32_t id = 1; id < 10000 && refusals < 20; ++id) {
    StoredMap changed = map;
    try {
      store.append(test::putting(areaNamed(id, std::string(100, 'x')), changed.knowledge));
      map = changed;
      if (id % 50 == 0) store.fold(map);
    } catch (const StorageError& error) {
      EXPECT_EQ(error.code(), StorageErrorCode::kIo);
      ++refusals;
    }
  }
  return refusals;
}

void expectStored(const std::string& folder, const StoredMap& map) {
  const StoreContents found = Store(folder, "office").takeContents();
  EXPECT_EQ(found.errors, std::vector<std::string>());
  EXPECT_TRUE(difference(found.map.knowledge, map.knowledge).empty());
  EXPECT_TRUE(difference(map.knowledge, found.map.knowledge).empty());
}

/// A small file system in memory while this is in scope.
class SmallDisk {
 public:
  SmallDisk() : is_mounted_(mount("tmpfs", folder_.path().c_str(), "tmpfs", 0, "size=64k") == 0) {}
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() {
    if (is_mounted_) umount2(folder_.path().c_str(), MNT_DETACH);
  }

  bool isMounted() const { return is_mounted_; }
  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
  bool is_mounted_;
};

TEST(Store, S1_AFullDiskRefusesEditsAndKeepsTheOthers) {
  const SmallDisk disk;
  if (!disk.isMounted()) GTEST_SKIP() << "cannot mount a small disk: " << std::strerror(errno);
  const std::string folder = disk.folder().path();
  StoredMap map;
  disk.folder().write("ballast", std::string(20000, 'x'));
  {
    Store store(folder, "office");
    EXPECT_GT(appendUntilRefused(store, map), 0);
    EXPECT_GT(map.knowledge.areas.size(), 20U);
    std::filesystem::remove(folder + "/ballast");
    store.append(test::putting(areaNamed(20000, "fits again"), map.knowledge));
  }
  expectStored(folder, map);
}

TEST(Store, S1_AFileSizeLimitRefusesEditsAndKeepsTheOthers) {
  const TemporaryFolder folder;
  const auto former_action = std::signal(SIGXFSZ, SIG_IGN);
  rlimit former{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &former), 0);
  StoredMap map;
  {
    Store store(folder.path(), "office");
    const rlimit limit{5000, former.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
    const int refusals = appendUntilRefused(store, map);
    setrlimit(RLIMIT_FSIZE, &former);
    EXPECT_GT(refusals, 0);
    EXPECT_GT(map.knowledge.areas.size(), 10U);
    store.append(test::putting(areaNamed(20000, "fits again"), map.knowledge));
  }
  std::signal(SIGXFSZ, former_action);
  expectStored(folder.path(), map);
}

}  // namespace
}  // namespace agrid
