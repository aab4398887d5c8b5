// SPDX-License-Identifier: BSD-3-Clause
#include "identity/outline_overlap.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "identity/polygon_lookup.h"

namespace agrid {
namespace {

/// The outline crosses the middle of a row of pixels.
struct Crossing {
  std::uint32_t rank = 0;  ///< of the place
  double x = 0;            ///< [px]
  friend bool operator<(const Crossing& a, const Crossing& b) {
    return std::tie(a.rank, a.x) < std::tie(b.rank, b.x);
  }
};

using Rows = std::vector<std::vector<Crossing>>;

Polygon inPixels(const Polygon& outline_map, const MapGeometry& geometry) {
  const Pose2 image_from_map = inverse(geometry.map_from_image);
  Polygon outline;
  for (const Point2& corner : outline_map) {
    outline.emplace_back(image_from_map * corner / geometry.resolution);
  }
  return outline;
}

/// The first of `count` pixels whose middle lies at or beyond x.
int firstPixel(double x, int count) {
  return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0., static_cast<double>(count)));
}

void addEdge(const Point2& a, const Point2& b, std::uint32_t rank, Rows& rows) {
  const Point2& low = a.y() < b.y() ? a : b;
  const Point2& high = a.y() < b.y() ? b : a;
  const int height = static_cast<int>(rows.size());
  const int end = firstPixel(high.y(), height);
  for (int y = firstPixel(low.y(), height); y < end; ++y) {
    const double t = (y + 0.5 - low.y()) / (high.y() - low.y());
    rows[static_cast<std::size_t>(y)].push_back({rank, low.x() + t * (high.x() - low.x())});
  }
}

/// Counts the pixels of one row after the other.
class RowCounter {
 public:
  RowCounter(const std::vector<FormerPlace>& places, const std::vector<std::size_t>& by_rank,
             int width, OutlineOverlap& result)
      : places_(places),
        by_rank_(by_rank),
        owner_(static_cast<std::size_t>(width)),
        waiting_(owner_.size()),
        common_(places.size()),
        filled_(places.size(), 0),
        result_(result) {}

  void addRow(std::vector<Crossing>& crossings, const std::uint16_t* labels) {
    std::fill(owner_.begin(), owner_.end(), 0);
    std::fill(waiting_.begin(), waiting_.end(), false);
    std::sort(crossings.begin(), crossings.end());
    const int width = static_cast<int>(owner_.size());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const int begin = firstPixel(crossings[i].x, width);
      const int end = firstPixel(crossings[i + 1].x, width);
      if (begin < end) addSpan(by_rank_[crossings[i].rank], {begin, end}, labels);
    }
    countOwners(labels);
  }

  void finish() {
    for (std::size_t p = 0; p < places_.size(); ++p) {
      for (const auto& [label, pixels] : common_[p]) {
        if (label != 0) result_.of_place[p].push_back({label, pixels});
        result_.place_size[p] += pixels;
      }
    }
  }

  const std::vector<std::int64_t>& pixelsWithin() const { return filled_; }

 private:
  void addSpan(std::size_t place, std::pair<int, int> span, const std::uint16_t* labels) {
    const auto [begin, end] = span;
    filled_[place] += end - begin;
    if (!places_[place].waits) {
      std::fill(owner_.begin() + begin, owner_.begin() + end, place + 1);
      return;
    }
    std::fill(waiting_.begin() + begin, waiting_.begin() + end, true);
    for (int x = begin, next = begin; x < end; x = next) {
      while (next < end && labels[next] == labels[x]) ++next;
      common_[place][labels[x]] += next - x;
    }
  }

  void countOwners(const std::uint16_t* labels) {
    const std::size_t width = owner_.size();
    for (std::size_t x = 0, next = 0; x < width; x = next) {
      const bool waiting = waiting_[x];
      while (next < width && labels[next] == labels[x] && owner_[next] == owner_[x] &&
             waiting_[next] == waiting) {
        ++next;
      }
      const auto pixels = static_cast<std::int64_t>(next - x);
      const std::size_t label = labels[x];
      result_.area_size[label] += pixels;
      if (owner_[x] != 0) {
        common_[owner_[x] - 1][label] += pixels;
        result_.known[label] += pixels;
      }
      if (owner_[x] != 0 || waiting) result_.ever_known[label] += pixels;
    }
  }

  const std::vector<FormerPlace>& places_;
  const std::vector<std::size_t>& by_rank_;
  std::vector<std::size_t> owner_;  ///< place + 1, 0 = none
  std::vector<char> waiting_;
  std::vector<std::map<std::size_t, std::int64_t>> common_;
  std::vector<std::int64_t> filled_;
  OutlineOverlap& result_;
};

}  // namespace

OutlineOverlap::OutlineOverlap(const std::vector<FormerPlace>& places, const MapGeometry& geometry,
                               const std::vector<std::uint16_t>& labels, std::size_t area_count)
    : of_place(places.size()),
      place_size(places.size(), 0),
      visible(places.size(), 0),
      area_size(area_count + 1, 0),
      known(area_count + 1, 0),
      ever_known(area_count + 1, 0) {
  std::vector<Polygon> outlines;
  std::vector<double> sizes;
  for (const FormerPlace& place : places) {
    outlines.push_back(inPixels(place.outline_map, geometry));
    sizes.push_back(surface(outlines.back()));
  }
  std::vector<std::size_t> by_rank(places.size());
  std::iota(by_rank.begin(), by_rank.end(), 0);
  std::stable_sort(by_rank.begin(), by_rank.end(),
                   [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  Rows rows(static_cast<std::size_t>(geometry.height));
  for (std::uint32_t rank = 0; rank < by_rank.size(); ++rank) {
    const Polygon& outline = outlines[by_rank[rank]];
    if (!std::isfinite(sizes[by_rank[rank]])) continue;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      addEdge(outline[i], outline[(i + 1) % outline.size()], rank, rows);
    }
  }
  RowCounter counter(places, by_rank, geometry.width, *this);
  for (int y = 0; y < geometry.height; ++y) {
    counter.addRow(rows[static_cast<std::size_t>(y)], labels.data() + geometry.index({0, y}));
  }
  counter.finish();
  for (std::size_t p = 0; p < places.size(); ++p) {
    if (sizes[p] > 0) visible[p] = static_cast<double>(counter.pixelsWithin()[p]) / sizes[p];
  }
}

}  // namespace agrid
