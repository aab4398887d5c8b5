// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "agrid/semantic_map.h"
#include "agrid/tags/knowledge.h"

namespace agrid {

/// When a place of another map is the same place. doc/identity.md tells how the values were found.
struct RecognitionParams {
  // A former area is the one that has a large enough share of its pixels, and of whose pixels, as
  // far as they lay in any former area, it has a large enough share, both in (0, 1].
  double min_share = 0.34;         ///< for automatic areas; of several the best pairs in all
  double min_given_share = 0.67;   ///< for given tags; below it is doubt
  double min_return_share = 0.75;  ///< for given tags that wait: many small steps lead astray
  /// What both have in common is at least this share of the smaller of the two, in (0, 1].
  double min_containment = 0.3;
  /// At least this share of the former outline lies on the new map, in [0, 1].
  double min_visible = 0.1;
  /// The middle of a door moves at most so far [m] ...
  double max_door_shift = 0.6;
  /// ... or by this share of its width, if that is more.
  double max_door_shift_ratio = 0.25;
  /// Its direction turns at most so far [deg], in [0, 90].
  double max_door_turn_deg = 40;
  /// Of two doors that may be the same, the second best is so much farther away [m], or it is
  /// doubt.
  double min_door_lead = 0.2;
};

/// @throws std::invalid_argument naming field, value and bound
void validate(const RecognitionParams& params);

/// What is known of a place, brought to its new map.
struct Recognition {
  /// A tag for each area and door of the new map, the objects on it, all that waits.
  Knowledge knowledge;
  /// What changed, a sentence each: what waits and why, what is back, split, merged, gone.
  std::vector<std::string> report;
};

/// The door tags to annotate a new map with before it is recognised: those by people and robots
/// that are in its frame, waiting ones included, and those that say that there is no door.
Knowledge doorsFor(const std::string& fresh_frame, const Knowledge& known,
                   const std::string& known_frame);

/// Finds what is known on a new map of the place, or of a part of it, or of more than it; by what
/// areas have in common, whichever way the map's pixels lie. An area that grew or shrank is the
/// same; of one that was divided, and of several that became one, the largest part is the same if
/// it is large enough (see RecognitionParams). What is in doubt is not guessed: given tags wait,
/// automatic ones are forgotten. Given tags beat automatic ones. Waiting tags are tried again.
/// In another frame nothing can be found: all given tags and objects wait for theirs.
/// @param known        outlines of areas as last seen; coordinates in `known_frame`
/// @param known_frame  empty: the same as the new map's
/// @param fresh        the new map annotated with doorsFor(...); the ids of all that is not given
///                     mean nothing
/// @return knowledge in `fresh_frame`: for each area of `fresh` one tag whose seed lies in it; new
///         ids were never used. If `known` came from the same map, all of it is as it was.
/// @throws std::invalid_argument if a parameter is out of range
Recognition recognise(const Knowledge& known, const std::string& known_frame,
                      const SemanticMap& fresh, const std::string& fresh_frame,
                      const RecognitionParams& params = {});

}  // namespace agrid
