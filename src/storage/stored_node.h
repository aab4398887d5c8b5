// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace agrid {

/// A value of a YAML text, with what it holds.
struct StoredNode {
  enum class Kind { kNull, kScalar, kSequence, kMapping };
  Kind kind = Kind::kNull;
  int line = 0;      ///< counted from 1
  std::string key;   ///< under which its mapping holds it
  std::string text;  ///< of a scalar
  std::vector<StoredNode> children;
};

}  // namespace agrid
