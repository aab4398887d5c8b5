// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "agrid/map/map_geometry.h"
#include "planning/fine_point.h"

namespace agrid::planning {

constexpr std::uint32_t kNoNode = 0xffffffff;

/// A rectangle of pixels, both corners inside.
struct PixelBox {
  Pixel low{0x7fffffff, 0x7fffffff};
  Pixel high{-1, -1};

  void add(Pixel p);
  std::size_t columns() const { return static_cast<std::size_t>(high.x - low.x + 1); }
  std::size_t rows() const { return static_cast<std::size_t>(high.y - low.y + 1); }
};

PixelBox widened(const PixelBox& box, int px);
PixelBox clippedTo(const MapGeometry& geometry, const PixelBox& box);
PixelBox merged(const PixelBox& a, const PixelBox& b);
/// What lies in both; PixelBox{} if nothing does.
PixelBox common(const PixelBox& a, const PixelBox& b);
inline bool overlap(const PixelBox& a, const PixelBox& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

inline bool holds(const PixelBox& box, Pixel p) {
  return p.x >= box.low.x && p.y >= box.low.y && p.x <= box.high.x && p.y <= box.high.y;
}
/// Position in row-major data of a box's pixels; the box must hold the pixel.
inline std::size_t indexIn(const PixelBox& box, Pixel p) {
  return static_cast<std::size_t>(p.y - box.low.y) * box.columns() +
         static_cast<std::size_t>(p.x - box.low.x);
}
/// Row by row.
template <typename Visit>
void forEachPixel(const PixelBox& box, const Visit& visit) {
  for (int y = box.low.y; y <= box.high.y; ++y) {
    for (int x = box.low.x; x <= box.high.x; ++x) visit(Pixel{x, y});
  }
}

/// The pixels that touch one by their sides.
inline std::array<Pixel, 4> neighbours(Pixel p) {
  return {{{p.x + 1, p.y}, {p.x - 1, p.y}, {p.x, p.y + 1}, {p.x, p.y - 1}}};
}

/// A run of pixel pairs (side by side or one above the other) whose two pixels are free and lie in
/// two nodes: a maximal one, or a part of one that is no longer than asked for.
struct Portal {
  std::array<std::uint32_t, 2> nodes{kNoNode, kNoNode};
  Pixel middle;  ///< a pixel of its middle pair, in nodes[0]
  Pixel beyond;  ///< the other pixel of its middle pair, in nodes[1]
  PixelBox box;  ///< of the pixels of its pairs on both sides
  PixelBox
      border;  ///< of the borders between its pairs, in corners: (x, y) is pixel (x, y)'s lower
  double reach = 0;  ///< no place on those borders is farther from crossing() by path [px]

  /// The middle of the border between the pixels of the middle pair.
  FinePoint crossing() const {
    return {(std::int64_t{middle.x} + beyond.x) * (kFine / 2),
            (std::int64_t{middle.y} + beyond.y) * (kFine / 2)};
  }
  /// Whether a straight line from the border into one of the nodes can lead to a point ...
  bool canLeadTo(FinePoint p, std::uint32_t node) const;
  /// ... or to anywhere on another border.
  bool canLeadToBorder(const Portal& other, std::uint32_t node) const;
  /// Distance of a point to the border's box [px].
  double distanceToBorder(FinePoint p) const;
  /// Between two borders' boxes [px].
  double distanceToBorder(const Portal& other) const;
  bool straight = false;  ///< the border is a straight line, nodes[0] all on its lower side

  /// Paths that cross the border anywhere bend at turning points this near to the nodes [px].
  int turningReach() const { return static_cast<int>(std::ceil(reach)) + 1; }

  std::size_t sideOf(std::uint32_t node) const { return nodes[0] == node ? 0 : 1; }

  std::uint32_t other(std::uint32_t node) const { return nodes[nodes[0] == node ? 1 : 0]; }
};

}  // namespace agrid::planning
