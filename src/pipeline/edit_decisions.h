// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "agrid/pipeline/edit.h"

namespace agrid {

/// What a decision is about: the map and what is known of it.
struct EditScope {
  const SemanticMap& map;
  const EditParams& params;

  const Knowledge& known() const { return map.knowledge; }
  const MapGeometry& geometry() const { return map.map().geometry(); }
};

Edit decideArea(const AddTag& request, const AreaTag& said, const EditScope& scope);
Edit decideDoor(const AddTag& request, const DoorTag& said, const EditScope& scope);
Edit decideObject(const AddTag& request, const ObjectTag& said, const EditScope& scope);
Edit decideRemoval(const RemoveTag& request, const EditScope& scope);
Edit decideState(const SetDoor& request, const EditScope& scope);

/// A tag as it was known before, and how it waits if it does.
struct KnownTag {
  Tag tag;
  const PendingTag* pending = nullptr;
};

std::optional<KnownTag> findKnown(const Knowledge& knowledge, TagKind kind, std::uint32_t id);

/// What a request names: by its id, or else by its name.
struct Subject {
  std::optional<KnownTag> known;  ///< none: nothing that is known
  bool by_name = false;
};

/// @throws EditError kUnknownName if there is no thing with the request's id
Subject findSubject(const AddTag& request, const EditScope& scope);

/// @throws EditError kInvalid unless it is finite
void requireFinite(const Point2& position, double yaw);
/// @throws EditError kOutside with the bounds of the map unless a pixel of it holds the point
Pixel requireInside(const EditScope& scope, const Point2& point_map);

/// A tag that is to hold, and what else changes with it.
struct Decision {
  Tag tag;                     ///< id 0: a new one
  std::string waits_because;   ///< empty: it holds at once
  std::vector<Change> before;  ///< changes of others
  std::string message;         ///< what is done
};

/// Makes the decision an edit: gives a new tag its id and name.
/// @param known  the tag as it was
/// @throws EditError if its name is taken or there are too many tags
Edit conclude(Decision decision, const std::optional<KnownTag>& known, TagSource source,
              const EditScope& scope);

/// Properties with those added that were said; see AddTag.
Properties merged(Properties known, const Properties& said);

/// What a thing of these properties is called once a name was said of it: where it was found by
/// that name, be it an alias or in capitals, it stays as it is.
std::string newName(const std::string& name, const Properties& properties, const std::string& said,
                    bool by_name);

[[noreturn]] void refuse(EditErrorCode code, const std::string& why);

/// "(x, y)" with centimetres.
std::string inWords(const Point2& point);
/// Metres with centimetres, without a unit.
std::string inWords(double length);

}  // namespace agrid
