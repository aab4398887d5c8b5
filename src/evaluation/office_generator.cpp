// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/evaluation/office_generator.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "evaluation/office_drawing.h"

namespace agrid {
namespace {

void check(const char* field, double value, double low, double high) {
  if (value >= low && value <= high) return;
  std::ostringstream message;
  message << "OfficeParams." << field << " is " << value << ", not within [" << low << ", " << high
          << "]";
  throw std::invalid_argument(message.str());
}

void checkParams(const OfficeParams& params) {
  check("size", params.size, 100, 20000);
  check("resolution", params.resolution, 0.02, 0.2);
  check("size * resolution", params.size * params.resolution, 5, 1000);
}

Office emptyOffice(const OfficeParams& params) {
  Office office;
  // Origins of recorded maps are seldom zero; whole metres keep the numbers readable.
  const double origin = -std::floor(params.size * params.resolution / 3);
  office.grid.geometry = {params.size, params.size, params.resolution, {{origin, origin}, 0}};
  office.grid.values.assign(office.grid.geometry.pixelCount(), kUnknownValue);
  office.rooms.assign(office.grid.geometry.pixelCount(), 0);
  return office;
}

void labelRooms(const PixelRect& rect, std::uint16_t label, Office& office) {
  for (int y = rect.lo[1]; y < rect.hi[1]; ++y) {
    const auto row = office.rooms.begin() +
                     static_cast<std::ptrdiff_t>(office.grid.geometry.index({rect.lo[0], y}));
    std::fill(row, row + rect.length(0), label);
  }
}

/// From jamb to jamb along the middle of the wall.
Segment jambs(const Doorway& door, const MapGeometry& geometry) {
  const int along = 1 - door.axis;
  Point2 a;
  a[door.axis] = (door.opening.lo[door.axis] + door.opening.hi[door.axis]) / 2.0;
  Point2 b = a;
  a[along] = door.opening.lo[along];
  b[along] = door.opening.hi[along];
  return {geometry.map_from_image * Point2(a * geometry.resolution),
          geometry.map_from_image * Point2(b * geometry.resolution)};
}

/// A shut door stands in the middle of its wall, thinner than it.
void drawShutDoor(const Doorway& door, GridCanvas& canvas) {
  const int depth = door.opening.length(door.axis);
  if (depth < 3) return;
  canvas.fill(door.opening, kFreeValue);
  PixelRect leaf = door.opening;
  leaf.lo[door.axis] += depth / 2;
  leaf.hi[door.axis] = leaf.lo[door.axis] + 1;
  canvas.fill(leaf, kOccupiedValue);
}

void drawPlan(const OfficePlan& plan, const OfficeScale& scale, Office& office) {
  GridCanvas canvas(office.grid);
  for (const PlannedRoom& room : plan.rooms) {
    canvas.frame(room.inside.grown(scale.wall()), scale.wall(), kOccupiedValue);
    canvas.fill(room.inside, kFreeValue);
    labelRooms(room.inside, room.label, office);
  }
  for (const Junction& junction : plan.junctions) {
    canvas.fill(junction.opening, kFreeValue);
    labelRooms(junction.opening, plan.rooms[junction.room].label, office);
  }
  for (const Doorway& door : plan.doorways) {
    if (door.shut) {
      drawShutDoor(door, canvas);
      office.shut_doors_map.push_back(jambs(door, office.grid.geometry));
    } else {
      canvas.fill(door.opening, kFreeValue);
      office.doors_map.push_back(jambs(door, office.grid.geometry));
    }
  }
}

}  // namespace

void GridCanvas::fill(const PixelRect& rect, std::int8_t value) {
  const int width = grid_.geometry.width;
  const int height = grid_.geometry.height;
  const int x0 = std::clamp(rect.lo[0], 0, width);
  const int x1 = std::clamp(rect.hi[0], x0, width);
  for (int y = std::max(0, rect.lo[1]); y < std::min(height, rect.hi[1]); ++y) {
    const auto row =
        grid_.values.begin() + static_cast<std::ptrdiff_t>(grid_.geometry.index({0, y}));
    std::fill(row + x0, row + x1, value);
  }
}

void GridCanvas::frame(const PixelRect& rect, int thickness, std::int8_t value) {
  fill({rect.lo, {rect.hi[0], rect.lo[1] + thickness}}, value);
  fill({{rect.lo[0], rect.hi[1] - thickness}, rect.hi}, value);
  fill({rect.lo, {rect.lo[0] + thickness, rect.hi[1]}}, value);
  fill({{rect.hi[0] - thickness, rect.lo[1]}, rect.hi}, value);
}

Office generateOffice(const OfficeParams& params) {
  checkParams(params);
  const OfficeScale scale{params.resolution};
  RandomSource layout_random(params.seed);
  const OfficePlan plan = planOffice(params.size, scale, layout_random);
  Office office = emptyOffice(params);
  drawPlan(plan, scale, office);
  // Sources of their own: the same building with and without furniture and noise.
  RandomSource furniture_random(params.seed ^ 0x46555255U);
  RandomSource noise_random(params.seed ^ 0x4e4f4953U);
  GridCanvas canvas(office.grid);
  if (params.furniture) drawFurniture(plan, scale, furniture_random, canvas);
  if (params.noise) drawNoise(plan, scale, noise_random, office);
  return office;
}

}  // namespace agrid
