// SPDX-License-Identifier: BSD-3-Clause
#include "map/file_reader.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "map/printable.h"

namespace agrid {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refusePath(const std::string& name, const std::string& what) {
  throw FileError(FileErrorCode::kPath, name + ": " + what);
}

std::string reason(int error) { return std::generic_category().message(error); }

bool isUnder(const fs::path& path, const fs::path& folder) {
  const auto end = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first;
  return end == folder.end();
}

// A path outside is refused before it is looked at, lest the answer tell what exists there.
std::string resolvedUnder(const std::string& map_dir, const std::string& path,
                          const std::string& name) {
  std::error_code error;
  const fs::path folder = fs::canonical(map_dir, error);
  if (error) refusePath(printable(map_dir), "map_dir cannot be used: " + error.message());
  const fs::path resolved = fs::weakly_canonical(path, error);
  if (error || !isUnder(resolved, folder)) {
    refusePath(name, "not under map_dir " + printable(folder.string()));
  }
  return resolved.string();
}

void checkName(const std::string& path, const std::string& name) {
  if (path.empty()) refusePath("''", "the path is empty");
  if (path.size() > 4096) refusePath(name.substr(0, 64) + "...", "the path is too long");
  for (const char c : path) {
    if (c == '\0' || c == '\n' || c == '\r') refusePath(name, "the path holds a control character");
  }
}

int openedRegular(const std::string& path, int flags, const std::string& name) {
  struct stat status {};
  // Looked at before it is opened, since opening a device can set it going.
  if (stat(path.c_str(), &status) != 0) refusePath(name, reason(errno));
  if (!S_ISREG(status.st_mode)) refusePath(name, "not a regular file");
  int fd = -1;
  do {
    fd = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC | flags);
  } while (fd < 0 && errno == EINTR);
  if (fd < 0) refusePath(name, reason(errno));
  return fd;
}

}  // namespace

FileReader::FileReader(const std::string& path, const std::string& map_dir)
    : name_(printable(path)) {
  checkName(path, name_);
  fd_ = map_dir.empty() ? openedRegular(path, 0, name_)
                        : openedRegular(resolvedUnder(map_dir, path, name_), O_NOFOLLOW, name_);
  struct stat status {};
  if (fstat(fd_, &status) != 0 || !S_ISREG(status.st_mode)) {
    close(fd_);
    refusePath(name_, "not a regular file");
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
}

FileReader::~FileReader() { close(fd_); }

void FileReader::fail(FileErrorCode code, const std::string& what) const {
  throw FileError(code, name_ + ": " + what);
}

std::size_t FileReader::readSome(std::uint8_t* bytes, std::size_t size) {
  for (;;) {
    const ssize_t count = ::read(fd_, bytes, size);
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR) fail(FileErrorCode::kIo, "cannot be read: " + reason(errno));
  }
}

bool FileReader::fill() {
  next_ = 0;
  end_ = readSome(buffer_.data(), buffer_.size());
  return end_ > 0;
}

std::string FileReader::start(std::size_t size) {
  peek();
  return {buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(std::min(size, end_))};
}

std::size_t FileReader::read(std::uint8_t* bytes, std::size_t size) {
  std::size_t done = std::min(size, end_ - next_);
  std::memcpy(bytes, buffer_.data() + next_, done);
  next_ += done;
  while (done < size) {
    const std::size_t count = readSome(bytes + done, size - done);
    if (count == 0) break;
    done += count;
  }
  offset_ += done;
  return done;
}

void FileReader::skip(std::uint64_t count) {
  while (count > 0 && peek()) {
    const std::size_t step = std::min<std::uint64_t>(count, end_ - next_);
    next_ += step;
    offset_ += step;
    count -= step;
  }
}

}  // namespace agrid
