// SPDX-License-Identifier: BSD-3-Clause
#include "tags/basins.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "tags/pixel_neighbours.h"

namespace agrid {
namespace {

constexpr std::uint8_t kPeak = 8;  ///< the pixel is the peak of its basin
constexpr std::uint8_t kFlat = 9;  ///< no neighbour is higher; its plateau decides

/// The relief with, for each pixel, which of its neighbours leads up.
class Ascent {
 public:
  explicit Ascent(const cv::Mat1f& relief) : relief_(relief), up_(relief.total(), kFlat) {
    for (std::size_t n = 0; n < kNeighbours.size(); ++n) {
      offsets_[n] = kNeighbours[n].x + static_cast<std::ptrdiff_t>(kNeighbours[n].y) * relief.cols;
    }
    takeSteepest();
    crossPlateaus();
  }

  /// Calls f(pixel, its index) for each pixel of the relief, row by row.
  template <typename F>
  void forEachPixel(F f) const {
    std::size_t index = 0;
    for (int y = 0; y < relief_.rows; ++y) {
      for (int x = 0; x < relief_.cols; ++x, ++index) {
        if (height(index) > 0) f(Pixel{x, y}, index);
      }
    }
  }
  /// Calls f(neighbour's number, its index) for each neighbour of a pixel inside the image.
  template <typename F>
  void forEachNeighbour(Pixel p, std::size_t index, F f) const {
    const bool inner = p.x > 0 && p.y > 0 && p.x + 1 < relief_.cols && p.y + 1 < relief_.rows;
    for (std::uint8_t n = 0; n < kNeighbours.size(); ++n) {
      const Pixel q = p + kNeighbours[n];
      if (!inner && (q.x < 0 || q.y < 0 || q.x >= relief_.cols || q.y >= relief_.rows)) continue;
      f(n, index + static_cast<std::size_t>(offsets_[n]));
    }
  }
  float height(std::size_t index) const { return relief_.ptr<float>()[index]; }
  bool isPeak(std::size_t index) const { return up_[index] == kPeak; }
  std::size_t next(std::size_t index) const {
    return index + static_cast<std::size_t>(offsets_[up_[index]]);
  }
  std::size_t size() const { return up_.size(); }

 private:
  void takeSteepest() {
    forEachPixel([&](Pixel p, std::size_t i) {
      const float h = height(i);
      std::array<float, 2> highest{h, h};  // straight and diagonal neighbours
      forEachNeighbour(p, i, [&](std::uint8_t n, std::size_t j) {
        highest[n / 4] = std::max(highest[n / 4], height(j));
      });
      const bool is_diagonal = (highest[1] - h) * 0.70710678F > highest[0] - h;
      const float target = highest[is_diagonal ? 1 : 0];
      if (target <= h) return;
      forEachNeighbour(p, i, [&](std::uint8_t n, std::size_t j) {
        if (up_[i] == kFlat && (n >= 4) == is_diagonal && height(j) == target) up_[i] = n;
      });
    });
  }

  void crossPlateaus() {
    std::vector<std::size_t> queue;
    forEachPixel([&](Pixel p, std::size_t i) {
      if (up_[i] == kFlat && followEqual(p, i)) queue.push_back(i);
    });
    for (const std::size_t i : queue) up_[i] = static_cast<std::uint8_t>(up_[i] - kDeferred);
    spread(queue);
    forEachPixel([&](Pixel, std::size_t i) {
      if (up_[i] != kFlat) return;
      up_[i] = kPeak;
      queue.assign(1, i);
      spread(queue);
    });
  }

  /// Marks a flat pixel at the rim of its plateau; the mark becomes a direction once all are found,
  /// so that the order of the scan does not matter.
  bool followEqual(Pixel p, std::size_t i) {
    forEachNeighbour(p, i, [&](std::uint8_t n, std::size_t j) {
      if (up_[i] == kFlat && height(j) == height(i) && up_[j] < kPeak) {
        up_[i] = static_cast<std::uint8_t>(n + kDeferred);
      }
    });
    return up_[i] != kFlat;
  }

  /// Lets the rest of each plateau follow the pixels in the queue, nearest first.
  void spread(std::vector<std::size_t>& queue) {
    const auto columns = static_cast<std::size_t>(relief_.cols);
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const std::size_t i = queue[head];
      const Pixel p{static_cast<int>(i % columns), static_cast<int>(i / columns)};
      forEachNeighbour(p, i, [&](std::uint8_t n, std::size_t j) {
        if (up_[j] != kFlat || height(j) != height(i)) return;
        up_[j] = static_cast<std::uint8_t>(n < 4 ? (n + 2) % 4 : 4 + (n - 2) % 4);
        queue.push_back(j);
      });
    }
  }

  static constexpr std::uint8_t kDeferred = 16;
  const cv::Mat1f& relief_;
  std::array<std::ptrdiff_t, 8> offsets_{};  ///< from a pixel's index to its neighbours'
  std::vector<std::uint8_t> up_;
};

/// Follows each pixel up to its peak or to a pixel already known.
void labelPixels(const Ascent& ascent, Basins& result) {
  std::vector<std::size_t> path;
  ascent.forEachPixel([&](Pixel, std::size_t start) {
    path.clear();
    std::size_t i = start;
    while (result.of_pixel[i] == Basins::kNone && !ascent.isPeak(i)) {
      path.push_back(i);
      i = ascent.next(i);
    }
    if (result.of_pixel[i] == Basins::kNone) {
      result.of_pixel[i] = static_cast<std::uint32_t>(result.basins.size());
      result.basins.push_back({i, ascent.height(i), 1});
    }
    const std::uint32_t basin = result.of_pixel[i];
    for (const std::size_t j : path) result.of_pixel[j] = basin;
    result.basins[basin].size_px += path.size();
  });
}

void findSaddles(const Ascent& ascent, Basins& result) {
  std::unordered_map<std::uint64_t, Saddle> saddles;
  ascent.forEachPixel([&](Pixel p, std::size_t i) {
    const std::uint32_t a = result.of_pixel[i];
    ascent.forEachNeighbour(p, i, [&](std::uint8_t, std::size_t j) {
      const std::uint32_t b = result.of_pixel[j];
      if (b <= a || b == Basins::kNone) return;
      const std::size_t lowest = ascent.height(i) <= ascent.height(j) ? i : j;
      Saddle& saddle = saddles[std::uint64_t{a} << 32U | b];
      if (ascent.height(lowest) > saddle.height) saddle = {ascent.height(lowest), a, b, lowest};
    });
  });
  result.saddles.reserve(saddles.size());
  for (const auto& entry : saddles) result.saddles.push_back(entry.second);
  std::sort(result.saddles.begin(), result.saddles.end(), [](const Saddle& p, const Saddle& q) {
    if (p.height != q.height) return p.height > q.height;
    return p.a != q.a ? p.a < q.a : p.b < q.b;
  });
}

}  // namespace

Basins findBasins(const cv::Mat1f& relief) {
  const Ascent ascent(relief);
  Basins result;
  result.of_pixel.assign(ascent.size(), Basins::kNone);
  labelPixels(ascent, result);
  findSaddles(ascent, result);
  return result;
}

}  // namespace agrid
