// SPDX-License-Identifier: BSD-3-Clause
#include "exchange/faces.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>

#include "tags/pixel_runs.h"

namespace agrid {
namespace {

/// Walks along the sides of a shape's pixels.
class SideWalk {
 public:
  explicit SideWalk(const cv::Mat1b& shape)
      : shape_(shape), bounds_(0, 0, shape.cols, shape.rows), walked_(shape.size(), 0) {}

  /// Whether the lower side of a pixel of the shape is a border that no walk has passed.
  bool isNew(const cv::Point& pixel) const {
    return walked_(pixel) == 0 && !inside({pixel.x, pixel.y - 1});
  }

  /// Walks with the part on the left, from corner to corner, back to where it began. Where two
  /// pixels of the shape meet in a corner only it turns left, never from one to the other.
  PixelRing around(const cv::Point& pixel) {
    PixelRing corners;
    cv::Point vertex = pixel;
    std::size_t heading = 0;
    do {
      if (heading == 0) walked_(vertex) = 1;
      vertex += kSteps[heading];
      std::size_t turned = heading;
      if (!inside(vertex + kLeft[heading])) {
        turned = (heading + 1) % 4;
      } else if (inside(vertex + kLeft[(heading + 3) % 4])) {
        turned = (heading + 3) % 4;
      }
      if (turned != heading) corners.push_back(vertex);
      heading = turned;
    } while (vertex != pixel || heading != 0);
    return corners;
  }

 private:
  bool inside(const cv::Point& p) const { return bounds_.contains(p) && shape_(p) != 0; }

  inline static const std::array<cv::Point, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  // pixel ahead on the left of a vertex, for each heading; the one on the right is the next
  // heading's
  inline static const std::array<cv::Point, 4> kLeft{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};

  const cv::Mat1b& shape_;
  cv::Rect bounds_;
  cv::Mat1b walked_;  ///< 1: a walk passed the lower side of the pixel
};

/// Cuts a closed walk where it comes back to a corner, so that no ring meets itself.
std::vector<PixelRing> simpleRings(const PixelRing& walk) {
  std::vector<PixelRing> rings;
  PixelRing open;
  std::map<std::pair<int, int>, std::size_t> place;  // of corners in `open`
  for (const cv::Point& corner : walk) {
    const auto [found, is_new] = place.emplace(std::pair(corner.x, corner.y), open.size());
    if (!is_new) {
      const auto begin = open.begin() + static_cast<std::ptrdiff_t>(found->second);
      PixelRing& ring = rings.emplace_back(begin, open.end());
      for (std::size_t i = 1; i < ring.size(); ++i) place.erase({ring[i].x, ring[i].y});
      open.erase(begin + 1, open.end());
    } else {
      open.push_back(corner);
    }
  }
  rings.push_back(std::move(open));
  return rings;
}

bool isCounterClockwise(const PixelRing& ring) {
  std::int64_t area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const cv::Point& a = ring[i];
    const cv::Point& b = ring[(i + 1) % ring.size()];
    area += std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y;
  }
  return area > 0;
}

std::vector<cv::Rect> boxesOf(const AreaMap& areas, const MapGeometry& geometry) {
  std::vector<cv::Rect> boxes(areas.areas.size());
  std::vector<std::uint16_t> row;
  for (int y = 0; y < geometry.height; ++y) {
    areas.pixel_labels.copy(geometry.index({0, y}), static_cast<std::size_t>(geometry.width), row);
    forEachRun(row.data(), geometry.width, [&](int begin, int end, std::uint16_t label) {
      if (label != 0) boxes[label - 1U] |= cv::Rect(begin, y, end - begin, 1);
    });
  }
  return boxes;
}

}  // namespace

std::vector<Face> facesOf(const cv::Mat1b& shape, const cv::Point& origin) {
  const std::vector<PixelRun> runs = findRuns(shape, 1);
  const std::vector<std::uint32_t> part_of = connectRuns(runs, false);
  std::vector<Face> faces(part_of.empty() ? 0
                                          : *std::max_element(part_of.begin(), part_of.end()) + 1U);
  SideWalk sides(shape);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (int x = runs[i].begin; x < runs[i].end; ++x) {
      if (!sides.isNew({x, runs[i].y})) continue;
      for (PixelRing& ring : simpleRings(sides.around({x, runs[i].y}))) {
        const bool is_outer = isCounterClockwise(ring);
        for (cv::Point& corner : ring) corner += origin;
        Face& face = faces[part_of[i]];
        if (is_outer) {
          face.outer = std::move(ring);
        } else {
          face.holes.push_back(std::move(ring));
        }
      }
    }
  }
  return faces;
}

std::vector<std::vector<Face>> areaFaces(const SemanticMap& map) {
  const MapGeometry& geometry = map.map().geometry();
  const std::vector<cv::Rect> boxes = boxesOf(map.area_map, geometry);
  std::vector<std::vector<Face>> faces(boxes.size());
  std::vector<std::uint16_t> row;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const cv::Rect& box = boxes[k];
    cv::Mat1b shape(box.size());
    for (int y = 0; y < box.height; ++y) {
      map.area_map.pixel_labels.copy(geometry.index({box.x, box.y + y}),
                                     static_cast<std::size_t>(box.width), row);
      std::transform(row.begin(), row.end(), shape.ptr(y), [&](std::uint16_t label) {
        return static_cast<std::uint8_t>(label == k + 1);
      });
    }
    faces[k] = facesOf(shape, box.tl());
  }
  return faces;
}

Polygon mapPolygon(const PixelRing& ring, const MapGeometry& geometry) {
  Polygon polygon;
  polygon.reserve(ring.size());
  for (const cv::Point& corner : ring) {
    polygon.push_back(geometry.map_from_image *
                      Point2(corner.x * geometry.resolution, corner.y * geometry.resolution));
  }
  return polygon;
}

}  // namespace agrid
