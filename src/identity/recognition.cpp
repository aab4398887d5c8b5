// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/identity/recognition.h"

#include <stdexcept>
#include <utility>

#include "identity/area_recognition.h"
#include "identity/door_recognition.h"
#include "identity/frames.h"
#include "identity/tag_words.h"

namespace agrid {
namespace {

struct Bounds {
  const char* field;
  double value;
  double low;
  double high;
};

/// Things are where they were seen, whatever became of the walls around them.
void placeObjects(const FramedKnowledge& known, const MapGeometry& geometry, Recognition& result) {
  const auto place = [&](const ObjectTag& tag, bool waits) {
    const bool on_map = geometry.pixelAt(tag.pose_map.position).has_value();
    if (on_map) {
      apply(PutTag{tag}, result.knowledge);
      if (waits) result.report.push_back(words(tag) + " is back");
    } else {
      wait(tag, waits, known.frame_id, "its place is not on the map", result);
    }
  };
  for (const ObjectTag& tag : known.live.objects) place(tag, false);
  for (const Tag& tag : known.waiting) {
    if (const auto* object = std::get_if<ObjectTag>(&tag)) place(*object, true);
  }
}

}  // namespace

void validate(const RecognitionParams& p) {
  for (const Bounds& b : {Bounds{"min_share", p.min_share, 0.01, 1},
                          Bounds{"min_given_share", p.min_given_share, 0.5, 1},
                          Bounds{"min_return_share", p.min_return_share, 0.5, 1},
                          Bounds{"min_containment", p.min_containment, 0.001, 1},
                          Bounds{"min_visible", p.min_visible, 0, 1},
                          Bounds{"max_door_shift", p.max_door_shift, 0, 100},
                          Bounds{"max_door_shift_ratio", p.max_door_shift_ratio, 0, 1},
                          Bounds{"max_door_turn_deg", p.max_door_turn_deg, 0, 90},
                          Bounds{"min_door_lead", p.min_door_lead, 0, 100}}) {
    if (b.value >= b.low && b.value <= b.high) continue;
    throw std::invalid_argument(std::string("identity.") + b.field + " is " +
                                std::to_string(b.value) + ", must be in [" + std::to_string(b.low) +
                                ", " + std::to_string(b.high) + "]");
  }
}

Knowledge doorsFor(const std::string& fresh_frame, const Knowledge& known,
                   const std::string& known_frame) {
  Recognition unused;
  const FramedKnowledge framed = bringToFrame(known, known_frame, fresh_frame, unused);
  Knowledge doors;
  const auto add = [&](const DoorTag& tag) {
    if (tag.source != TagSource::kAutomatic || tag.absent) apply(PutTag{tag}, doors);
  };
  for (const DoorTag& tag : framed.live.doors) add(tag);
  for (const Tag& tag : framed.waiting) {
    if (const auto* door = std::get_if<DoorTag>(&tag)) add(*door);
  }
  doors.next_ids = known.next_ids;
  return doors;
}

Recognition recognise(const Knowledge& known, const std::string& known_frame,
                      const SemanticMap& fresh, const std::string& fresh_frame,
                      const RecognitionParams& params) {
  validate(params);
  Recognition result;
  const FramedKnowledge here = bringToFrame(known, known_frame, fresh_frame, result);
  const auto new_ids = placeAreas(here, fresh, params, result);
  placeDoors(here, fresh, new_ids, params, result);
  placeObjects(here, fresh.map().geometry(), result);
  return result;
}

}  // namespace agrid
