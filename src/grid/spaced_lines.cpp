// SPDX-License-Identifier: BSD-3-Clause
#include "grid/spaced_lines.h"

#include <iterator>

namespace agrid {

void SpacedLines::addIfFar(const WallLine& line, double min_distance) {
  const auto above = votes_.lower_bound(line.offset);
  if (above == votes_.end() || above == votes_.begin()) return;
  const double to_above = above->first - line.offset;
  const double to_below = line.offset - std::prev(above)->first;
  if (to_above < min_distance || to_below < min_distance) return;
  votes_.emplace_hint(above, line.offset, line.votes);
}

std::vector<WallLine> SpacedLines::lines() const {
  std::vector<WallLine> lines;
  lines.reserve(votes_.size());
  for (auto entry = std::next(votes_.begin()); entry != std::prev(votes_.end()); ++entry) {
    lines.push_back({entry->first, entry->second});
  }
  return lines;
}

}  // namespace agrid
