// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "agrid/storage.h"
#include "storage/directory.h"

namespace agrid {

/// The names of the files of one stored map.
struct StoreFiles {
  explicit StoreFiles(const std::string& name);

  std::string snapshot;
  std::string backup;
  std::string conflict;
  std::string lock;
  std::string temporary_stem;
  std::string journal_stem;

  std::string journal(std::uint64_t number) const;
  /// The number of a journal's name; none if it is no such name.
  std::optional<std::uint64_t> journalNumber(const std::string& file) const;
};

/// A journal on disk.
struct KnownJournal {
  std::uint64_t number = 0;
  std::uint64_t last_sequence = 0;  ///< of its records; 0 if it has none
  bool is_damaged = false;
  std::uint64_t bytes = 0;
};

/// What is on disk, put together.
struct Recovered {
  StoreContents contents;
  std::uint64_t history = 0;            ///< 0: none yet
  std::uint64_t sequence = 0;           ///< of the last edit
  std::uint64_t snapshot_sequence = 0;  ///< of the last edit that the snapshot holds
  std::uint64_t backup_sequence = 0;    ///< ... that the backup holds for sure
  std::optional<FileIdentity> snapshot_identity;
  std::uint64_t snapshot_checksum = 0;  ///< of its file
  std::uint64_t journal_bytes = 0;      ///< of journals with edits that the snapshot does not hold
  std::uint64_t snapshot_bytes = 0;
  std::vector<KnownJournal> journals;  ///< by number
};

/// Reads the snapshot, or else the backup, and applies the journals: those of the same history, in
/// the order of their numbers; edits that are in the snapshot already are left out.
/// @param may_rename  whether damaged and foreign files are renamed, so that nothing overwrites
/// them
/// @throws StorageError: kVersion, kPath, kIo
Recovered recover(const Directory& directory, const StoreFiles& files, bool may_rename);

}  // namespace agrid
