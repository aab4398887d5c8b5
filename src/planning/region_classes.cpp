// SPDX-License-Identifier: BSD-3-Clause
#include "planning/region_classes.h"

#include <algorithm>
#include <numeric>

namespace agrid::planning {
RegionClasses::RegionClasses(const MapGeometry& geometry, const PixelLabels& pixel_labels,
                             const std::vector<TurningPoint>& points)
    : geometry_(geometry), labels_(pixel_labels) {
  findBoxes();
  std::size_t count = 0;
  for (Box& box : boxes_) {
    box.first = count;
    if (box.high_x < 0) continue;
    count += static_cast<std::size_t>(box.high_x - box.low_x + 1) *
             static_cast<std::size_t>(box.high_y - box.low_y + 1);
  }
  std::vector<std::uint32_t> points_in_block(count);
  for (const TurningPoint& point : points) {
    const Pixel p = point.at.pixel();
    const Box& box = boxes_[pixel_labels[geometry.index(p)]];
    ++points_in_block[box.blockAt(p.x / kBlock, p.y / kBlock)];
  }
  block_class_.resize(count);
  for (const Box& box : boxes_) {
    if (box.high_x >= 0) divide(box, box, points_in_block);
  }
}

void RegionClasses::findBoxes() {
  std::vector<std::uint16_t> labels;
  for (int y = 0; y < geometry_.height; ++y) {
    labels_.copy(geometry_.index({0, y}), static_cast<std::size_t>(geometry_.width), labels);
    for (int x = 0; x < geometry_.width; ++x) {
      const auto i = static_cast<std::size_t>(x);
      if (x != 0 && x % kBlock != 0 && labels[i] == labels[i - 1]) continue;
      if (labels[i] >= boxes_.size()) boxes_.resize(labels[i] + std::size_t{1});
      Box& box = boxes_[labels[i]];
      box.low_x = std::min(box.low_x, x / kBlock);
      box.high_x = std::max(box.high_x, x / kBlock);
      box.low_y = std::min(box.low_y, y / kBlock);
      box.high_y = std::max(box.high_y, y / kBlock);
    }
  }
}

void RegionClasses::divide(const Box& box, const Box& part,
                           const std::vector<std::uint32_t>& points_in_block) {
  const bool across = part.high_x - part.low_x >= part.high_y - part.low_y;
  const int lines = across ? part.high_x - part.low_x + 1 : part.high_y - part.low_y + 1;
  std::vector<std::uint32_t> points_in_line(static_cast<std::size_t>(lines));
  for (int y = part.low_y; y <= part.high_y; ++y) {
    for (int x = part.low_x; x <= part.high_x; ++x) {
      points_in_line[static_cast<std::size_t>(across ? x - part.low_x : y - part.low_y)] +=
          points_in_block[box.blockAt(x, y)];
    }
  }
  const std::uint32_t total =
      std::accumulate(points_in_line.begin(), points_in_line.end(), std::uint32_t{0});
  if (total <= kMaxPoints || lines == 1) {
    for (int y = part.low_y; y <= part.high_y; ++y) {
      for (int x = part.low_x; x <= part.high_x; ++x) {
        block_class_[box.blockAt(x, y)] = next_class_;
      }
    }
    ++next_class_;
    return;
  }
  int first = 0;
  for (std::uint32_t sum = 0; first + 1 < lines - 1 && 2 * sum < total; ++first) {
    sum += points_in_line[static_cast<std::size_t>(first)];
  }
  first = std::max(first, 1);
  Box low = part;
  Box high = part;
  (across ? high.low_x : high.low_y) += first;
  (across ? low.high_x : low.high_y) = (across ? high.low_x : high.low_y) - 1;
  divide(box, low, points_in_block);
  divide(box, high, points_in_block);
}

void RegionClasses::classesOfRow(int y, std::vector<std::uint32_t>& classes) const {
  const auto width = static_cast<std::size_t>(geometry_.width);
  std::vector<std::uint16_t> labels;
  labels_.copy(static_cast<std::size_t>(y) * width, width, labels);
  for (std::size_t x = 0; x < width; ++x) {
    if (x != 0 && x % kBlock != 0 && labels[x] == labels[x - 1]) {
      classes[x] = classes[x - 1];
      continue;
    }
    classes[x] = block_class_[boxes_[labels[x]].blockAt(static_cast<int>(x) / kBlock, y / kBlock)];
  }
}

}  // namespace agrid::planning
