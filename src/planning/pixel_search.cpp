// SPDX-License-Identifier: BSD-3-Clause
#include "planning/pixel_search.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace agrid::planning {
namespace {

constexpr std::uint32_t kNoRecord = 0xffffffff;

/// A longer straight piece gets a corner, which the tightening removes again: looking back along a
/// wall costs a step for each pixel, for every pixel of the search.
constexpr double kLongestSightPx = 96;

/// What the search knows of a pixel.
struct Record {
  double cost = std::numeric_limits<double>::infinity();
  std::uint32_t parent = kNoRecord;
  bool closed = false;
};

/// Records for the pixels of some nodes only: each node's bounding box, one after the other.
class LeadPixels {
 public:
  LeadPixels(const PortalGraph& graph, const MapGeometry& geometry,
             const std::vector<std::uint32_t>& nodes)
      : graph_(graph), geometry_(geometry), nodes_(nodes), slot_of_(graph.nodeCount(), kNoRecord) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      slot_of_[nodes[i]] = static_cast<std::uint32_t>(i);
      first_.push_back(size);
      size += graph.boxOf(nodes[i]).columns() * graph.boxOf(nodes[i]).rows();
    }
    records_.resize(size);
  }

  std::uint32_t indexOf(Pixel p) const {
    const std::uint32_t node = graph_.nodeAt(geometry_.index(p));
    if (node == kNoNode || slot_of_[node] == kNoRecord) return kNoRecord;
    const PixelBox& box = graph_.boxOf(node);
    return static_cast<std::uint32_t>(first_[slot_of_[node]] +
                                      static_cast<std::size_t>(p.y - box.low.y) * box.columns() +
                                      static_cast<std::size_t>(p.x - box.low.x));
  }
  Pixel pixel(std::uint32_t index) const {
    const auto above = std::upper_bound(first_.begin(), first_.end(), std::size_t{index});
    const auto slot = static_cast<std::size_t>(above - first_.begin()) - 1;
    const PixelBox& box = graph_.boxOf(nodes_[slot]);
    const std::size_t offset = index - first_[slot];
    return {box.low.x + static_cast<int>(offset % box.columns()),
            box.low.y + static_cast<int>(offset / box.columns())};
  }
  Record& operator[](std::uint32_t index) { return records_[index]; }

 private:
  const PortalGraph& graph_;
  const MapGeometry& geometry_;
  const std::vector<std::uint32_t>& nodes_;
  std::vector<std::uint32_t> slot_of_;
  std::vector<std::size_t> first_;
  std::vector<Record> records_;
};

struct Entry {
  double estimate;
  std::uint32_t index;
  bool operator<(const Entry& other) const {
    return estimate != other.estimate ? estimate > other.estimate : index > other.index;
  }
};

class LazyThetaStar {
 public:
  LazyThetaStar(const SearchSpace& space, const Lead& lead, FinePoint start, const Target& target)
      : space_(space),
        pixels_(*space.graph, space.free->geometry(), lead.nodes),
        start_(start),
        target_(target),
        start_index_(pixels_.indexOf(start.pixel())),
        goal_index_(target.point ? pixels_.indexOf(target.point->pixel()) : kNoRecord) {}

  std::vector<FinePoint> run(const StopCheck& stop) {
    pixels_[start_index_].cost = 0;
    pixels_[start_index_].parent = start_index_;
    open_.push({target_.distanceFrom(start_), start_index_});
    for (std::size_t i = 0; !open_.empty(); ++i) {
      if (i % 256 == 0) stop.check();
      const Entry entry = open_.top();
      open_.pop();
      const std::uint32_t s = entry.index;
      if (pixels_[s].closed) continue;
      const Pixel p = pixels_.pixel(s);
      chooseVisibleParent(s, p);
      pixels_[s].closed = true;
      if (isGoal(s, p)) return pathTo(s);
      expand(s, p);
    }
    return {};
  }

 private:
  FinePoint place(std::uint32_t index) const {
    if (index == start_index_) return start_;
    if (index == goal_index_) return *target_.point;
    return centerOf(pixels_.pixel(index));
  }
  FinePoint place(std::uint32_t index, Pixel p) const {
    if (index == start_index_) return start_;
    if (index == goal_index_) return *target_.point;
    return centerOf(p);
  }
  bool isGoal(std::uint32_t index, Pixel p) const {
    if (target_.point) return index == goal_index_;
    return (*space_.pixel_labels)[space_.free->geometry().index(p)] == target_.label;
  }

  template <typename Visit>
  void forEachNeighbour(Pixel p, const Visit& visit) const {
    const FreeSpace& free = *space_.free;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (dx == 0 && dy == 0) continue;
        const Pixel q{p.x + dx, p.y + dy};
        const std::uint32_t index = pixels_.indexOf(q);
        if (index == kNoRecord) continue;
        if (dx != 0 && dy != 0 && !(free.isFree({q.x, p.y}) && free.isFree({p.x, q.y}))) continue;
        visit(index, q);
      }
    }
  }

  void chooseVisibleParent(std::uint32_t s, Pixel p) {
    Record& record = pixels_[s];
    const FinePoint here = place(s, p);
    // From here backwards: what hides the parent is usually the corner just passed.
    const FinePoint parent = place(record.parent);
    if (distancePx(parent, here) < kLongestSightPx && space_.free->canSee(here, parent)) return;
    record.cost = std::numeric_limits<double>::infinity();
    forEachNeighbour(p, [&](std::uint32_t n, Pixel q) {
      if (!pixels_[n].closed) return;
      const double cost = pixels_[n].cost + distancePx(place(n, q), here);
      if (cost < record.cost) {
        record.cost = cost;
        record.parent = n;
      }
    });
  }

  void expand(std::uint32_t s, Pixel p) {
    const std::uint32_t parent = pixels_[s].parent;
    const FinePoint from = place(parent);
    const double cost_from = pixels_[parent].cost;
    forEachNeighbour(p, [&](std::uint32_t n, Pixel q) {
      Record& next = pixels_[n];
      if (next.closed) return;
      const FinePoint there = place(n, q);
      const double cost = cost_from + distancePx(from, there);
      if (!(cost < next.cost)) return;
      next.cost = cost;
      next.parent = parent;
      open_.push({cost + target_.distanceFrom(there), n});
    });
  }

  std::vector<FinePoint> pathTo(std::uint32_t s) {
    std::vector<FinePoint> path{place(s)};
    while (s != start_index_) {
      s = pixels_[s].parent;
      path.push_back(place(s));
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  const SearchSpace& space_;
  LeadPixels pixels_;
  FinePoint start_;
  const Target& target_;
  std::uint32_t start_index_;
  std::uint32_t goal_index_;
  std::priority_queue<Entry> open_;
};

}  // namespace

std::vector<FinePoint> searchPixels(const SearchSpace& space, const Lead& lead, FinePoint start,
                                    const Target& target, const StopCheck& stop) {
  return LazyThetaStar(space, lead, start, target).run(stop);
}

}  // namespace agrid::planning
