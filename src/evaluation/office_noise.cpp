// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "evaluation/office_drawing.h"

namespace agrid {
namespace {

/// A number in [0, 65535] that depends on place and seed alone, so that it needs no memory.
std::uint32_t hashAt(std::uint32_t seed, int x, int y) {
  std::uint32_t h = seed ^ (static_cast<std::uint32_t>(x) * 0x9e3779b1U);
  h = (h ^ (h >> 15U)) * 0x85ebca6bU;
  h ^= static_cast<std::uint32_t>(y) * 0xc2b2ae35U;
  h = (h ^ (h >> 13U)) * 0x27d4eb2fU;
  return (h ^ (h >> 16U)) & 0xffffU;
}

/// True for about `percent` of 100 places; runs of a few pixels decide alike, as a wall's error
/// does from scan to scan.
bool raggedAt(std::uint32_t seed, int x, int y, std::uint32_t percent) {
  const bool run = hashAt(seed, x / 5, y / 5) < 32768U;
  return hashAt(seed + 1U, x, y) * 100U < (run ? 2U * percent : percent / 4U) * 65536U;
}

/// What lies around a pixel of the drawing.
struct Surroundings {
  int free = 0;
  int occupied = 0;
  int unknown = 0;
};

/// Moves the faces of the walls by a pixel here and there.
class WallRoughener {
 public:
  WallRoughener(Office& office, std::uint32_t seed)
      : office_(office), width_(office.grid.geometry.width), seed_(seed) {}

  void run() {
    const int height = office_.grid.geometry.height;
    std::vector<std::int8_t> below = row(0);
    std::vector<std::int8_t> here = below;
    for (int y = 0; y < height; ++y) {
      const std::vector<std::int8_t> above = row(std::min(y + 1, height - 1));
      for (int x = 1; x + 1 < width_; ++x) {
        const auto i = static_cast<std::size_t>(x);
        Surroundings around;
        for (const std::int8_t value : {below[i], above[i], here[i - 1], here[i + 1]}) {
          around.free += value == kFreeValue;
          around.occupied += value == kOccupiedValue;
          around.unknown += value == kUnknownValue;
        }
        if (around.free == 4 || around.unknown == 4) continue;
        office_.grid.values[office_.grid.geometry.index({x, y})] = rough(here[i], around, x, y);
      }
      below = here;
      here = above;
    }
  }

 private:
  std::vector<std::int8_t> row(int y) const {
    const auto begin = office_.grid.values.begin() +
                       static_cast<std::ptrdiff_t>(office_.grid.geometry.index({0, y}));
    return {begin, begin + width_};
  }

  std::int8_t rough(std::int8_t value, const Surroundings& around, int x, int y) const {
    if (value == kOccupiedValue) {
      // Only faces of walls crumble: furniture legs and door leaves have few neighbours.
      if (around.free == 1 && around.occupied == 3 && raggedAt(seed_, x, y, 12)) return kFreeValue;
      if (around.unknown >= 1 && around.free == 0 && raggedAt(seed_ + 2U, x, y, 45)) {
        return kUnknownValue;
      }
      if (around.occupied == 4 && raggedAt(seed_ + 4U, x, y, 6)) return kUnknownValue;
    }
    if (value == kFreeValue && around.occupied == 1 && around.free == 3) {
      if (raggedAt(seed_ + 6U, x, y, 10)) return kOccupiedValue;
    }
    return value;
  }

