// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "agrid/map/map_io.h"

namespace agrid {

/// Reads a regular file from its start, never by mmap (a file cut short meanwhile would end the
/// process) and never waiting for a pipe or a device.
class FileReader {
 public:
  /// @param map_dir  if not empty, the file must lie under it once all links are resolved
  /// @throws FileError (kPath) if the file cannot be opened or is not a regular file
  explicit FileReader(const std::string& path, const std::string& map_dir = {});
  FileReader(const FileReader&) = delete;
  FileReader& operator=(const FileReader&) = delete;
  ~FileReader();

  std::uint64_t size() const { return size_; }      ///< bytes of the file when it was opened
  std::uint64_t offset() const { return offset_; }  ///< of the next byte
  std::uint64_t remaining() const { return size_ > offset_ ? size_ - offset_ : 0; }

  /// The next byte, which stays the next; none at the end of the file.
  std::optional<std::uint8_t> peek() {
    if (next_ == end_ && !fill()) return std::nullopt;
    return buffer_[next_];
  }
  /// Takes the next byte; none at the end of the file.
  std::optional<std::uint8_t> take() {
    const auto byte = peek();
    if (byte) ++next_, ++offset_;
    return byte;
  }
  /// The file's first bytes, up to `size`, which is small; only before any is taken.
  std::string start(std::size_t size);
  /// Takes up to `size` bytes, less only at the end of the file.
  std::size_t read(std::uint8_t* bytes, std::size_t size);
  /// Takes `count` bytes and forgets them, less only at the end of the file.
  void skip(std::uint64_t count);

  /// @throws FileError always, with the path in front of `what`
  [[noreturn]] void fail(FileErrorCode code, const std::string& what) const;

 private:
  bool fill();
  std::size_t readSome(std::uint8_t* bytes, std::size_t size);

  std::string name_;  // for messages
  int fd_ = -1;
  std::uint64_t size_ = 0;
  std::uint64_t offset_ = 0;
  std::size_t next_ = 0;  // in the buffer
  std::size_t end_ = 0;
  std::array<std::uint8_t, 65536> buffer_;
};

}  // namespace agrid
