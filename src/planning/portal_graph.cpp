// SPDX-License-Identifier: BSD-3-Clause
#include "planning/portal_graph.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace agrid::planning {
namespace {

/// A pair of neighbouring pixels in two nodes: side by side, or one above the other.
struct Pair {
  Pixel low;
  Pixel high;
  std::uint32_t a;
  std::uint32_t b;
};

/// The border between a pair's pixels, or those of a run, as a box on the pixels' corners: corner
/// (x, y) lies below and to the left of pixel (x, y).
PixelBox borderOf(const Pair& pair) {
  PixelBox box;
  box.add(pair.high);
  box.add(pair.low.y == pair.high.y ? Pixel{pair.high.x, pair.high.y + 1}
                                    : Pixel{pair.high.x + 1, pair.high.y});
  return box;
}

PixelBox merged(PixelBox a, const PixelBox& b) {
  a.add(b.low);
  a.add(b.high);
  return a;
}

int sideOf(const PixelBox& box) { return std::max(box.high.x - box.low.x, box.high.y - box.low.y); }

bool touch(const PixelBox& a, const PixelBox& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// Sets of pairs, with the box around each set's borders.
class Runs {
 public:
  explicit Runs(const std::vector<Pair>& pairs) : sets_(pairs.size()) {
    for (const Pair& pair : pairs) borders_.push_back(borderOf(pair));
  }
  /// Joins the runs of two pairs unless the joint run would be longer or wider.
  void join(std::uint32_t a, std::uint32_t b, int longest) {
    a = sets_.find(a);
    b = sets_.find(b);
    if (a == b) return;
    const PixelBox box = merged(borders_[a], borders_[b]);
    if (sideOf(box) > longest) return;
    sets_.unite(a, b);
    borders_[a] = box;
  }
  const PixelBox& borderOfRun(std::uint32_t pair) { return borders_[sets_.find(pair)]; }
  std::vector<std::uint32_t> numbers() { return sets_.numbers(); }

 private:
  DisjointSets sets_;
  std::vector<PixelBox> borders_;  ///< of the sets, by their names
};

/// Collects pairs, and which of the same two nodes lie next to each other, row by row.
class RunBuilder {
 public:
  explicit RunBuilder(std::size_t width)
      : rows_{std::vector<Slot>(width + 2), std::vector<Slot>(width + 2)} {}

  void nextRow() {
    std::swap(rows_[0], rows_[1]);
    std::fill(rows_[1].begin(), rows_[1].end(), Slot{});
  }
  /// @param upwards  whether b lies above a, else beside it
  void add(Pixel p, bool upwards, std::uint32_t a, std::uint32_t b) {
    const auto added = static_cast<std::uint32_t>(pairs_.size());
    const auto x = static_cast<std::size_t>(p.x) + 1;
    for (const Slot* slot :
         {&rows_[0][x - 1], &rows_[0][x], &rows_[0][x + 1], &rows_[1][x - 1], &rows_[1][x]}) {
      for (const std::uint32_t pair : slot->pairs) {
        if (pair != kNoNode && sameNodes(pairs_[pair], a, b)) links_.push_back({pair, added});
      }
    }
    rows_[1][x].pairs[upwards ? 1 : 0] = added;
    pairs_.push_back({p, upwards ? Pixel{p.x, p.y + 1} : Pixel{p.x + 1, p.y}, a, b});
  }
  std::vector<Portal> portals(PortalCut cut) const;

 private:
  struct Slot {
    std::array<std::uint32_t, 2> pairs{kNoNode, kNoNode};
  };
  static bool sameNodes(const Pair& pair, std::uint32_t a, std::uint32_t b) {
    return (pair.a == a && pair.b == b) || (pair.a == b && pair.b == a);
  }
  Runs wholeRuns() const;
  Runs parts() const;

  std::array<std::vector<Slot>, 2> rows_;
  std::vector<Pair> pairs_;
  std::vector<std::array<std::uint32_t, 2>> links_;
};

Runs RunBuilder::wholeRuns() const {
  Runs runs(pairs_);
  for (const auto& link : links_) runs.join(link[0], link[1], 0x7fffffff);
  return runs;
}

/// Short enough for the least lengths over a portal's border to be near the true ones, and few
/// enough for what is stored between them.
Runs RunBuilder::parts() const {
  constexpr int kShortest = 3;
  constexpr int kLongest = 12;
  constexpr int kParts = 16;
  Runs whole = wholeRuns();
  Runs parts(pairs_);
  for (const auto& link : links_) {
    if (!touch(borderOf(pairs_[link[0]]), borderOf(pairs_[link[1]]))) continue;
    const int side = sideOf(whole.borderOfRun(link[0]));
    parts.join(link[0], link[1], std::clamp((side + kParts - 1) / kParts, kShortest, kLongest));
  }
  return parts;
}

/// How far along a run's border its farthest end lies from `portal.crossing()`. A run that rises or
/// falls all along is as long as its box is wide and high; of any other only its length is known.
double reachOf(const Portal& portal, std::uint32_t pair_count) {
  const PixelBox& border = portal.border;
  const int extent = border.high.x - border.low.x + border.high.y - border.low.y;
  if (static_cast<std::uint32_t>(extent) != pair_count) return pair_count - 0.5;
  const Point2 from = coordinates(portal.crossing()) + Point2(0.5, 0.5);
  double reach = 0;
  for (const Pixel corner : {border.low, border.high, Pixel{border.low.x, border.high.y},
                             Pixel{border.high.x, border.low.y}}) {
    reach = std::max(reach, (Point2(corner.x, corner.y) - from).lpNorm<1>());
  }
  return std::min(reach, pair_count - 0.5);
}

std::vector<Portal> RunBuilder::portals(PortalCut cut) const {
  Runs runs = cut == PortalCut::kWholeRuns ? wholeRuns() : parts();
  const std::vector<std::uint32_t> number = runs.numbers();
  std::vector<std::uint32_t> pair_count(number.size());
  for (const std::uint32_t run : number) ++pair_count[run];
  std::vector<Portal> portals;
  std::vector<std::uint32_t> seen;
  std::vector<std::uint32_t> first_low;
  for (std::uint32_t k = 0; k < pairs_.size(); ++k) {
    const Pair& pair = pairs_[k];
    const std::uint32_t i = number[k];
    if (i >= portals.size()) {
      portals.resize(i + 1);
      seen.resize(i + 1);
      first_low.resize(i + 1, pair.a);
      portals[i].border = runs.borderOfRun(k);
      portals[i].straight = portals[i].border.low.x == portals[i].border.high.x ||
                            portals[i].border.low.y == portals[i].border.high.y;
    }
    Portal& portal = portals[i];
    portal.straight = portal.straight && pair.a == first_low[i];
    portal.box.add(pair.low);
    portal.box.add(pair.high);
    if (seen[i]++ != pair_count[i] / 2) continue;
    portal.middle = pair.low;
    portal.beyond = pair.high;
    portal.nodes = {pair.a, pair.b};
    portal.reach = reachOf(portal, pair_count[i]);
  }
  return portals;
}

double gap(double low_a, double high_a, double low_b, double high_b) {
  return std::max({0.0, low_b - high_a, low_a - high_b});
}

}  // namespace

bool Portal::canLeadTo(FinePoint p, std::uint32_t node) const {
  if (!straight) return true;
  const bool upright = border.low.x == border.high.x;
  const std::int64_t across = upright ? p.x - crossing().x : p.y - crossing().y;
  return sideOf(node) == 0 ? across <= 0 : across >= 0;
}

bool Portal::canLeadToBorder(const Portal& other, std::uint32_t node) const {
  const auto corner = [](int x, int y) {
    return FinePoint{x * kFine - kFine / 2, y * kFine - kFine / 2};
  };
  const PixelBox& b = other.border;
  return canLeadTo(corner(b.low.x, b.low.y), node) || canLeadTo(corner(b.high.x, b.high.y), node);
}

double Portal::distanceToBorder(FinePoint p) const {
  const Point2 from = coordinates(p) + Point2(0.5, 0.5);
  return std::hypot(gap(border.low.x, border.high.x, from.x(), from.x()),
                    gap(border.low.y, border.high.y, from.y(), from.y()));
}

double Portal::distanceToBorder(const Portal& other) const {
  return std::hypot(gap(border.low.x, border.high.x, other.border.low.x, other.border.high.x),
                    gap(border.low.y, border.high.y, other.border.low.y, other.border.high.y));
}

void PixelBox::add(Pixel p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y)};
}

