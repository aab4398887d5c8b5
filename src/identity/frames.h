// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "agrid/identity/recognition.h"

namespace agrid {

/// What is known in the frame of a new map.
struct FramedKnowledge {
  std::string frame_id;
  Knowledge live;            ///< without what waits
  std::vector<Tag> waiting;  ///< sorted by kind, then id
};

/// What has its coordinates in `frame` is returned; given tags and objects of other frames wait in
/// `result`, automatic ones are forgotten. Ids that were given out are reserved there.
FramedKnowledge bringToFrame(const Knowledge& known, const std::string& known_frame,
                             const std::string& frame, Recognition& result);

}  // namespace agrid
