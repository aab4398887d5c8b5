// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "storage/file_descriptor.h"

namespace agrid {

/// What a file was when it was looked at; another one means that somebody wrote it.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  std::int64_t size = 0;
  std::int64_t seconds = 0;  ///< of its last change
  std::int64_t nanoseconds = 0;

  bool operator==(const FileIdentity& other) const;
};

struct FileContents {
  std::string text;
  FileIdentity identity;
};

/// The files of one directory, by names without slashes: all access goes through one descriptor of
/// it, so that no renamed or linked path leads elsewhere. Symbolic links are refused, new files are
/// only for their owner. Errors are StorageError (kIo, kPath) with path and reason.
class Directory {
 public:
  /// @param create  whether to make it, and those above it, if it is missing
  Directory(const std::string& path, bool create);

  const std::string& path() const { return path_; }
  std::string pathOf(const std::string& name) const;  ///< fit for messages
  /// Others may write into it or it belongs to somebody else: a sentence; empty otherwise.
  std::string accessWarning() const;
  /// Whether its path still leads to it.
  bool isInPlace() const;

  /// @return none if there is no such file
  std::optional<FileContents> read(const std::string& name) const;
  std::optional<FileIdentity> identityOf(const std::string& name) const;
  std::vector<std::string> names() const;

  /// A file that is not there yet, open for writing.
  FileDescriptor create(const std::string& name) const;
  /// Writes and syncs a temporary file whose name begins with `stem`.
  /// @return its name
  std::string writeTemporary(const std::string& stem, const std::string& text) const;
  void rename(const std::string& from, const std::string& to) const;
  /// Gives a file a second name, in place of what has that name; where the file system has no
  /// second names, it loses the first.
  void keepAs(const std::string& name, const std::string& second, const std::string& stem) const;
  /// @return whether it is gone; what cannot be removed stays
  bool remove(const std::string& name) const noexcept;
  /// Makes names durable.
  void sync() const;

  /// Takes the lock that a file of this name stands for.
  /// @throws StorageError (kLocked)
  FileDescriptor lock(const std::string& name) const;
  /// The first of NAME-1, NAME-2, ... that is free.
  std::string freeName(const std::string& name) const;

  [[noreturn]] void fail(const std::string& name, const std::string& what, int error) const;

 private:
  int openFile(const std::string& name, int flags) const;
  std::string temporaryName(const std::string& stem) const;

  std::string path_;
  FileDescriptor fd_;
};

/// Writes all of it to an open file. @return 0 or the error
int writeAll(int fd, const std::string& text);

/// What temporaryName() makes of a stem: the stem, "tmp-" and 16 hexadecimal digits.
bool isTemporary(const std::string& name, const std::string& stem);

}  // namespace agrid
