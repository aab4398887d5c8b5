// SPDX-License-Identifier: BSD-3-Clause
#include "planning/obstacle_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace agrid::planning {
namespace {

/// Around a door's pixels its distances are first looked at so far [px].
constexpr int kFirstReach = 24;

}  // namespace

ObstacleField::ObstacleField(const MapGeometry& geometry, const Obstacles& obstacles)
    : geometry_(geometry),
      clearance_(obstacles.clearance()),
      open_(std::make_shared<const SquaredDistances>(
          distancesToMarked(geometry, obstacles.openMask(), clearance_))),
      distances_(open_) {}

std::shared_ptr<const ObstacleField> ObstacleField::closedAs(
    const std::shared_ptr<const ObstacleField>& former, const Obstacles& obstacles) {
  const std::vector<std::vector<std::size_t>>& wanted = obstacles.closedDoors();
  const std::vector<ClosedDoor>& closed = former->closed_;
  const auto isDoor = [](const ClosedDoor& door, const std::vector<std::size_t>& pixels) {
    return door.pixels == pixels;
  };
  if (std::equal(closed.begin(), closed.end(), wanted.begin(), wanted.end(), isDoor)) return former;
  auto field = std::make_shared<ObstacleField>(*former);
  field->changing_ = std::make_shared<SquaredDistances>(*former->distances_);
  for (const ClosedDoor& door : closed) {
    if (!std::binary_search(wanted.begin(), wanted.end(), door.pixels)) field->open(door);
  }
  for (const std::vector<std::size_t>& pixels : wanted) {
    if (std::none_of(closed.begin(), closed.end(),
                     [&](const ClosedDoor& door) { return isDoor(door, pixels); })) {
      field->close({pixels, {}, {}});
    }
  }
  field->distances_ = std::move(field->changing_);
  std::sort(field->closed_.begin(), field->closed_.end(), isBefore);
  return field;
}

std::vector<PixelBox> ObstacleField::changedBoxes(const ObstacleField& other) const {
  std::vector<PixelBox> boxes;
  for (const auto& [some, others] :
       {std::pair{&closed_, &other.closed_}, {&other.closed_, &closed_}}) {
    for (const ClosedDoor& door : *some) {
      const bool in_both = std::binary_search(
          others->begin(), others->end(), door,
          [](const ClosedDoor& a, const ClosedDoor& b) { return a.pixels < b.pixels; });
      if (!in_both) boxes.push_back(door.box);
    }
  }
  return boxes;
}

std::vector<std::int32_t> ObstacleField::distancesTo(const ClosedDoor& door,
                                                     const PixelBox& window) const {
  const PixelBox local = merged(window, clippedTo(geometry_, widened(door.box, 1)));
  MapGeometry part = geometry_;
  part.width = static_cast<int>(local.columns());
  part.height = static_cast<int>(local.rows());
  std::vector<std::uint8_t> marked(part.pixelCount());
  for (const std::size_t i : door.pixels) {
    const Pixel p = geometry_.pixel(i);
    marked[part.index({p.x - local.low.x, p.y - local.low.y})] = 1;
  }
  const std::vector<std::int32_t> all = distancesToMarked(part, std::move(marked), clearance_);
  std::vector<std::int32_t> squared;
  for (int y = window.low.y; y <= window.high.y; ++y) {
    const auto row = all.begin() + static_cast<std::ptrdiff_t>(
                                       part.index({window.low.x - local.low.x, y - local.low.y}));
    squared.insert(squared.end(), row, row + static_cast<std::ptrdiff_t>(window.columns()));
  }
  return squared;
}

/// The pixels nearest to one of two sets form stars around its pixels: what reaches beyond the
/// window passes its outermost pixels, at most half a pixel beside the centre of one.
bool ObstacleField::endsWithin(const PixelBox& window,
                               const std::vector<std::int32_t>& squared) const {
  std::size_t k = 0;
  for (int y = window.low.y; y <= window.high.y; ++y) {
    for (int x = window.low.x; x <= window.high.x; ++x, ++k) {
      const bool last = (x == window.low.x && x > 0) || (y == window.low.y && y > 0) ||
                        (x == window.high.x && x + 1 < geometry_.width) ||
                        (y == window.high.y && y + 1 < geometry_.height);
      if (!last) continue;
      if (std::sqrt(squared[k]) <= std::sqrt((*open_)[geometry_.index({x, y})]) + 1.01)
        return false;
    }
  }
  return true;
}

void ObstacleField::close(ClosedDoor door) {
  for (const std::size_t i : door.pixels) door.box.add(geometry_.pixel(i));
  std::vector<std::int32_t> squared;
  for (int reach = kFirstReach;; reach *= 2) {
    door.reach = clippedTo(geometry_, widened(door.box, reach));
    squared = distancesTo(door, door.reach);
    if (endsWithin(door.reach, squared)) break;
  }
  write(door.reach, squared);
  closed_.push_back(std::move(door));
}

/// What is left are the map's own obstacles, and the other doors that are near enough.
void ObstacleField::open(const ClosedDoor& door) {
  closed_.erase(std::remove_if(closed_.begin(), closed_.end(),
                               [&](const ClosedDoor& d) { return d.pixels == door.pixels; }),
                closed_.end());
  const PixelBox& window = door.reach;
  for (int y = window.low.y; y <= window.high.y; ++y) {
    std::vector<std::int32_t> row;
    for (int x = window.low.x; x <= window.high.x; ++x)
      row.push_back((*open_)[geometry_.index({x, y})]);
    changing_->assign(geometry_.index({window.low.x, y}), row);
  }
  for (const ClosedDoor& other : closed_) {
    const PixelBox both = common(window, other.reach);
    if (both.high.x >= 0) write(both, distancesTo(other, both));
  }
}

void ObstacleField::write(const PixelBox& window, const std::vector<std::int32_t>& squared) {
  std::size_t k = 0;
  for (int y = window.low.y; y <= window.high.y; ++y) {
    std::vector<std::int32_t> row;
    bool changes = false;
    for (int x = window.low.x; x <= window.high.x; ++x, ++k) {
      const std::int32_t now = (*changing_)[geometry_.index({x, y})];
      changes = changes || squared[k] < now;
      row.push_back(std::min(squared[k], now));
    }
    if (changes) changing_->assign(geometry_.index({window.low.x, y}), row);
  }
}

}  // namespace agrid::planning