PortalGraph::PortalGraph(const FreeSpace& free, const ClassesOfRow& classes_of_row,
                         const StopCheck& stop, PortalCut cut)
    : node_at_(free.geometry().pixelCount(), kNoNode) {
  labelNodes(free, classes_of_row, stop);
  findPortals(free.geometry(), stop, cut);
  joinComponents();
  listPortals();
}

void PortalGraph::labelNodes(const FreeSpace& free, const ClassesOfRow& classes_of_row,
                             const StopCheck& stop) {
  const MapGeometry& geometry = free.geometry();
  const auto width = static_cast<std::size_t>(geometry.width);
  DisjointSets sets;
  std::vector<std::uint32_t> class_of_set;
  std::vector<std::uint32_t> here(width);
  std::vector<std::uint32_t> below(width);
  for (int y = 1; y + 1 < geometry.height; ++y) {
    if (y % 64 == 0) stop.check();
    std::swap(here, below);
    classes_of_row(y, here);
    // Free pixels never lie on the outermost ring, so that each has all four neighbours.
    for (std::size_t x = 1; x + 1 < width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * width + x;
      if (!free.isFree({static_cast<int>(x), y})) continue;
      const std::uint32_t from_left = here[x - 1] == here[x] ? node_at_[i - 1] : kNoNode;
      const std::uint32_t from_below = below[x] == here[x] ? node_at_[i - width] : kNoNode;
      node_at_[i] = from_left != kNoNode ? from_left : from_below;
      if (from_left != kNoNode && from_below != kNoNode) sets.unite(from_left, from_below);
      if (node_at_[i] != kNoNode) continue;
      node_at_[i] = sets.add();
      class_of_set.push_back(here[x]);
    }
  }
  numberNodes(geometry, sets, class_of_set);
}

