// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "agrid/tags/knowledge.h"

namespace agrid {

// The words of the file form, in the order of the enumerations.
inline constexpr std::array<std::string_view, 3> kSourceWords{"automatic", "manual", "interaction"};
inline constexpr std::array<std::string_view, 3> kStateWords{"unknown", "open", "closed"};
inline constexpr std::array<std::string_view, 3> kKindWords{"area", "door", "object"};  // from 1

std::string_view wordOf(TagKind kind);

/// YAML flow mappings in one line, as doc/file_format.md has them; what is empty or has its usual
/// value is left out.
std::string flowText(const Tag& tag);
std::string flowText(const PendingTag& pending);
std::string flowText(const NextIds& ids);
std::string flowText(const Change& change);
/// A list of changes.
std::string flowText(const std::vector<Change>& edit);

/// @throws std::invalid_argument naming field and bound if the tag could not be read again: its id
///         must be in [1, 2^32-2], numbers finite, sizes not negative
void checkStorable(const Tag& tag);
void checkStorable(const Change& change);
void checkStorable(const Knowledge& knowledge);

}  // namespace agrid