  Office& office_;
  int width_;
  std::uint32_t seed_;
};

/// Single obstacles and holes where people walked, well away from walls and doors.
void drawStrayPoints(const OfficeScale& scale, RandomSource& random, Office& office) {
  const MapGeometry& geometry = office.grid.geometry;
  const int reach = scale.pixels(700);
  const double area =
      static_cast<double>(geometry.pixelCount()) * scale.resolution * scale.resolution;
  const auto count = static_cast<int>(area / 12);
  GridCanvas canvas(office.grid);
  for (int i = 0; i < count; ++i) {
    const int x = random.between(reach, geometry.width - 1 - reach);
    const int y = random.between(reach, geometry.height - 1 - reach);
    const bool hole = random.chance(60);
    const int width = random.between(1, 2);
    const auto label = [&](int dx, int dy) {
      return office.rooms[geometry.index({x + dx, y + dy})];
    };
    const std::uint16_t room = label(0, 0);
    const bool open = room != 0 && label(reach, 0) == room && label(-reach, 0) == room &&
                      label(0, reach) == room && label(0, -reach) == room;
    if (open) canvas.fill({{x, y}, {x + width, y + 1}}, hole ? kUnknownValue : kOccupiedValue);
  }
}

/// Whether furniture or shade at a place would stand before a door of the room.
bool beforeDoor(const OfficePlan& plan, const OfficeScale& scale, const PlannedRoom& room,
                const PixelRect& place) {
  return std::any_of(room.doorways.begin(), room.doorways.end(), [&](std::size_t door) {
    return plan.doorways[door].opening.grown(scale.pixels(1000)).overlaps(place);
  });
}

/// Corners that no scan reached.
void drawUnseenCorners(const OfficePlan& plan, const OfficeScale& scale, RandomSource& random,
                       GridCanvas& canvas) {
  for (const PlannedRoom& room : plan.rooms) {
    const bool unseen = random.chance(30) && room.kind != RoomKind::kCorridor;
    const bool left = random.chance(50);
    const bool low = random.chance(50);
    const int width = scale.pixels(random.between(200, 900));
    const int height = scale.pixels(random.between(200, 900));
    const int x0 = left ? room.inside.lo[0] : room.inside.hi[0] - width;
    const int y0 = low ? room.inside.lo[1] : room.inside.hi[1] - height;
    const PixelRect corner{{x0, y0}, {x0 + width, y0 + height}};
    if (!unseen || beforeDoor(plan, scale, room, corner)) continue;
    for (int dy = 0; dy < height; ++dy) {
      for (int dx = 0; dx < width * (height - dy) / height; ++dx) {
        const int x = left ? corner.lo[0] + dx : corner.hi[0] - 1 - dx;
        const int y = low ? corner.lo[1] + dy : corner.hi[1] - 1 - dy;
        if (canvas.at(x, y) == kFreeValue) canvas.set(x, y, kUnknownValue);
      }
    }
  }
}

/// Rays that left the building through the windows of one room.
class WindowRays {
 public:
  WindowRays(const PixelRect& building, const OfficeScale& scale, RandomSource& random,
             GridCanvas& canvas)
      : building_(building), scale_(scale), random_(random), canvas_(canvas) {}

  /// Through the wall at the upper or lower end of an axis, if that is an outer one.
  void draw(const PlannedRoom& room, int axis, bool at_hi) {
    const int beyond =
        at_hi ? room.inside.hi[axis] + scale_.wall() : room.inside.lo[axis] - scale_.wall();
    if (beyond > building_.lo[axis] && beyond < building_.hi[axis]) return;
    const int along = 1 - axis;
    const int face = at_hi ? room.inside.hi[axis] - 1 : room.inside.lo[axis];
    const int step = at_hi ? 1 : -1;
    const int depth = std::max(2, room.inside.length(axis) * random_.between(30, 80) / 100);
    const int center = random_.between(room.inside.lo[along], room.inside.hi[along] - 1);
    const int half = scale_.pixels(random_.between(300, 900));
    const int spacing = random_.between(2, 5);
    const int low = std::max(room.inside.lo[along], center - half);
    const int high = std::min(room.inside.hi[along] - 1, center + half);
    const int eye = random_.between(room.inside.lo[along], room.inside.hi[along] - 1);
    for (int at = low; at <= high; at += spacing) {
      const int length = scale_.pixels(random_.between(400, 5000));
      const bool hit = random_.chance(50);
      drawRay({axis, at, at - eye, depth, face, step, length, hit});
    }
  }

 private:
  struct Ray {
    int axis;
    int at;     ///< where it crosses the wall's inner face
    int slope;  ///< sideways for each `depth` forward
    int depth;
    int face;
    int step;
    int length;
    bool hit;  ///< something stands at its end
  };

  static std::array<int, 2> place(int axis, int forward, int sideways) {
    return axis == 0 ? std::array<int, 2>{forward, sideways}
                     : std::array<int, 2>{sideways, forward};
  }

  void drawRay(const Ray& ray) {
    for (int i = 1; i <= scale_.wall() + ray.length; ++i) {
      const auto [x, y] =
          place(ray.axis, ray.face + ray.step * i, ray.at + ray.slope * i / ray.depth);
      if (!canvas_.contains(x, y)) return;
      const bool in_wall = i <= scale_.wall();
      if (!in_wall && canvas_.at(x, y) != kUnknownValue) return;
      const bool end = i == scale_.wall() + ray.length;
      canvas_.set(x, y, end && ray.hit ? kOccupiedValue : kFreeValue);
    }
  }

  PixelRect building_;
  OfficeScale scale_;
  RandomSource& random_;
  GridCanvas& canvas_;
};

}  // namespace

void drawNoise(const OfficePlan& plan, const OfficeScale& scale, RandomSource& random,
               Office& office) {
  const auto seed = static_cast<std::uint32_t>(random.between(0, 0x3fffffff));
  GridCanvas canvas(office.grid);
  WallRoughener(office, seed).run();
  drawUnseenCorners(plan, scale, random, canvas);
  drawStrayPoints(scale, random, office);
  WindowRays rays(plan.building, scale, random, canvas);
  for (const PlannedRoom& room : plan.rooms) {
    const int axis = random.between(0, 1);
    const bool at_hi = random.chance(50);
    const bool bright = random.chance(50) && room.kind != RoomKind::kCorridor;
    if (bright) rays.draw(room, axis, at_hi);
  }
}

}  // namespace agrid
