// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace agrid {

/// A place in a YAML text, counted from 1.
struct YamlMark {
  int line = 1;
  int column = 1;
};

/// What stands behind a key. Values that are neither a scalar nor a sequence of scalars are kept
/// as kOther, without contents.
struct YamlValue {
  enum class Kind { kNull, kScalar, kSequence, kOther };
  Kind kind = Kind::kNull;
  YamlMark mark;
  std::vector<std::string> scalars;  ///< one of a scalar, the items of a sequence
};

struct YamlEntry {
  std::string key;
  YamlMark mark;
  YamlValue value;
};

/// The entries of a YAML text that is one mapping, in its order. Nothing recurses deeper than a few
/// levels and aliases are refused, so that no text takes more memory than a few times its size.
/// @param name  for messages
/// @throws FileError (kYaml) naming line and column if the text is not one mapping with different
///         scalar keys, is nested deeper than 16 levels or holds an alias
std::vector<YamlEntry> yamlEntries(const std::string& text, const std::string& name);

}  // namespace agrid
