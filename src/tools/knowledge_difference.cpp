// SPDX-License-Identifier: BSD-3-Clause
#include "tools/knowledge_difference.h"

#include <cmath>
#include <map>
#include <set>

#include "agrid/tags/name.h"
#include "identity/polygon_lookup.h"
#include "storage/tag_text.h"
#include "tools/area_changes.h"
#include "tools/table_text.h"
#include "tools/tag_pairs.h"
#include "tools/tag_sentences.h"

namespace agrid::tools {
namespace {

constexpr double kLeastLength = 0.005;  // [m] that counts
constexpr double kLeastTurnDeg = 0.5;
constexpr double kSameOutline = 0.95;  // of the union

std::string quoted(const std::string& text) { return text.empty() ? "none" : "'" + text + "'"; }

std::string fromTo(const std::string& from, const std::string& to) {
  return "from " + from + " to " + to;
}

/// Angle between two lines, whichever way they point [deg], in [0, 90].
double turnOfLinesDeg(double from, double to) {
  return std::abs(std::remainder(to - from, M_PI)) * 180 / M_PI;
}
double turnDeg(double from, double to) {
  return std::abs(std::remainder(to - from, 2 * M_PI)) * 180 / M_PI;
}

/// Compares two files, one kind after the other.
class Comparison {
 public:
  Comparison(const StoreContents& a, const StoreContents& b)
      : a_(a.map), b_(b.map), same_frame_(a.map.frame_id == b.map.frame_id) {
    if (same_frame_) shares_ = outlineShares(a_.knowledge.areas, b_.knowledge.areas);
    pairs_ = pairUp(a, b, shares_);
    for (const PendingTag& pending : a_.knowledge.pending) waited_[keyOf(pending.tag)] = &pending;
    for (const PendingTag& pending : b_.knowledge.pending) waits_[keyOf(pending.tag)] = &pending;
  }

  std::vector<std::string> lines() {
    compareFiles();
    const Knowledge& a = a_.knowledge;
    const Knowledge& b = b_.knowledge;
    told_ = tellSplitsAndMerges(a.areas, b.areas, shares_, pairs_.areas, sentences_);
    compareLists(a.areas, b.areas, pairs_.areas);
    compareLists(a.doors, b.doors, pairs_.doors);
    compareLists(a.objects, b.objects, pairs_.objects);
    compareWaiting();
    return sentences_.lines();
  }

 private:
  using Waiting = std::map<std::string, const PendingTag*>;

  /// The same for the same tag of both files; without ids in common names must do.
  std::string keyOf(const Tag& tag) const {
    const bool by_id = pairs_.by_id || nameOf(tag).empty();
    return std::to_string(tag.index()) +
           (by_id ? " " + std::to_string(idOf(tag)) : "'" + foldCase(nameOf(tag)));
  }

  void compareFiles() {
    if (!same_frame_) {
      sentences_.addOnPlace("the frame changed " +
                            fromTo(quoted(a_.frame_id), quoted(b_.frame_id)));
    }
    if (a_.map_id != b_.map_id) {
      sentences_.addOnPlace("the metric map changed " +
                            fromTo(quoted(a_.map_id), quoted(b_.map_id)));
    }
  }

  bool isTold(const AreaTag&, std::size_t i, bool in_a) const {
    return (in_a ? told_.a : told_.b).count(i) > 0;
  }
  template <typename T>
  bool isTold(const T&, std::size_t, bool) const {
    return false;
  }

