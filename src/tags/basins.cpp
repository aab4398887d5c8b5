// SPDX-License-Identifier: BSD-3-Clause
#include "tags/basins.h"

#include <algorithm>
#include <cstring>
#include <unordered_map>

#include "tags/ascent.h"

namespace agrid {
namespace {

/// Gives each pixel the basin of the peak that its way leads to. Most ways go on to pixels that
/// the same scan has met before; so one scan up the image and one down it leave few to be followed.
class Labelling {
 public:
  Labelling(const Ascent& ascent, const float* height, Basins& result)
      : ascent_(ascent), height_(height), result_(result), of_pixel_(result.of_pixel) {}

  void run() {
    for (std::size_t i = of_pixel_.size(); i-- > 0;) {
      const std::uint8_t way = ascent_.way(i);
      if (way == Ascent::kPeak) {
        of_pixel_[i] = static_cast<std::uint32_t>(peaks_.size());
        peaks_.push_back(i);
      } else if (leadsDown(way)) {
        of_pixel_[i] = of_pixel_[ascent_.next(i)];
      }
    }
    number_.assign(peaks_.size(), Basins::kNone);
    std::uint32_t basin = Basins::kNone;
    std::size_t begin = 0;  // of the run of pixels of that basin
    const auto endRun = [&](std::size_t end) {
      if (basin != Basins::kNone) result_.basins[basin].size_px += end - begin;
      begin = end;
    };
    for (std::size_t i = 0; i < of_pixel_.size(); ++i) {
      of_pixel_[i] = numberAt(i);
      if (of_pixel_[i] == basin) continue;
      endRun(i);
      basin = of_pixel_[i];
    }
    endRun(of_pixel_.size());
  }

 private:
  /// Whether a way leads to a later pixel, row by row.
  static bool leadsDown(std::uint8_t way) { return (0b110011U >> way & 1U) != 0; }

  /// The basin of a pixel when all before it have theirs; the others' are numbers of peaks or none.
  std::uint32_t numberAt(std::size_t i) {
    const std::uint8_t way = ascent_.way(i);
    if (way == Ascent::kOutside) return Basins::kNone;
    if (of_pixel_[i] == Basins::kNone) {
      if (!leadsDown(way)) return of_pixel_[ascent_.next(i)];
      follow(i);
    }
    std::uint32_t& number = number_[of_pixel_[i]];
    if (number == Basins::kNone) {
      const std::size_t peak = peaks_[of_pixel_[i]];
      number = static_cast<std::uint32_t>(result_.basins.size());
      result_.basins.push_back({peak, height_[peak], 0});
      peak_of_.push_back(of_pixel_[i]);
    }
    return number;
  }

  /// Labels all pixels of a way with the number of their peak.
  void follow(std::size_t start) {
    path_.clear();
    std::size_t i = start;
    for (; of_pixel_[i] == Basins::kNone; i = ascent_.next(i)) path_.push_back(i);
    const std::uint32_t peak = i < start ? peak_of_[of_pixel_[i]] : of_pixel_[i];
    for (const std::size_t j : path_) of_pixel_[j] = peak;
  }

  const Ascent& ascent_;
  const float* height_;
  Basins& result_;
  std::vector<std::uint32_t>& of_pixel_;
  std::vector<std::size_t> peaks_;      ///< as the scan up the image meets them
  std::vector<std::uint32_t> number_;   ///< for each of them its basin
  std::vector<std::uint32_t> peak_of_;  ///< for each basin its peak's number
  std::vector<std::size_t> path_;
};

/// Marks the pixels of a row that have a neighbour of a basin with a higher number.
/// @param rows  the basins in the row before, in this one and in the next
void findRims(const std::array<const std::uint32_t*, 3>& rows, int columns, std::uint8_t* is_rim) {
  static_assert(static_cast<std::int32_t>(Basins::kNone) == -1, "below all basins");
  const auto basin = [&](std::size_t row, int x) {
    return static_cast<std::int32_t>(rows[row][x]);
  };
  for (int x = 1; x + 1 < columns; ++x) {
    const std::int32_t own = basin(1, x);
    const int higher = (basin(0, x - 1) > own) | (basin(0, x) > own) | (basin(0, x + 1) > own) |
                       (basin(1, x - 1) > own) | (basin(1, x + 1) > own) | (basin(2, x - 1) > own) |
                       (basin(2, x) > own) | (basin(2, x + 1) > own);
    is_rim[x] = static_cast<std::uint8_t>(higher & (own >= 0));
  }
  is_rim[0] = basin(1, 0) >= 0;
  is_rim[columns - 1] = basin(1, columns - 1) >= 0;
}

/// Calls f(index) for each pixel that may have a neighbour of a basin with a higher number.
template <typename F>
void forEachRim(const std::vector<std::uint32_t>& of_pixel, const cv::Size& size, F f) {
  const auto columns = static_cast<std::size_t>(size.width);
  std::vector<std::uint8_t> is_rim(columns);
  for (int y = 0; y < size.height; ++y) {
    const std::size_t first = static_cast<std::size_t>(y) * columns;
    const std::uint32_t* row = of_pixel.data() + first;
    findRims({y > 0 ? row - columns : row, row, y + 1 < size.height ? row + columns : row},
             size.width, is_rim.data());
    for (std::size_t x = 0; x < columns; ++x) {
      const void* found = std::memchr(is_rim.data() + x, 1, columns - x);
      if (!found) break;
      x = static_cast<std::size_t>(static_cast<const std::uint8_t*>(found) - is_rim.data());
      f(first + x);
    }
  }
}

void findSaddles(const Ascent& ascent, const cv::Mat1f& relief, Basins& result) {
  const float* height = relief.ptr<float>();
  std::unordered_map<std::uint64_t, Saddle> saddles;
  forEachRim(result.of_pixel, relief.size(), [&](std::size_t i) {
    const std::uint32_t a = result.of_pixel[i];
    ascent.forEachNeighbour(i, [&](std::uint8_t, std::size_t j) {
      const std::uint32_t b = result.of_pixel[j];
      if (b <= a || b == Basins::kNone) return;
      const std::size_t lowest = height[i] <= height[j] ? i : j;
      Saddle& saddle = saddles[std::uint64_t{a} << 32U | b];
      if (height[lowest] > saddle.height) saddle = {height[lowest], a, b, lowest};
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
  result.of_pixel.assign(relief.total(), Basins::kNone);
  Labelling(ascent, relief.ptr<float>(), result).run();
  findSaddles(ascent, relief, result);
  return result;
}

}  // namespace agrid
