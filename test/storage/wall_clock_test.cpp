// SPDX-License-Identifier: BSD-3-Clause
// A wall clock that jumps, as that of a robot whose battery was empty.
#include <chrono>
#include <ctime>

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

#include "agrid/storage.h"
#include "storage/sample_knowledge.h"
#include "support/temporary_folder.h"

namespace {

long seconds_off = 0;

}  // namespace

// These stand in front of the C library's.
extern "C" int clock_gettime(clockid_t clock, timespec* now) noexcept {
  const long failed = syscall(SYS_clock_gettime, clock, now);
  if (clock == CLOCK_REALTIME) now->tv_sec += seconds_off;
  return static_cast<int>(failed);
}
extern "C" time_t time(time_t* result) noexcept {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  if (result) *result = now.tv_sec;
  return now.tv_sec;
}
extern "C" int gettimeofday(timeval* result, void*) noexcept {
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  *result = {now.tv_sec, now.tv_nsec / 1000};
  return 0;
}

namespace agrid {
namespace {

constexpr long kYear = 365L * 24 * 3600;

class WallClock : public testing::Test {
 protected:
  ~WallClock() override { seconds_off = 0; }
  const test::TemporaryFolder folder_;
};

TEST_F(WallClock, S13_OrderDoesNotComeFromIt) {
  Knowledge known;
  std::uint32_t id = 0;
  for (const long years : {0, -10, 10, -60, 0}) {
    seconds_off = years * kYear;
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    ASSERT_EQ(std::chrono::duration_cast<std::chrono::hours>(now).count() / 24 / 365,
              (::time(nullptr) / 3600) / 24 / 365);
    Store store(folder_.path(), "office");
    StoredMap map = store.takeContents().map;
    EXPECT_TRUE(difference(map.knowledge, known).empty()) << years;
    store.append(test::putting(test::areaNamed(++id, "room"), known));
    if (id % 2 == 0) store.fold({"0123", "map", known});
    store.append(test::putting(test::areaNamed(1, "renamed " + std::to_string(id)), known));
  }
  const StoreContents found = Store(folder_.path(), "office").takeContents();
  EXPECT_TRUE(found.errors.empty());
  EXPECT_TRUE(difference(found.map.knowledge, known).empty());
}

TEST_F(WallClock, S13_DamagedFilesAreNumberedNotDated) {
  for (const long years : {0, -10, 10}) {
    seconds_off = years * kYear;
    Store(folder_.path(), "office").fold({});
    folder_.write("office.yaml", "damaged at " + std::to_string(years));
    EXPECT_FALSE(Store(folder_.path(), "office").takeContents().errors.empty());
  }
  const auto files = test::contentsOfFolder(folder_.path());
  EXPECT_EQ(files.at("office.yaml.corrupt-1"), "damaged at 0");
  EXPECT_EQ(files.at("office.yaml.corrupt-2"), "damaged at -10");
  EXPECT_EQ(files.at("office.yaml.corrupt-3"), "damaged at 10");
}

}  // namespace
}  // namespace agrid
