// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace agrid {

/// CRC-64/XZ of a text.
std::uint64_t checksumOf(std::string_view text);

/// Where a single bit of a text was flipped after its checksum was made.
/// @return offset of the byte, or none if no single bit explains the difference
std::optional<std::size_t> flippedByte(std::string_view text, std::uint64_t former_checksum);

/// 16 hexadecimal digits in lower case.
std::string hexadecimalOf(std::uint64_t value);
/// The value of exactly 16 such digits.
std::optional<std::uint64_t> valueOfHexadecimal(std::string_view digits);

}  // namespace agrid
