// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "agrid/storage.h"

namespace agrid {

/// All that was known at one moment, as it stands in its file.
struct Snapshot {
  StoredMap map;
  /// Which line of edits it belongs to, journals bear the same; 0: a person wrote it from scratch.
  std::uint64_t history = 0;
  std::uint64_t sequence = 0;  ///< number of the last edit that is in it
};

/// The file form (doc/file_format.md). Ends with a checksum.
std::string snapshotText(const Snapshot& snapshot);

struct ReadSnapshot {
  Snapshot snapshot;
  std::vector<std::string> warnings;
};

/// Reads what snapshotText() wrote, or a person changed or wrote: without checksum or with a false
/// one it is taken if it makes sense, unless the difference is one flipped bit. Ids that are
/// missing are given out.
/// @param path  for messages
/// @throws StorageError kCorrupt naming path and line; kVersion
ReadSnapshot readSnapshot(const std::string& text, const std::string& path);

}  // namespace agrid
