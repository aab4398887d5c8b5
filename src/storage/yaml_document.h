// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "storage/stored_node.h"

namespace agrid {

/// Takes one entry of a document: an item of the list under `section`, or, if that is empty, the
/// value under `node.key`. Lists come item by item, so that no tree of the whole is built.
using NodeSink = std::function<void(const std::string& section, StoredNode&& node)>;

/// Reads a YAML text that is one mapping. Aliases, keys that are there twice and nesting deeper
/// than 8 levels are refused.
/// @param name  of the file, for messages
/// @throws StorageError (kCorrupt) naming file and line
void readYaml(const std::string& text, const std::string& name, const NodeSink& sink);

/// Reads the same if the text is laid out as this package writes it: a line for each value and for
/// each item of a list, several times as fast. Some items may be laid out otherwise.
/// @return false if more is; some entries may have been given out then
bool readOwnYaml(const std::string& text, const NodeSink& sink);

}  // namespace agrid