  template <typename T>
  void compareLists(const std::vector<T>& a, const std::vector<T>& b, const TagPairs& pairs) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (pairs.in_b[i]) {
        compareAll(a[i], b[*pairs.in_b[i]], isTold(a[i], i, true));
      } else if (waits_.count(keyOf(a[i])) == 0 && !isTold(a[i], i, true)) {
        sentences_.say(a[i], "was removed");
      }
    }
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (pairs.in_a[j]) continue;
      live_.insert(keyOf(b[j]));
      if (waited_.count(keyOf(b[j])) == 0 && !isTold(b[j], j, false)) tellAdded(b[j]);
    }
  }

  void tellAdded(const DoorTag& door) {
    sentences_.say(door, door.absent ? "was added: it is said to be absent" : "was added");
  }
  template <typename T>
  void tellAdded(const T& tag) {
    sentences_.say(tag, "was added");
  }

  template <typename T>
  void compareAll(const T& a, const T& b, bool is_told) {
    if (a.name != b.name) {
      sentences_.say(a, b.name.empty() ? "lost its name" : "was renamed to '" + b.name + "'");
    }
    if (a.source != b.source) {
      const auto word = [](TagSource source) {
        return std::string(kSourceWords[static_cast<std::size_t>(source)]);
      };
      sentences_.say(a, "changed its source " + fromTo(word(a.source), word(b.source)));
    }
    compareProperties(a, a.properties, b.properties);
    if constexpr (std::is_same_v<T, AreaTag>) {
      compareAreas(a, b, is_told);
    } else {
      compareRest(a, b);
    }
  }

  void compareProperties(const Tag& tag, const Properties& a, const Properties& b) {
    Properties keys = a;
    keys.insert(b.begin(), b.end());
    const auto valueIn = [](const Properties& properties, const std::string& key) {
      const auto found = properties.find(key);
      return found == properties.end() ? "none" : "'" + found->second + "'";
    };
    for (const auto& [key, unused] : keys) {
      const std::string former = valueIn(a, key);
      const std::string now = valueIn(b, key);
      if (former != now) {
        sentences_.say(tag, "changed its property '" + key + "' " + fromTo(former, now));
      }
    }
  }

  void compareCategory(const Tag& tag, const std::string& a, const std::string& b) {
    if (a != b) sentences_.say(tag, "changed its category " + fromTo(quoted(a), quoted(b)));
  }

  void compareAreas(const AreaTag& a, const AreaTag& b, bool is_told) {
    compareCategory(a, a.category, b.category);
    if (!same_frame_) return;
    const double apart = (a.seed_map - b.seed_map).norm();
    if (apart >= kLeastLength && a.source != TagSource::kAutomatic) {
      sentences_.say(a, "has its seed moved by " + formatted("%.2f m", apart));
    }
    if (is_told || a.outline_map.empty() || b.outline_map.empty()) return;
    const double common = commonSurface(a.outline_map, b.outline_map);
    const double former = surface(a.outline_map);
    const double now = surface(b.outline_map);
    if (common >= kSameOutline * (former + now - common)) return;
    sentences_.say(a, "changed its outline " +
                          fromTo(formatted("%.1f", former), formatted("%.1f m^2", now)) + ", " +
                          formatted("%.1f m^2 in common", common));
  }

  void compareLength(const Tag& tag, const std::string& what, double a, double b) {
    if (std::abs(a - b) < kLeastLength) return;
    sentences_.say(
        tag, "changed its " + what + " " + fromTo(formatted("%.2f", a), formatted("%.2f m", b)));
  }

  void comparePlaces(const Tag& tag, const Pose2& a, const Pose2& b, double turned_deg) {
    if (!same_frame_) return;
    const double apart = (a.position - b.position).norm();
    if (apart >= kLeastLength) sentences_.say(tag, "was moved by " + formatted("%.2f m", apart));
    if (turned_deg >= kLeastTurnDeg) {
      sentences_.say(tag, "was turned by " + formatted("%.0f degrees", turned_deg));
    }
  }

  void compareRest(const DoorTag& a, const DoorTag& b) {
    comparePlaces(a, a.pose_map, b.pose_map, turnOfLinesDeg(a.pose_map.yaw, b.pose_map.yaw));
    compareLength(a, "width", a.width, b.width);
    if (a.state != b.state) {
      const auto word = [](DoorState state) {
        return std::string(kStateWords[static_cast<std::size_t>(state)]);
      };
      sentences_.say(a, "changed its state " + fromTo(word(a.state), word(b.state)));
    }
    if (a.absent == b.absent) return;
    sentences_.say(a, b.absent ? "is said to be absent now" : "is said to be absent no more");
  }

  void compareRest(const ObjectTag& a, const ObjectTag& b) {
    compareCategory(a, a.category, b.category);
    comparePlaces(a, a.pose_map, b.pose_map, turnDeg(a.pose_map.yaw, b.pose_map.yaw));
    compareLength(a, "length", a.size.x(), b.size.x());
    compareLength(a, "breadth", a.size.y(), b.size.y());
    compareLength(a, "height", a.height, b.height);
  }

  void compareWaiting() {
    for (const auto& [key, now] : waits_) {
      const auto former = waited_.find(key);
      if (former == waited_.end()) {
        sentences_.say(now->tag, "waits now: " + now->reason);
      } else if (!(former->second->tag == now->tag)) {
        sentences_.say(now->tag, "still waits, and was changed");
      } else if (former->second->reason != now->reason) {
        sentences_.say(now->tag, "still waits, for another reason: " + now->reason);
      }
    }
    for (const auto& [key, former] : waited_) {
      if (waits_.count(key) > 0) continue;
      sentences_.say(former->tag,
                     live_.count(key) > 0 ? "waits no more" : "waited and was removed");
    }
  }

  const StoredMap& a_;
  const StoredMap& b_;
  bool same_frame_;
  std::vector<OutlineShare> shares_;
  KnowledgePairs pairs_;
  Waiting waited_;  ///< in A
  Waiting waits_;   ///< in B
  ToldAreas told_;
  std::set<std::string> live_;  ///< keys of the tags of B that A does not have
  Sentences sentences_;
};

}  // namespace

std::vector<std::string> differences(const StoreContents& a, const StoreContents& b) {
  return Comparison(a, b).lines();
}

}  // namespace agrid::tools
