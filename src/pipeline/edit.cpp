// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/pipeline/edit.h"

#include <utility>

#include "pipeline/edit_decisions.h"
#include "pipeline/edit_names.h"

namespace agrid {
namespace {

Edit decideAddition(const AddTag& request, const EditScope& scope) {
  requireTexts(request.tag);
  if (const auto* area = std::get_if<AreaTag>(&request.tag)) {
    return decideArea(request, *area, scope);
  }
  if (const auto* door = std::get_if<DoorTag>(&request.tag)) {
    return decideDoor(request, *door, scope);
  }
  return decideObject(request, std::get<ObjectTag>(request.tag), scope);
}

void require(bool holds, const std::string& what, double value) {
  if (!holds) throw std::invalid_argument(what + ", but is " + std::to_string(value));
}

}  // namespace

void validate(const EditParams& params) {
  require(params.door_snap_dist > 0 && params.door_snap_dist <= 5,
          "door_snap_dist must lie in (0, 5]", params.door_snap_dist);
  require(params.max_door_width > 0 && params.max_door_width <= 10,
          "max_door_width must lie in (0, 10]", params.max_door_width);
  require(params.max_clutter_diagonal >= 0 && params.max_clutter_diagonal <= 100,
          "max_clutter_diagonal must lie in [0, 100]", params.max_clutter_diagonal);
}

Edit decide(const EditRequest& request, const SemanticMap& map, const EditParams& params) {
  validate(params);
  const EditScope scope{map, params};
  if (const auto* addition = std::get_if<AddTag>(&request)) {
    return decideAddition(*addition, scope);
  }
  if (const auto* removal = std::get_if<RemoveTag>(&request)) {
    return decideRemoval(*removal, scope);
  }
  return decideState(std::get<SetDoor>(request), scope);
}

}  // namespace agrid
