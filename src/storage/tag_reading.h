// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "agrid/tags/knowledge.h"
#include "storage/stored_node.h"

namespace agrid {

/// The text that nodes come from.
struct StoredText {
  std::string name;                   ///< its path, for messages
  std::vector<std::string> warnings;  ///< keys that nobody knows; at most 20
};

/// @throws StorageError (kCorrupt) naming text, line and key
[[noreturn]] void refuseNode(const StoredText& text, const StoredNode& node,
                             const std::string& what);

/// What flowText() wrote, or a person. What is left out gets its default, a missing id 0, a missing
/// source `manual`; unknown keys are left out with a warning.
/// @throws StorageError (kCorrupt)
Tag readTag(TagKind kind, const StoredNode& node, StoredText& text);
PendingTag readPending(const StoredNode& node, StoredText& text);
NextIds readNextIds(const StoredNode& node, StoredText& text);
std::vector<Change> readEdit(const StoredNode& node, StoredText& text);

/// The text of a scalar; of nothing, an empty one.
const std::string& readText(const StoredNode& node, const StoredText& text);
/// A whole number from `least` to `most`.
std::uint64_t readWhole(const StoredNode& node, std::uint64_t least, std::uint64_t most,
                        const StoredText& text);

}  // namespace agrid
