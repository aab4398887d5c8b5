// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace agrid {

/// Writes a file that appears under its name only when it is complete: until `commit` the bytes go
/// to a temporary file in the same folder, which is removed if `commit` is not reached.
class FileWriter {
 public:
  /// @throws FileError (kPath) if the folder does not take a new file
  explicit FileWriter(const std::string& path);
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;
  ~FileWriter();

  /// @throws FileError (kIo)
  void write(const void* data, std::size_t size);
  void write(const std::string& text) { write(text.data(), text.size()); }

  /// Syncs the file, gives it its name, replacing a file that had it, and syncs the folder.
  /// @throws FileError (kIo)
  void commit();

 private:
  [[noreturn]] void fail(const char* what) const;

  std::string path_;
  std::string temporary_;
  int fd_ = -1;
};

}  // namespace agrid