void PortalGraph::numberNodes(const MapGeometry& geometry, DisjointSets& sets,
                              const std::vector<std::uint32_t>& class_of_set) {
  const std::vector<std::uint32_t> number = sets.numbers();
  std::size_t count = 0;
  for (const std::uint32_t n : number) count = std::max<std::size_t>(count, n + std::size_t{1});
  class_of_.resize(count);
  box_of_.resize(count);
  for (std::size_t set = 0; set < number.size(); ++set) class_of_[number[set]] = class_of_set[set];
  const auto width = static_cast<std::size_t>(geometry.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(geometry.height); ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      std::uint32_t& node = node_at_[y * width + x];
      if (node == kNoNode) continue;
      node = number[node];
      box_of_[node].add({static_cast<int>(x), static_cast<int>(y)});
    }
  }
}

void PortalGraph::findPortals(const MapGeometry& geometry, const StopCheck& stop, PortalCut cut) {
  const auto width = static_cast<std::size_t>(geometry.width);
  RunBuilder runs(width);
  for (int y = 1; y + 1 < geometry.height; ++y) {
    if (y % 64 == 0) stop.check();
    runs.nextRow();
    for (int x = 1; x + 1 < geometry.width; ++x) {
      const std::size_t i = geometry.index({x, y});
      const std::uint32_t node = node_at_[i];
      if (node == kNoNode) continue;
      const std::uint32_t right = node_at_[i + 1];
      const std::uint32_t above = node_at_[i + width];
      if (right != kNoNode && right != node) runs.add({x, y}, false, node, right);
      if (above != kNoNode && above != node) runs.add({x, y}, true, node, above);
    }
  }
  portals_ = runs.portals(cut);
}

void PortalGraph::joinComponents() {
  DisjointSets sets;
  for (std::size_t i = 0; i < nodeCount(); ++i) sets.add();
  for (const Portal& portal : portals_) sets.unite(portal.nodes[0], portal.nodes[1]);
  component_of_ = sets.numbers();
}

void PortalGraph::listPortals() {
  portals_from_.assign(nodeCount() + 1, 0);
  for (const Portal& portal : portals_) {
    for (const std::uint32_t node : portal.nodes) ++portals_from_[node + 1];
  }
  for (std::size_t i = 1; i < portals_from_.size(); ++i) portals_from_[i] += portals_from_[i - 1];
  portals_of_.resize(2 * portals_.size());
  std::vector<std::uint32_t> next(portals_from_.begin(), portals_from_.end() - 1);
  for (std::uint32_t p = 0; p < portals_.size(); ++p) {
    for (const std::uint32_t node : portals_[p].nodes) portals_of_[next[node]++] = p;
  }
}

}  // namespace agrid::planning
