// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <agrid_map/AddTag.h>
#include <agrid_map/ListTags.h>
#include <agrid_map/LoadMap.h>
#include <agrid_map/RemoveTag.h>
#include <agrid_map/SaveMap.h>
#include <agrid_map/SetDoor.h>

#include "ros/place_keeper.h"
#include "ros/plan_answers.h"

namespace agrid_map_ros {

/// The parameters of edits, those of the areas included.
agrid::EditParams editParams(const Parameters& parameters);

/// A tag as it came, with its coordinates brought to the map's frame. A pose of all zeros without a
/// frame, of a tag with an id, means that nothing is said about where the thing is.
/// @throws RequestError INVALID_REQUEST for an unknown type or numbers that are not finite,
///         NO_TRANSFORM
agrid::AddTag tagFromMsg(const Frames& frames, const agrid_map::Tag& tag);

/// The answers to requests that change what is known.
/// @throws RequestError, LookupError, EditError, StorageError if it cannot be done; nothing has
///         changed then
agrid_map::AddTag::Response answerAddTag(const Ground& ground, PlaceKeeper& keeper,
                                         const agrid_map::AddTag::Request& request);
agrid_map::RemoveTag::Response answerRemoveTag(const Ground& ground, PlaceKeeper& keeper,
                                               const agrid_map::RemoveTag::Request& request);
agrid_map::SetDoor::Response answerSetDoor(const Ground& ground, PlaceKeeper& keeper,
                                           const agrid_map::SetDoor::Request& request);
agrid_map::SaveMap::Response answerSaveMap(const Ground& ground, PlaceKeeper& keeper,
                                           const agrid_map::SaveMap::Request& request);
agrid_map::LoadMap::Response answerLoadMap(const Ground& ground, PlaceKeeper& keeper,
                                           const agrid_map::LoadMap::Request& request);

/// Areas, objects, doors and what waits; the latter with its reason as the property `pending`.
agrid_map::ListTags::Response answerListTags(const Ground& ground,
                                             const agrid_map::ListTags::Request& request);

}  // namespace agrid_map_ros
