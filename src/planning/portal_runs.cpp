// SPDX-License-Identifier: BSD-3-Clause
#include "planning/portal_runs.h"

#include <algorithm>

#include "tags/disjoint_sets.h"

namespace agrid::planning {
namespace {

using Links = std::vector<std::array<std::uint32_t, 2>>;

/// The border between a pair's pixels, or those of a run, as a box on the pixels' corners: corner
/// (x, y) lies below and to the left of pixel (x, y).
PixelBox borderOf(const PixelPair& pair) {
  PixelBox box;
  box.add(pair.high);
  box.add(pair.low.y == pair.high.y ? Pixel{pair.high.x, pair.high.y + 1}
                                    : Pixel{pair.high.x + 1, pair.high.y});
  return box;
}

int sideOf(const PixelBox& box) { return std::max(box.high.x - box.low.x, box.high.y - box.low.y); }

/// Sets of pairs, with the box around each set's borders.
class Runs {
 public:
  explicit Runs(const std::vector<PixelPair>& pairs) : sets_(pairs.size()) {
    for (const PixelPair& pair : pairs) borders_.push_back(borderOf(pair));
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

Runs wholeRuns(const std::vector<PixelPair>& pairs, const Links& links) {
  Runs runs(pairs);
  for (const auto& link : links) runs.join(link[0], link[1], 0x7fffffff);
  return runs;
}

/// Short enough for the least lengths over a portal's border to be near the true ones, and few
/// enough for what is stored between them.
Runs partsOfRuns(const std::vector<PixelPair>& pairs, const Links& links) {
  constexpr int kShortest = 3;
  constexpr int kLongest = 12;
  constexpr int kParts = 16;
  Runs whole = wholeRuns(pairs, links);
  Runs parts(pairs);
  for (const auto& link : links) {
    if (!overlap(borderOf(pairs[link[0]]), borderOf(pairs[link[1]]))) continue;
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

}  // namespace

std::vector<Portal> PortalRuns::portals(PortalCut cut) const {
  Runs runs =
      cut == PortalCut::kWholeRuns ? wholeRuns(pairs_, links_) : partsOfRuns(pairs_, links_);
  const std::vector<std::uint32_t> number = runs.numbers();
  std::vector<std::uint32_t> pair_count(number.size());
  for (const std::uint32_t run : number) ++pair_count[run];
  std::vector<Portal> portals;
  std::vector<std::uint32_t> seen;
  std::vector<std::uint32_t> first_low;
  for (std::uint32_t k = 0; k < pairs_.size(); ++k) {
    const PixelPair& pair = pairs_[k];
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

}  // namespace agrid::planning
