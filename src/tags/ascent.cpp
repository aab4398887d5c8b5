// SPDX-License-Identifier: BSD-3-Clause
#include "tags/ascent.h"

#include <algorithm>
#include <cstring>

namespace agrid {
namespace {

constexpr std::uint8_t kDeferred = 16;

/// Three rows of a relief around the one that is looked at, each with a 0 at either end.
class RowWindow {
 public:
  explicit RowWindow(const cv::Mat1f& relief) : relief_(relief) {
    for (auto& row : rows_) row.assign(static_cast<std::size_t>(relief.cols) + 2, 0.F);
    load(0, rows_[2]);
  }
  /// Moves on to row `y`, which follows the one before.
  void moveTo(int y) {
    std::swap(rows_[0], rows_[1]);
    std::swap(rows_[1], rows_[2]);
    load(y + 1, rows_[2]);
  }
  /// The row before, this one and the next, at column 0.
  const float* row(std::size_t i) const { return rows_[i].data() + 1; }

 private:
  void load(int y, std::vector<float>& row) const {
    if (y < relief_.rows) {
      std::copy(relief_[y], relief_[y] + relief_.cols, row.begin() + 1);
    } else {
      std::fill(row.begin(), row.end(), 0.F);
    }
  }
  const cv::Mat1f& relief_;
  std::array<std::vector<float>, 3> rows_;
};

/// The steepest way up of each pixel of a row; without branches, so that the compiler can take
/// several pixels at once.
void takeSteepestOfRow(const RowWindow& window, int columns, std::uint8_t* up) {
  const float* above = window.row(0);
  const float* row = window.row(1);
  const float* below = window.row(2);
  for (int x = 0; x < columns; ++x) {
    const float h = row[x];
    const float straight = std::max(std::max(row[x + 1], below[x]), std::max(row[x - 1], above[x]));
    const float diagonal =
        std::max(std::max(below[x + 1], below[x - 1]), std::max(above[x - 1], above[x + 1]));
    int straight_way = row[x - 1] == straight ? 2 : 3;
    straight_way = below[x] == straight ? 1 : straight_way;
    straight_way = row[x + 1] == straight ? 0 : straight_way;
    int diagonal_way = above[x - 1] == diagonal ? 6 : 7;
    diagonal_way = below[x - 1] == diagonal ? 5 : diagonal_way;
    diagonal_way = below[x + 1] == diagonal ? 4 : diagonal_way;
    const bool is_diagonal = (diagonal - h) * 0.70710678F > straight - h;
    int way = is_diagonal ? diagonal_way : straight_way;
    way = (is_diagonal ? diagonal : straight) > h ? way : Ascent::kFlat;
    up[x] = static_cast<std::uint8_t>(h > 0 ? way : Ascent::kOutside);
  }
}

}  // namespace

Ascent::Ascent(const cv::Mat1f& relief)
    : columns_(relief.cols), rows_(relief.rows), up_(relief.total()) {
  for (std::size_t n = 0; n < kNeighbours.size(); ++n) {
    offsets_[n] = kNeighbours[n].x + static_cast<std::ptrdiff_t>(kNeighbours[n].y) * columns_;
  }
  crossPlateaus(relief.ptr<float>(), takeSteepest(relief));
}

/// Returns the pixels that no neighbour tops, row by row.
std::vector<std::size_t> Ascent::takeSteepest(const cv::Mat1f& relief) {
  std::vector<std::size_t> flat;
  RowWindow window(relief);
  std::uint8_t* up = up_.data();
  for (int y = 0; y < rows_; ++y, up += columns_) {
    window.moveTo(y);
    takeSteepestOfRow(window, columns_, up);
    const std::uint8_t* end = up + columns_;
    for (const std::uint8_t* p = up; p != end; ++p) {
      p = static_cast<const std::uint8_t*>(
          std::memchr(p, kFlat, static_cast<std::size_t>(end - p)));
      if (!p) break;
      flat.push_back(static_cast<std::size_t>(p - up_.data()));
    }
  }
  return flat;
}

void Ascent::crossPlateaus(const float* height, const std::vector<std::size_t>& flat) {
  std::vector<std::size_t> queue;
  for (const std::size_t i : flat) {
    if (followEqual(height, i)) queue.push_back(i);
  }
  for (const std::size_t i : queue) up_[i] = static_cast<std::uint8_t>(up_[i] - kDeferred);
  spread(height, queue);
  for (const std::size_t i : flat) {
    if (up_[i] != kFlat) continue;
    up_[i] = kPeak;
    queue.assign(1, i);
    spread(height, queue);
  }
}

/// Marks a flat pixel at the rim of its plateau; the mark becomes a direction once all are found,
/// so that the order of the scan does not matter.
bool Ascent::followEqual(const float* height, std::size_t i) {
  forEachNeighbour(i, [&](std::uint8_t n, std::size_t j) {
    if (up_[i] == kFlat && height[j] == height[i] && up_[j] < kPeak) {
      up_[i] = static_cast<std::uint8_t>(n + kDeferred);
    }
  });
  return up_[i] != kFlat;
}

/// Lets the rest of each plateau follow the pixels in the queue, nearest first.
void Ascent::spread(const float* height, std::vector<std::size_t>& queue) {
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const std::size_t i = queue[head];
    forEachNeighbour(i, [&](std::uint8_t n, std::size_t j) {
      if (up_[j] != kFlat || height[j] != height[i]) return;
      up_[j] = static_cast<std::uint8_t>(n < 4 ? (n + 2) % 4 : 4 + (n - 2) % 4);
      queue.push_back(j);
    });
  }
}

}  // namespace agrid
