// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "agrid/identity/recognition.h"

namespace agrid {

/// How a report calls a tag: its kind, id and name.
std::string words(const Tag& tag);

/// The tag waits from now on; it is reported if it did not wait before.
void wait(const Tag& tag, bool waited, const std::string& frame, const std::string& reason,
          Recognition& result);

/// The lowest id from `next` on whose default name no tag bears.
template <typename Id, typename Names>
Id newId(std::uint32_t& next, const char* prefix, const Names& names) {
  while (names.count(prefix + std::to_string(next)) > 0) ++next;
  return Id{next++};
}

}  // namespace agrid
