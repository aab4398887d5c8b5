// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "agrid/tags/knowledge.h"

namespace agrid {

/// What is kept of a place for ever (doc/file_format.md).
struct StoredMap {
  std::string map_id;    ///< digest of the metric map that it was last seen on
  std::string frame_id;  ///< in which all coordinates are, those of pending tags excepted
  Knowledge knowledge;
};

enum class StorageErrorCode {
  kIo,        ///< the system refused to read or write; nothing of the call was stored
  kCorrupt,   ///< not what was written
  kVersion,   ///< written by a newer version; left alone
  kLocked,    ///< in use by another process
  kPath,      ///< a name that is not allowed, a symbolic link, no such file
  kConflict,  ///< changed by somebody else since it was read or written
  kReadOnly   ///< the store was opened for reading
};

/// What went wrong with stored knowledge; `what()` names the path and the system's reason or key
/// and line.
class StorageError : public std::runtime_error {
 public:
  StorageError(StorageErrorCode code, const std::string& what)
      : std::runtime_error(what), code_(code) {}
  StorageErrorCode code() const { return code_; }

 private:
  StorageErrorCode code_;
};

/// The name, if it may name a stored map: 1 to 64 of A-Z a-z 0-9 _ . - and no dot in front.
/// @throws StorageError (kPath)
const std::string& checkedName(const std::string& name);

/// What was found on disk.
struct StoreContents {
  StoredMap map;
  bool is_new = false;  ///< nothing was stored under this name yet
  /// Damage: something may be lost, and people must be told loudly. What was damaged is kept.
  std::vector<std::string> errors;
  std::vector<std::string> warnings;  ///< accepted, but looks wrong
  /// The line of edits it belongs to: in files of the same one an id means the same thing. 0: none,
  /// as in a file that a person wrote.
  std::uint64_t history = 0;
};

struct StoreOptions {
  /// Takes no lock and changes nothing on disk; append() and what saves throw (kReadOnly).
  bool read_only = false;
  /// Makes the directory, and those above it, if it is missing (mode 0700).
  bool create_directory = true;
};

/// The stored knowledge of one place, held by one process at a time: a snapshot that people can
/// read and edit, `NAME.yaml`, the one before it, `NAME.yaml.bak`, and journals of what came since,
/// `NAME.journal-N`. What a call has stored when it returns survives the end of the process and of
/// the power at any later moment. Not safe for use by two threads at once; S and L below are rows
/// of the tests.
///
/// A call that throws has stored nothing, and the next one starts afresh: as soon as the disk has
/// space again, it succeeds.
class Store {
 public:
  /// Takes the lock, removes temporary files that a killed process left, and reads what is there. A
  /// damaged file is renamed to `*.corrupt-N`, and what it said is taken from the backup and the
  /// journals.
  /// @throws StorageError: kPath, kLocked, kVersion, kIo
  Store(const std::string& directory, const std::string& name, const StoreOptions& options = {});
  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;
  ~Store();  ///< frees the lock

  const std::string& name() const;
  const std::string& directory() const;

  /// What was on disk when it was opened; the second call finds nothing.
  StoreContents takeContents();

  /// Stores one edit, which may be several changes: after a crash all of them are there or none.
  /// @throws StorageError: kIo, kReadOnly; std::invalid_argument if a tag could not be read again
  ///         (an id of 0 or 2^32-1, numbers that are not finite, negative sizes)
  void append(const std::vector<Change>& edit);
  /// Stores several edits, each whole or not at all, for the price of one.
  void append(const std::vector<std::vector<Change>>& edits);

  /// Whether the journal has grown so long that fold() is due.
  bool journalIsLong() const;

  /// Writes a new snapshot, which must hold what was found and all that was appended since; the
  /// journals start afresh.
  /// @throws StorageError: kIo, kReadOnly; kConflict if somebody changed the snapshot since it was
  ///         read or written: that file stays, `map` is written to `NAME.yaml.conflict`, and edits
  ///         go on to the journal, which is applied to the changed file at the next start;
  ///         std::invalid_argument as append()
  void fold(const StoredMap& map);

  /// Stores another map in place of all that was stored under this name, backup included.
  /// @throws as fold()
  void replace(const StoredMap& map);

  /// Stores a map under another name in the same directory, in place of what has that name.
  /// @throws as fold() and the constructor
  void saveAs(const std::string& name, const StoredMap& map) const;

  /// Writes a file of another kind into the same directory, whole or not at all, in place of what
  /// has that name.
  /// @param file  allowed as the name of a stored map, and none that its files have
  /// @throws StorageError: kPath, kReadOnly, kIo
  void saveBeside(const std::string& file, const std::string& bytes) const;

  /// What is stored under a name in the same directory; changes nothing on disk.
  /// @throws StorageError: kPath if there is nothing, kVersion, kIo
  StoreContents loadFrom(const std::string& name) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// What is stored in a file, for tools: the journals beside it are applied if it is named
/// `NAME.yaml`. Changes nothing on disk.
/// @throws StorageError: kPath, kCorrupt, kVersion, kIo
StoreContents readStoredMap(const std::string& path);

}  // namespace agrid
