// SPDX-License-Identifier: BSD-3-Clause
#include "area_picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "graph_shapes.h"

namespace agrid_map_rviz {
namespace {

bool isSound(const agrid_map::AGrid& grid) {
  if (grid.x.size() < 2 || grid.y.size() < 2) return false;
  if (grid.labels.size() != (grid.x.size() - 1) * (grid.y.size() - 1)) return false;
  const auto rising = [](const std::vector<double>& edges) {
    return std::isfinite(edges.front()) && std::isfinite(edges.back()) &&
           std::adjacent_find(edges.begin(), edges.end(),
                              [](double a, double b) { return !(a < b); }) == edges.end();
  };
  return rising(grid.x) && rising(grid.y);
}

/// The cell that each texel of an axis lies in.
std::vector<std::size_t> cellsOfTexels(const std::vector<double>& edges, double texel,
                                       std::uint32_t max_side) {
  const double extent = edges.back() - edges.front();
  const auto count = static_cast<std::size_t>(
      std::clamp(std::ceil(extent / texel), 1.0, static_cast<double>(max_side)));
  std::vector<std::size_t> cells(count);
  std::size_t cell = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double center =
        edges.front() + (static_cast<double>(i) + 0.5) * extent / static_cast<double>(count);
    while (cell + 2 < edges.size() && edges[cell + 1] <= center) ++cell;
    cells[i] = cell;
  }
  return cells;
}

void paintRow(const std::uint32_t* labels, const std::vector<std::size_t>& columns,
              std::uint8_t* texels) {
  std::uint32_t label = agrid_map::AGrid::NONE;
  std::uint8_t color[4] = {0, 0, 0, 0};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (labels[columns[i]] != label) {
      label = labels[columns[i]];
      const Color c = areaColor(label);
      const float channels[] = {c.r, c.g, c.b, label == agrid_map::AGrid::NONE ? 0.0F : 1.0F};
      for (int k = 0; k < 4; ++k) {
        color[k] = static_cast<std::uint8_t>(std::lround(255 * channels[k]));
      }
    }
    std::memcpy(texels + 4 * i, color, 4);
  }
}

}  // namespace

AreaPicture paintAreas(const agrid_map::AGrid& grid, double texel, std::uint32_t max_side) {
  AreaPicture picture;
  if (!isSound(grid)) return picture;
  const auto columns = cellsOfTexels(grid.x, texel, max_side);
  const auto rows = cellsOfTexels(grid.y, texel, max_side);
  picture.width = static_cast<std::uint32_t>(columns.size());
  picture.height = static_cast<std::uint32_t>(rows.size());
  picture.left = grid.x.front();
  picture.right = grid.x.back();
  picture.low = grid.y.front();
  picture.high = grid.y.back();
  const std::size_t row_bytes = 4 * columns.size();
  picture.rgba.resize(row_bytes * rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::uint8_t* texels = picture.rgba.data() + i * row_bytes;
    if (i > 0 && rows[i] == rows[i - 1]) {
      std::memcpy(texels, texels - row_bytes, row_bytes);
    } else {
      paintRow(grid.labels.data() + rows[i] * (grid.x.size() - 1), columns, texels);
    }
  }
  return picture;
}

}  // namespace agrid_map_rviz
