// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "agrid/tags/knowledge.h"

namespace agrid {

/// What binds a journal to the snapshots that its edits follow.
struct JournalStart {
  std::uint64_t history = 0;
  /// Number of its first edit; what earlier journals of this history say from here on was never
  /// acknowledged.
  std::uint64_t sequence = 1;
};

/// One edit: all of its changes or none.
struct JournalRecord {
  std::uint64_t sequence = 0;
  std::vector<Change> edit;
};

// A journal is lines of text, each with its checksum: first its start, then records.
std::string journalLine(const JournalStart& start);
std::string journalLine(std::uint64_t sequence, const std::vector<Change>& edit);

struct ReadJournal {
  std::optional<JournalStart> start;   ///< none: unreadable
  std::vector<JournalRecord> records;  ///< numbered from the start, some may be missing
  /// Lines that were whole once and are damaged, for people; a last line that was never written to
  /// its end is none of them.
  std::vector<std::string> damage;
};

/// @param path  for messages
/// @throws StorageError (kVersion)
ReadJournal readJournal(const std::string& text, const std::string& path);

}  // namespace agrid
