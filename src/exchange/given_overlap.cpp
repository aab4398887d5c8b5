// SPDX-License-Identifier: BSD-3-Clause
#include "exchange/given_overlap.h"

#include <algorithm>
#include <utility>

namespace agrid {

GivenOverlap::GivenOverlap(const std::vector<std::uint16_t>& given, const AreaMap& found)
    : given_sizes_(given.empty() ? 1 : *std::max_element(given.begin(), given.end()) + 1U, 0),
      found_sizes_(found.areas.size() + 1, 0) {
  for (std::size_t i = 0; i < given.size(); ++i) {
    const std::uint16_t label = found.pixel_labels[i];
    ++found_sizes_[label];
    ++given_sizes_[given[i]];
    if (label != 0 && given[i] != 0) ++common_[{label, given[i]}];
  }
}

std::int64_t GivenOverlap::common(std::uint16_t given, std::uint16_t found) const {
  const auto entry = common_.find({found, given});
  return entry == common_.end() ? 0 : entry->second;
}

std::uint16_t GivenOverlap::mainOf(std::uint16_t found) const {
  std::uint16_t main = 0;
  std::int64_t most = 0;
  for (auto entry = common_.lower_bound({found, std::uint16_t{0}});
       entry != common_.end() && entry->first.first == found; ++entry) {
    if (entry->second <= most) continue;
    most = entry->second;
    main = entry->first.second;
  }
  return 2 * most >= found_sizes_[found] ? main : std::uint16_t{0};
}

std::uint16_t GivenOverlap::bestFor(std::uint16_t given) const {
  std::uint16_t best = 0;
  std::int64_t most = 0;
  for (const auto& [pair, size] : common_) {
    if (pair.second != given || size <= most) continue;
    most = size;
    best = pair.first;
  }
  return best;
}

double GivenOverlap::iou(std::uint16_t given, std::uint16_t found) const {
  if (found == 0) return 0;
  const std::int64_t both = common(given, found);
  return static_cast<double>(both) /
         static_cast<double>(given_sizes_[given] + found_sizes_[found] - both);
}

double GivenOverlap::meanIou() const {
  double sum = 0;
  int count = 0;
  for (std::size_t k = 1; k < given_sizes_.size(); ++k) {
    const auto given = static_cast<std::uint16_t>(k);
    if (given_sizes_[k] == 0) continue;
    sum += iou(given, bestFor(given));
    ++count;
  }
  return count == 0 ? 1 : sum / count;
}

}  // namespace agrid
