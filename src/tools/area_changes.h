// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "agrid/tags/tag.h"
#include "tools/outline_shares.h"
#include "tools/tag_pairs.h"
#include "tools/tag_sentences.h"

namespace agrid::tools {

/// Areas, by their index, of which it was told what became of them.
struct ToldAreas {
  std::set<std::size_t> a;
  std::set<std::size_t> b;
};

/// Tells which areas of A lie as two or more areas in B, and which of B were two or more in A. A
/// part belongs to the smallest area that holds at least half of it, and is none if it is the same
/// as some other area.
ToldAreas tellSplitsAndMerges(const std::vector<AreaTag>& a, const std::vector<AreaTag>& b,
                              const std::vector<OutlineShare>& shares, const TagPairs& pairs,
                              Sentences& sentences);

}  // namespace agrid::tools
