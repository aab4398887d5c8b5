// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "agrid/semantic_map.h"
#include "agrid/tags/knowledge.h"

namespace agrid {

/// What a tag says about where it is.
enum class Placement {
  kPose,        ///< all of it; an area has no heading
  kAnyHeading,  ///< where, but not in which direction
  kUnchanged    ///< nothing: what has its id stays where it is
};

/// Someone says that something is there. An id that exists moves, renames or changes that thing:
/// empty texts, a width or size of 0 and the state kUnknown leave what was; properties are added to
/// those that were, and an empty value takes one away. Id 0: new, unless that very thing is known.
/// Areas and doors said automatically are taken as said by hand.
struct AddTag {
  Tag tag;               ///< its coordinates in the map frame
  bool replace = false;  ///< a thing of that name moves; what is in its place waits or is renamed
  bool force = false;    ///< a door stays where it was given, however far from a passage
  Placement placement = Placement::kPose;
};

/// What is known of a thing is forgotten.
struct RemoveTag {
  TagKind kind = TagKind::kArea;
  std::uint32_t id = 0;
};

/// Someone says whether a door is open.
struct SetDoor {
  DoorId door{};
  DoorState state = DoorState::kUnknown;
  TagSource source = TagSource::kManual;
};

using EditRequest = std::variant<AddTag, RemoveTag, SetDoor>;

struct EditParams {
  /// A door is looked for as far from where it was said to be [m], in (0, 5].
  double door_snap_dist = 1.0;
  /// Wider places are not taken for doors, unless the tag says that it is that wide [m], in (0,
  /// 10].
  double max_door_width = 2.6;
  /// As AreaParams::max_clutter_diagonal: smaller obstacles are no jambs, but those from 5 m on are
  /// [m], in [0, 100].
  double max_clutter_diagonal = 1.0;
  /// Areas and objects in unknown space are accepted, with a warning; areas wait there.
  bool allow_unknown = true;
  /// So many tags are kept, automatic and waiting ones included.
  std::size_t max_tags = 100000;
};

/// @throws std::invalid_argument naming field, value and bound
void validate(const EditParams& params);

/// What an edit does.
struct Edit {
  std::vector<Change> changes;  ///< what leads to what is known afterwards; empty: it was known
  TagKind kind = TagKind::kArea;
  std::uint32_t id = 0;  ///< of the thing
  std::string message;   ///< what was done and what looks wrong, for a person

  bool changed() const { return !changes.empty(); }
};

/// Why an edit is refused.
enum class EditErrorCode {
  kInvalid,      ///< a pose, size, name or property that can't be, or a door where no passage is
  kUnknownName,  ///< there is no such thing
  kNameTaken,    ///< another thing of that kind has that name or place
  kOutside,      ///< outside the map, or in space where this can't be
  kLimit         ///< too many tags
};

/// An edit that is refused; nothing has changed. `what()` is for a person.
class EditError : public std::runtime_error {
 public:
  EditError(EditErrorCode code, const std::string& what) : std::runtime_error(what), code_(code) {}
  EditErrorCode code() const { return code_; }

 private:
  EditErrorCode code_;
};

/// What a request does to what is known. Looks at the map around the place only. The areas follow
/// when the changes are applied and laid over the map again (see annotate).
///
/// An area tag names the area that holds its point; where none is, it seeds one. A door tag names
/// the door that is meant, or else lies down in the middle of the narrowest place nearby, see
/// doc/tags.md. Removing an area gives its name back; removing a door joins the areas beside it: it
/// becomes `absent`, and saying that there is a door brings it back under its id.
/// @throws EditError if it is refused
/// @throws std::invalid_argument if a parameter is out of range
Edit decide(const EditRequest& request, const SemanticMap& map, const EditParams& params = {});

}  // namespace agrid
