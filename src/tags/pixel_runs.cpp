// SPDX-License-Identifier: BSD-3-Clause
#include "tags/pixel_runs.h"

#include <cstring>

#include "tags/disjoint_sets.h"

namespace agrid {

std::vector<PixelRun> findRuns(const cv::Mat1b& image, std::uint8_t value) {
  std::vector<PixelRun> runs;
  for (int y = 0; y < image.rows; ++y) {
    const std::uint8_t* row = image[y];
    const std::uint8_t* end = row + image.cols;
    const auto find = [&](const std::uint8_t* from, int wanted) {
      const void* found = std::memchr(from, wanted, static_cast<std::size_t>(end - from));
      return found ? static_cast<const std::uint8_t*>(found) : end;
    };
    for (const std::uint8_t* begin = find(row, value); begin != end;) {
      const std::uint8_t* past = find(begin, 1 - value);
      runs.push_back({y, static_cast<int>(begin - row), static_cast<int>(past - row)});
      begin = find(past, value);
    }
  }
  return runs;
}

std::vector<std::uint32_t> connectRuns(const std::vector<PixelRun>& runs, bool by_corners) {
  const int reach = by_corners ? 1 : 0;
  const auto count = static_cast<std::uint32_t>(runs.size());
  DisjointSets components(count);
  std::uint32_t above = 0;  // the first run of the row above that may touch this one
  for (std::uint32_t i = 0; i < count; ++i) {
    const PixelRun& run = runs[i];
    const auto isPast = [&](const PixelRun& r) {
      return r.y < run.y - 1 || (r.y == run.y - 1 && r.end + reach <= run.begin);
    };
    while (isPast(runs[above])) ++above;
    for (std::uint32_t j = above; runs[j].y < run.y && runs[j].begin < run.end + reach; ++j) {
      components.unite(components.find(j), i);
    }
  }
  return components.numbers();
}

}  // namespace agrid
