// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <utility>

#include "planning/region_roads.h"

namespace agrid::planning {

/// A region's roads, made when they are first asked for: after a door was opened or closed, few of
/// the roads around it matter to a search.
class LazyRoads {
 public:
  explicit LazyRoads(RegionRoads roads) : roads_(std::move(roads)), made_(true) {}
  explicit LazyRoads(std::function<RegionRoads()> make) : make_(std::move(make)), made_(false) {}

  const RegionRoads& get() const {
    if (!made_.load(std::memory_order_acquire)) make();
    return roads_;
  }

 private:
  void make() const {
    std::call_once(once_, [this] {
      roads_ = make_();
      make_ = nullptr;
      made_.store(true, std::memory_order_release);
    });
  }

  mutable std::function<RegionRoads()> make_;
  mutable RegionRoads roads_;
  mutable std::once_flag once_;
  mutable std::atomic<bool> made_;
};

}  // namespace agrid::planning
