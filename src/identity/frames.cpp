// SPDX-License-Identifier: BSD-3-Clause
#include "identity/frames.h"

#include <utility>

#include "identity/tag_words.h"

namespace agrid {
namespace {

/// Everything that isn't found again by itself.
bool mustBeKept(const AreaTag& tag) { return tag.source != TagSource::kAutomatic; }
bool mustBeKept(const DoorTag& tag) { return tag.source != TagSource::kAutomatic || tag.absent; }
bool mustBeKept(const ObjectTag&) { return true; }

template <typename T>
void leaveBehind(const std::vector<T>& tags, const std::string& frame, const std::string& reason,
                 Recognition& result) {
  for (const T& tag : tags) {
    if (mustBeKept(tag)) wait(tag, false, frame, reason, result);
  }
}

}  // namespace

FramedKnowledge bringToFrame(const Knowledge& known, const std::string& known_frame,
                             const std::string& frame, Recognition& result) {
  FramedKnowledge here;
  here.frame_id = frame;
  apply(ReserveIds{known.next_ids}, result.knowledge);
  const bool same = known_frame.empty() || known_frame == frame;
  for (const PendingTag& pending : known.pending) {
    const std::string& its_frame = pending.frame_id.empty() ? known_frame : pending.frame_id;
    if (its_frame.empty() || its_frame == frame) {
      here.waiting.push_back(pending.tag);
    } else {
      apply(DeferTag{{pending.tag, its_frame, pending.reason}}, result.knowledge);
    }
  }
  if (same) {
    here.live = known;
    here.live.pending.clear();
  } else {
    const std::string reason = "its place is in '" + known_frame + "', the map in '" + frame + "'";
    leaveBehind(known.areas, known_frame, reason, result);
    leaveBehind(known.doors, known_frame, reason, result);
    leaveBehind(known.objects, known_frame, reason, result);
  }
  return here;
}

}  // namespace agrid
