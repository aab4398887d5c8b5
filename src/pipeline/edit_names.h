// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "agrid/pipeline/edit.h"

namespace agrid {

/// The thing of that kind whose name or alias this is, whatever the case; of several the one with
/// the lowest id, waiting ones last.
std::optional<std::uint32_t> idOfName(const SemanticMap& map, TagKind kind,
                                      const std::string& name);

/// Whether a thing of that name and these properties is called so, whatever the case.
bool isCalled(const std::string& name, const Properties& properties, const std::string& word);

/// Refuses a tag whose name, category or properties can't be, whoever has them.
/// @throws EditError kInvalid
void requireTexts(const Tag& tag);

/// Refuses a tag whose name or alias another thing of its kind has.
/// @throws EditError kNameTaken
void requireUniqueNames(const SemanticMap& map, const Tag& tag);

/// What a thing is called that nobody gave a name: its category, numbered from the second one on,
/// or its kind and id.
std::string defaultName(const SemanticMap& map, const Tag& tag);

/// A thing as it is called in messages: kind, id and name.
std::string called(const Tag& tag);

}  // namespace agrid
