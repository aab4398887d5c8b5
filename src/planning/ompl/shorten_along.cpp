// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "planning/ompl/lead_roadmap.h"

namespace agrid::planning {
namespace {

namespace ob = ompl::base;

constexpr int kMaxTries = 300;
constexpr int kMaxVain = 60;  ///< tries in a row that do not help
constexpr std::size_t kAhead = 12;
/// Rounding makes a motion that is the shortest already a hair shorter or longer [m].
constexpr double kHair = 1e-6;

class Shortening {
 public:
  Shortening(const ob::SpaceInformationPtr& space, std::uint32_t seed,
             std::vector<ob::State*>& path)
      : space_(space), random_(seed), path_(path) {}

  /// Goes from each state straight to the last one ahead that it can reach.
  void leaveOut(const ob::PlannerTerminationCondition& stop) {
    for (std::size_t i = 0; i + 2 < path_.size() && !stop; ++i) {
      for (std::size_t j = std::min(path_.size() - 1, i + kAhead); j > i + 1 && !stop; --j) {
        if (!replaces(path_[i], path_[j], lengthBetween(i, j) + kHair)) continue;
        erase(i + 1, j);
        break;
      }
    }
  }

  void shortcut(const ob::PlannerTerminationCondition& stop) {
    int vain = 0;
    for (int i = 0; i < kMaxTries && vain < kMaxVain && !stop; ++i) {
      vain = tryShortcut() ? 0 : vain + 1;
    }
  }

 private:
  struct Place {
    std::size_t before;  ///< on the motion that starts here
    double share;        ///< of that motion
  };

  /// Free and not longer than `length`.
  bool replaces(const ob::State* a, const ob::State* b, double length) const {
    return space_->distance(a, b) <= length && space_->checkMotion(a, b);
  }
  double lengthBetween(std::size_t i, std::size_t j) const {
    double length = 0;
    for (; i < j; ++i) length += space_->distance(path_[i], path_[i + 1]);
    return length;
  }
  void erase(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) space_->freeState(path_[i]);
    path_.erase(path_.begin() + static_cast<std::ptrdiff_t>(begin),
                path_.begin() + static_cast<std::ptrdiff_t>(end));
  }
  Place placeAt(double along) const {
    std::size_t i = 0;
    double length = space_->distance(path_[0], path_[1]);
    while (along > length && i + 2 < path_.size()) {
      along -= length;
      ++i;
      length = space_->distance(path_[i], path_[i + 1]);
    }
    return {i, length > 0 ? std::min(along / length, 1.0) : 0.0};
  }
  ob::State* stateAt(const Place& place) const {
    ob::State* state = space_->allocState();
    space_->getStateSpace()->interpolate(path_[place.before], path_[place.before + 1], place.share,
                                         state);
    return state;
  }

  bool tryShortcut() {
    const double total = lengthBetween(0, path_.size() - 1);
    double from = random_.uniformReal(0, total);
    double to = random_.uniformReal(0, total);
    if (from > to) std::swap(from, to);
    const Place a = placeAt(from);
    const Place b = placeAt(to);
    if (a.before == b.before) return false;
    ob::State* first = stateAt(a);
    ob::State* second = stateAt(b);
    // The motions to and from the new states are checked, too: they need not be parts of the old
    // ones where two motions of the same length lead to a state.
    const bool helps = replaces(first, second, (to - from) * (1 - 1e-4) - kHair) &&
                       space_->checkMotion(path_[a.before], first) &&
                       space_->checkMotion(second, path_[b.before + 1]);
    if (!helps) {
      space_->freeState(first);
      space_->freeState(second);
      return false;
    }
    erase(a.before + 1, b.before + 1);
    const auto place = path_.begin() + static_cast<std::ptrdiff_t>(a.before + 1);
    path_.insert(place, {first, second});
    return true;
  }

  const ob::SpaceInformationPtr& space_;
  ompl::RNG random_;
  std::vector<ob::State*>& path_;
};

}  // namespace

void shortenAlong(const ob::SpaceInformationPtr& space, std::uint32_t seed,
                  const ob::PlannerTerminationCondition& stop, std::vector<ob::State*>& path) {
  if (path.size() < 3) return;
  Shortening shortening(space, seed, path);
  shortening.leaveOut(stop);
  shortening.shortcut(stop);
  shortening.leaveOut(stop);
}

}  // namespace agrid::planning
