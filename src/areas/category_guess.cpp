// SPDX-License-Identifier: BSD-3-Clause
#include "areas/category_guess.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

namespace agrid {
namespace {

// "Measured" is: on the 253 rooms that people drew in ten public floor plans (doc/areas.md).

/// A hallway has 0.91 m or more (International Residential Code R311.6), less what a scanner smears
/// over the walls. Narrower shapes are rays through windows and gaps behind furniture.
constexpr double kMinCorridorWidth = 0.8;  // [m]
/// Measured: corridors are 1.0 to 3.6 m wide.
constexpr double kMaxCorridorWidth = 4.0;   // [m]
constexpr double kMinCorridorLength = 4.0;  // [m]
/// Measured: rooms of more than closet size are up to 3.4 times as long as wide (two of them
/// 4.1 times), corridors 5.8 times and more.
constexpr double kMinElongation = 4.0;
/// A corridor fills that many squares as wide as its widest place (measured: 4.0 and more, most 6
/// to 31; rooms less). What furniture leaves of a room looks long, but its widest place is most of
/// it.
constexpr double kMinSquares = 4.0;
/// A corridor with a wide place fills fewer, but has more doors than a room.
constexpr double kMinSquaresAndDoors = 6.0;

/// The small place that several doors lead to: hallway of a flat, piece of a corridor.
constexpr std::size_t kHallwayDoors = 3;
constexpr double kMinHallwayElongation = 2.0;
constexpr double kMaxHallwayClearance = 1.25;  // [m]

/// Habitable rooms have 70 square feet or more (International Residential Code R304.1).
constexpr double kMaxClosetSize = 6.5;  // [m^2]
/// Measured: offices, laboratories and class rooms have up to 86 m^2, halls 118 m^2 and more.
constexpr double kMinHallSize = 100.0;  // [m^2]

struct Rectangle {
  double width = 0;   ///< the shorter side [m]
  double length = 0;  ///< [m]
};

/// The rectangle with this size and mean clearance; a square if none is as wide. The mean distance
/// of the points of a rectangle a x b, a >= b, from its sides is b / 4 - b^2 / (12 a).
Rectangle equivalentRectangle(double size, double mean_clearance) {
  double low = 0;
  double high = std::sqrt(size);
  constexpr int kSteps = 40;  // halves the width's error each time
  for (int i = 0; i < kSteps; ++i) {
    const double width = (low + high) / 2;
    const double mean = width / 4 - width * width * width / (12 * size);
    (mean < mean_clearance ? low : high) = width;
  }
  return {high, size / high};
}

bool isCorridor(const AreaShape& shape) {
  const Rectangle rectangle = equivalentRectangle(shape.size, shape.mean_clearance);
  const double elongation = rectangle.length / rectangle.width;
  const double squares = shape.size / std::pow(2 * shape.max_clearance, 2);
  const auto doors = static_cast<double>(shape.doors);
  const bool winding = elongation >= kMinElongation && rectangle.length >= kMinCorridorLength &&
                       (squares >= kMinSquares || squares + doors >= kMinSquaresAndDoors);
  const bool hallway = shape.doors >= kHallwayDoors && elongation >= kMinHallwayElongation &&
                       shape.max_clearance <= kMaxHallwayClearance;
  return rectangle.width >= kMinCorridorWidth && rectangle.width <= kMaxCorridorWidth &&
         (hallway || winding);
}

/// Sums over the pixels of an area, from centre to centre.
struct Sums {
  std::size_t pixels = 0;
  double heights = 0;  // [px]
  float highest = 0;   // [px]
};

/// Adds a row of the map, one run of equal labels after another.
void addRow(const std::uint32_t* labels, const float* heights, int width, std::vector<Sums>& sums) {
  for (int x = 0; x < width;) {
    const std::uint32_t label = labels[x];
    const int begin = x;
    double sum = 0;
    float highest = 0;
    for (; x < width && labels[x] == label; ++x) {
      sum += static_cast<double>(heights[x]);
      highest = std::max(highest, heights[x]);
    }
    if (label == AreaLabels::kNone) continue;
    Sums& area = sums[label];
    area.pixels += static_cast<std::size_t>(x - begin);
    area.heights += sum;
    area.highest = std::max(area.highest, highest);
  }
}

std::vector<AreaShape> measureShapes(const AreaLabels& labels, const cv::Mat1f& height,
                                     double resolution) {
  std::vector<Sums> sums(labels.tags.size());
  const std::uint32_t* row = labels.of_pixel.data();
  for (int y = 0; y < height.rows; ++y, row += height.cols) {
    addRow(row, height[y], height.cols, sums);
  }
  std::vector<AreaShape> shapes;
  for (const Sums& area : sums) {
    const auto pixels = static_cast<double>(std::max<std::size_t>(area.pixels, 1));
    // the wall begins half a pixel before the centre of its first pixel
    const auto meters = [&](double px) { return std::max(px - 0.5, 0.0) * resolution; };
    shapes.push_back({pixels * resolution * resolution, meters(area.heights / pixels),
                      meters(static_cast<double>(area.highest)), 0});
  }
  return shapes;
}

}  // namespace

std::string guessCategory(const AreaShape& shape) {
  if (isCorridor(shape)) return "corridor";
  if (shape.size <= kMaxClosetSize) return "closet";
  return shape.size >= kMinHallSize ? "hall" : "room";
}

void guessCategories(const AreaLabels& labels, const Relief& relief, double resolution,
                     const std::vector<Door>& doors, std::vector<Area>& areas) {
  std::map<AreaId, std::size_t> door_count;
  for (const Door& door : doors) {
    for (const AreaId id : door.areas) ++door_count[id];
  }
  const std::vector<AreaShape> shapes = measureShapes(labels, relief.height, resolution);
  for (std::size_t k = 0; k < areas.size(); ++k) {
    AreaShape shape = shapes[k];
    shape.doors = door_count[areas[k].id];
    areas[k].category_guess = guessCategory(shape);
  }
}

}  // namespace agrid
