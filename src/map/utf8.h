// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace agrid {

/// Length in bytes of the UTF-8 sequence that begins at byte i; 0 if none does (RFC 3629, table in
/// section 4).
std::size_t sequenceLength(const std::string& text, std::size_t i);

/// The characters of a text; nothing if it is not UTF-8.
std::optional<std::u32string> codePointsOf(const std::string& text);

/// A character that is one (at most U+10FFFF and no half of a surrogate pair) as UTF-8, at the end
/// of a text.
void appendUtf8(std::string& text, char32_t code_point);

}  // namespace agrid
