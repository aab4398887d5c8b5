// SPDX-License-Identifier: BSD-3-Clause
#include "map/file_writer.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <random>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "agrid/map/map_io.h"
#include "map/printable.h"

namespace agrid {
namespace {

std::string reason() { return std::generic_category().message(errno); }

void syncFolderOf(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  const int fd = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return;  // the file is complete; a folder that cannot be opened cannot be synced
  fsync(fd);
  close(fd);
}

}  // namespace

FileWriter::FileWriter(const std::string& path) : path_(path) {
  if (path.find('\0') != std::string::npos) {
    throw FileError(FileErrorCode::kPath, printable(path) + ": the path holds a NUL byte");
  }
  std::random_device random;
  do {  // a name that nobody has and nobody can guess, lest a link of that name be followed
    temporary_ = path + ".tmp-" + std::to_string(random());
    fd_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  } while (fd_ < 0 && (errno == EEXIST || errno == EINTR));
  if (fd_ < 0) {
    throw FileError(FileErrorCode::kPath, printable(path) + ": cannot be written: " + reason());
  }
}

FileWriter::~FileWriter() {
  if (fd_ >= 0) close(fd_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void FileWriter::fail(const char* what) const {
  throw FileError(FileErrorCode::kIo, printable(path_) + ": " + what + ": " + reason());
}

void FileWriter::write(const void* data, std::size_t size) {
  const char* next = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = ::write(fd_, next, size);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot be written");
    next += written;
    size -= static_cast<std::size_t>(written);
  }
}

void FileWriter::commit() {
  if (fsync(fd_) != 0) fail("cannot be synced");
  const int fd = fd_;
  fd_ = -1;
  if (close(fd) != 0) fail("cannot be closed");
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail("cannot be renamed into place");
  temporary_.clear();
  syncFolderOf(path_);
}

}  // namespace agrid
