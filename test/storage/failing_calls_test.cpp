// SPDX-License-Identifier: BSD-3-Clause
// The calls of the C library that a store makes, as functions of the test program, which the
// dynamic linker prefers. What failing calls do to a store is tested in failures_test.cpp.
#include "storage/failing_calls.h"

#include <cerrno>
#include <cstdarg>
#include <cstdlib>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

using agrid::test::WatchedCalls;

struct Watch {
  WatchedCalls::Then then = WatchedCalls::Then::kSucceed;
  int number = 0;
  int error = 0;
  int count = 0;
  bool is_on = false;
  std::vector<std::string> names;
};

Watch watch;

// The tests wait for thousands of syncs: in memory, where there is some, that takes no time.
const bool in_memory = access("/dev/shm", W_OK | X_OK) == 0 && setenv("TMPDIR", "/dev/shm", 1) == 0;

/// Whether this call is to fail; ends the process if it is to end here, after `last`.
template <typename Last>
bool fails(const char* name, Last last) {
  if (!watch.is_on) return false;
  watch.names.emplace_back(name);
  const int number = ++watch.count;
  if (watch.then == WatchedCalls::Then::kSucceed || number < watch.number) return false;
  if (watch.then == WatchedCalls::Then::kFail && number > watch.number) return false;
  if (watch.then == WatchedCalls::Then::kEndProcess) {
    last();
    _exit(0);
  }
  errno = watch.error;
  return true;
}

bool fails(const char* name) {
  return fails(name, [] {});
}

int opened(int folder, const char* path, int flags, mode_t mode) {
  if (fails("open")) return -1;
  return static_cast<int>(syscall(SYS_openat, folder, path, flags, mode));
}

}  // namespace

extern "C" {

int openat(int folder, const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return opened(folder, path, flags, mode);
}

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return opened(AT_FDCWD, path, flags, mode);
}

ssize_t write(int fd, const void* data, size_t size) {
  // half of it arrives, as on a disk that becomes full, or when the process is killed
  const auto half = [&] { return syscall(SYS_write, fd, data, size / 2); };
  if (fails("write", half)) {
    const int error = errno;
    half();
    errno = error;
    return -1;
  }
  return syscall(SYS_write, fd, data, size);
}

ssize_t read(int fd, void* data, size_t size) {
  return fails("read") ? -1 : syscall(SYS_read, fd, data, size);
}

int fsync(int fd) {
  struct stat status {};
  fstat(fd, &status);
  if (fails(S_ISDIR(status.st_mode) ? "fsync directory" : "fsync")) return -1;
  return static_cast<int>(syscall(SYS_fsync, fd));
}

int fdatasync(int fd) {
  return fails("fdatasync") ? -1 : static_cast<int>(syscall(SYS_fdatasync, fd));
}

int close(int fd) {
  const bool failed = fails("close");
  const int error = errno;
  const int result = static_cast<int>(syscall(SYS_close, fd));
  if (failed) errno = error;
  return failed ? -1 : result;
}

int ftruncate(int fd, off_t size) noexcept {
  return fails("ftruncate") ? -1 : static_cast<int>(syscall(SYS_ftruncate, fd, size));
}

int fchmod(int fd, mode_t mode) noexcept {
  return fails("fchmod") ? -1 : static_cast<int>(syscall(SYS_fchmod, fd, mode));
}

int flock(int fd, int operation) noexcept {
  return fails("flock") ? -1 : static_cast<int>(syscall(SYS_flock, fd, operation));
}

int renameat(int from, const char* old_name, int to, const char* name) noexcept {
  if (fails("rename")) return -1;
  return static_cast<int>(syscall(SYS_renameat2, from, old_name, to, name, 0));
}

int linkat(int from, const char* old_name, int to, const char* name, int flags) noexcept {
  if (fails("link")) return -1;
  return static_cast<int>(syscall(SYS_linkat, from, old_name, to, name, flags));
}

int unlinkat(int folder, const char* name, int flags) noexcept {
  if (fails("unlink")) return -1;
  return static_cast<int>(syscall(SYS_unlinkat, folder, name, flags));
}

}  // extern "C"

namespace agrid::test {

WatchedCalls::WatchedCalls(Then then, int number, int error) {
  watch = {then, number, error, 0, true, {}};
}

WatchedCalls::~WatchedCalls() { watch.is_on = false; }

bool WatchedCalls::wasReached() const { return watch.count >= watch.number; }

const std::vector<std::string>& WatchedCalls::names() const { return watch.names; }

TEST(WatchedCalls, AreThoseOfTheWholeProgram) {
  const WatchedCalls watched(WatchedCalls::Then::kFail, 2, EIO);
  EXPECT_EQ(close(-1), -1);
  EXPECT_EQ(errno, EBADF);
  EXPECT_EQ(close(-1), -1);
  EXPECT_EQ(errno, EIO);
  EXPECT_TRUE(watched.wasReached());
  static_cast<void>(in_memory);
}

}  // namespace agrid::test
