// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "agrid/storage.h"
#include "tools/outline_shares.h"

namespace agrid::tools {

/// Which tags of one kind are the same in two files: indices into the other's list.
struct TagPairs {
  std::vector<std::optional<std::size_t>> in_b;  ///< by index in A
  std::vector<std::optional<std::size_t>> in_a;  ///< by index in B
};

/// Which tags of two files are the same.
struct KnowledgePairs {
  bool by_id = false;  ///< else by place
  TagPairs areas;
  TagPairs doors;
  TagPairs objects;
};

/// Tags are paired by id if both files have a history in common, or if at least half of the tags
/// that have kind and id in common are alike: areas by outlines that lie half in one another (or by
/// name, if one has no outline), doors and objects by place or name. Else by place: areas by the
/// best common share of outlines, at least half of their union; doors within 0.6 m, objects of the
/// same name, then of any name within 0.6 m, the nearest first.
/// @param shares  of the outlines of both; empty if their frames differ, and then nothing is paired
///                by place but objects of the same name
KnowledgePairs pairUp(const StoreContents& a, const StoreContents& b,
                      const std::vector<OutlineShare>& shares);

}  // namespace agrid::tools
