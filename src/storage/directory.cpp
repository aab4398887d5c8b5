// SPDX-License-Identifier: BSD-3-Clause
#include "storage/directory.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <random>
#include <system_error>
#include <tuple>

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include "agrid/storage.h"
#include "map/printable.h"
#include "storage/checksum.h"

namespace agrid {
namespace {

constexpr mode_t kOwnerOnly = S_IRUSR | S_IWUSR;
constexpr std::int64_t kMaxFileSize = 512LL << 20;
constexpr const char* kTemporary = "tmp-";

FileIdentity identityFrom(const struct stat& status) {
  return {status.st_dev, status.st_ino, status.st_size, status.st_mtim.tv_sec,
          status.st_mtim.tv_nsec};
}

std::string reasonOf(int error) { return std::generic_category().message(error); }

StorageErrorCode codeOf(int error) {
  const bool is_name = error == ELOOP || error == ENOTDIR || error == ENAMETOOLONG ||
                       error == ENXIO || error == EISDIR;
  return is_name ? StorageErrorCode::kPath : StorageErrorCode::kIo;
}

[[noreturn]] void failAt(const std::string& path, const std::string& what, int error) {
  throw StorageError(codeOf(error), printable(path) + ": " + what + ": " + reasonOf(error));
}

void syncPath(const std::string& path) {
  const FileDescriptor fd(open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!fd.isOpen() || fsync(fd.get()) != 0) failAt(path, "cannot be synced", errno);
}

/// Makes a directory and those above it, so that they are there after the power went, too.
void makeDirectory(const std::filesystem::path& path) {
  struct stat status {};
  if (path.empty() || stat(path.c_str(), &status) == 0) return;
  makeDirectory(path.parent_path());
  if (mkdir(path.c_str(), S_IRWXU) != 0 && errno != EEXIST) {
    failAt(path.string(), "cannot be made", errno);
  }
  syncPath(path.has_parent_path() ? path.parent_path().string() : ".");
}

/// A link that somebody else made could lead anywhere.
void refuseForeignLink(const std::string& path) {
  struct stat status {};
  if (lstat(path.c_str(), &status) != 0 || !S_ISLNK(status.st_mode)) return;
  if (status.st_uid == geteuid() || status.st_uid == 0) return;
  throw StorageError(StorageErrorCode::kPath,
                     printable(path) + ": a symbolic link that belongs to another user");
}

}  // namespace

bool FileIdentity::operator==(const FileIdentity& other) const {
  return std::tie(device, inode, size, seconds, nanoseconds) ==
         std::tie(other.device, other.inode, other.size, other.seconds, other.nanoseconds);
}

Directory::Directory(const std::string& path, bool create) : path_(path) {
  if (path.empty() || path.find('\0') != std::string::npos) {
    throw StorageError(StorageErrorCode::kPath,
                       "'" + printable(path) + "': no path of a directory");
  }
  while (path_.size() > 1 && path_.back() == '/') path_.pop_back();
  refuseForeignLink(path_);
  if (create) makeDirectory(path_);
  fd_ = FileDescriptor(open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!fd_.isOpen()) failAt(path_, "cannot be used as a directory", errno);
}

std::string Directory::pathOf(const std::string& name) const {
  return printable(path_ + "/" + name);
}

std::string Directory::accessWarning() const {
  struct stat status {};
  if (fstat(fd_.get(), &status) != 0) return "";
  if ((status.st_mode & S_IWOTH) != 0) {
    return printable(path_) + ": everybody may write into this directory";
  }
  const bool is_foreign = status.st_uid != geteuid() && status.st_uid != 0;
  return is_foreign ? printable(path_) + ": this directory belongs to another user" : "";
}

bool Directory::isInPlace() const {
  struct stat own {};
  struct stat at_path {};
  return fstat(fd_.get(), &own) == 0 && stat(path_.c_str(), &at_path) == 0 &&
         own.st_ino == at_path.st_ino && own.st_dev == at_path.st_dev;
}

void Directory::fail(const std::string& name, const std::string& what, int error) const {
  failAt(path_ + "/" + name, what, error);
}

int Directory::openFile(const std::string& name, int flags) const {
  int fd = -1;
  do {
    fd = openat(fd_.get(), name.c_str(), flags | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK | O_NOCTTY,
                kOwnerOnly);
  } while (fd < 0 && errno == EINTR);
  return fd;
}

std::optional<FileContents> Directory::read(const std::string& name) const {
  const FileDescriptor file(openFile(name, O_RDONLY));
  if (!file.isOpen() && errno == ENOENT) return std::nullopt;
  if (!file.isOpen()) fail(name, "cannot be opened", errno);
  struct stat status {};
  if (fstat(file.get(), &status) != 0) fail(name, "cannot be read", errno);
  if (!S_ISREG(status.st_mode)) {
    throw StorageError(StorageErrorCode::kPath, pathOf(name) + ": not a regular file");
  }
  if (status.st_size > kMaxFileSize) {
    throw StorageError(StorageErrorCode::kCorrupt,
                       pathOf(name) + ": larger than " + std::to_string(kMaxFileSize) + " bytes");
  }
  FileContents contents{std::string(static_cast<std::size_t>(status.st_size), '\0'),
                        identityFrom(status)};
  std::size_t done = 0;
  while (done < contents.text.size()) {
    const ssize_t count = ::read(file.get(), &contents.text[done], contents.text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(name, "cannot be read", errno);
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  contents.text.resize(done);
  return contents;
}

std::optional<FileIdentity> Directory::identityOf(const std::string& name) const {
  struct stat status {};
  if (fstatat(fd_.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0) {
    return identityFrom(status);
  }
  if (errno != ENOENT) fail(name, "cannot be looked at", errno);
  return std::nullopt;
}

std::vector<std::string> Directory::names() const {
  FileDescriptor fd(openFile(".", O_RDONLY | O_DIRECTORY));
  DIR* opened = fd.isOpen() ? fdopendir(fd.get()) : nullptr;
  if (opened == nullptr) fail(".", "cannot be listed", errno);
  fd.release();
  const std::unique_ptr<DIR, int (*)(DIR*)> stream(opened, closedir);
  std::vector<std::string> names;
  errno = 0;
  while (const dirent* entry = readdir(stream.get())) names.emplace_back(entry->d_name);
  if (errno != 0) fail(".", "cannot be listed", errno);
  std::sort(names.begin(), names.end());
  return names;
}

FileDescriptor Directory::create(const std::string& name) const {
  FileDescriptor file(openFile(name, O_WRONLY | O_CREAT | O_EXCL));
  if (!file.isOpen()) fail(name, "cannot be made", errno);
  if (fchmod(file.get(), kOwnerOnly) != 0) {  // the process's umask may have taken more
    const int error = errno;
    remove(name);
    fail(name, "cannot be made", error);
  }
  return file;
}

std::string Directory::temporaryName(const std::string& stem) const {
  std::random_device random;
  const std::uint64_t number = (std::uint64_t{random()} << 32) | random();
  return stem + kTemporary + hexadecimalOf(number);
}

std::string Directory::writeTemporary(const std::string& stem, const std::string& text) const {
  const std::string name = temporaryName(stem);
  FileDescriptor file = create(name);
  int error = writeAll(file.get(), text);
  const char* what = "cannot be written";
  if (error == 0 && fsync(file.get()) != 0) error = errno, what = "cannot be synced";
  if (file.close() != 0 && error == 0) error = errno, what = "cannot be closed";
  if (error == 0) return name;
  remove(name);
  fail(name, what, error);
}

void Directory::rename(const std::string& from, const std::string& to) const {
  if (renameat(fd_.get(), from.c_str(), fd_.get(), to.c_str()) == 0) return;
  fail(from, "cannot be renamed to " + printable(to), errno);
}

void Directory::keepAs(const std::string& name, const std::string& second,
                       const std::string& stem) const {
  const std::string temporary = temporaryName(stem);
  if (linkat(fd_.get(), name.c_str(), fd_.get(), temporary.c_str(), 0) != 0) {
    if (errno != EPERM && errno != EOPNOTSUPP && errno != EMLINK) {
      fail(name, "cannot be linked", errno);
    }
    return rename(name, second);
  }
  try {
    rename(temporary, second);
  } catch (const StorageError&) {
    remove(temporary);
    throw;
  }
  remove(temporary);  // rename(2) leaves both names if they were one file already
}

bool Directory::remove(const std::string& name) const noexcept {
  return unlinkat(fd_.get(), name.c_str(), 0) == 0 || errno == ENOENT;
}

// A new descriptor each time, since an error is told to each only once and then forgotten.
void Directory::sync() const {
  FileDescriptor fd(openFile(".", O_RDONLY | O_DIRECTORY));
  if (!fd.isOpen() || fsync(fd.get()) != 0) fail(".", "cannot be synced", errno);
}

FileDescriptor Directory::lock(const std::string& name) const {
  FileDescriptor file(openFile(name, O_RDWR | O_CREAT));
  if (!file.isOpen()) fail(name, "cannot be opened", errno);
  if (flock(file.get(), LOCK_EX | LOCK_NB) == 0) return file;
  const std::string why =
      errno == EWOULDBLOCK
          ? "in use by another process"
          : "cannot be locked (does this file system know locks?): " + reasonOf(errno);
  throw StorageError(StorageErrorCode::kLocked, pathOf(name) + ": " + why);
}

std::string Directory::freeName(const std::string& name) const {
  for (int number = 1;; ++number) {
    const std::string numbered = name + "-" + std::to_string(number);
    if (!identityOf(numbered)) return numbered;
  }
}

int writeAll(int fd, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = write(fd, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    done += static_cast<std::size_t>(count);
  }
  return 0;
}

bool isTemporary(const std::string& name, const std::string& stem) {
  const std::string start = stem + kTemporary;
  return name.size() == start.size() + 16 && name.compare(0, start.size(), start) == 0 &&
         valueOfHexadecimal(std::string_view(name).substr(start.size())).has_value();
}

}  // namespace agrid
