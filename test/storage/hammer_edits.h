// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "agrid/tags/knowledge.h"

namespace agrid::test {

constexpr std::uint32_t kClients = 8;
constexpr std::uint32_t kWindow = 20;

inline std::uint32_t objectIdOf(std::uint32_t client, std::uint32_t count) {
  return count * kClients + client + 1;
}

/// The edit with number `count`, from 1, of a client: it sets the client's counter, adds an object
/// and drops an old one. After it the client has its last kWindow objects, no more and no less.
inline std::vector<Change> hammerEdit(std::uint32_t client, std::uint32_t count) {
  std::vector<Change> edit;
  ObjectTag object;
  object.id = ObjectId{objectIdOf(client, count)};
  object.name = "\"" + std::to_string(client) + "\": " + std::to_string(count) + " caf\u00e9";
  object.size = {1. / count, 0.1};
  edit.emplace_back(PutTag{object});
  if (count > kWindow) {
    edit.emplace_back(DropTag{TagKind::kObject, objectIdOf(client, count - kWindow)});
  }
  AreaTag counter;
  counter.id = AreaId{client + 1};
  counter.category = std::to_string(count);
  edit.emplace_back(PutTag{counter});
  return edit;
}

/// The number of each client's last edit; throws if an edit is there in part only.
inline std::map<std::uint32_t, std::uint32_t> hammerCounts(const Knowledge& knowledge) {
  std::map<std::uint32_t, std::uint32_t> counts;
  Knowledge expected;
  for (const AreaTag& counter : knowledge.areas) {
    const auto client = static_cast<std::uint32_t>(counter.id) - 1;
    const auto count = static_cast<std::uint32_t>(std::stoul(counter.category));
    counts[client] = count;
    for (std::uint32_t n = count > kWindow ? count - kWindow + 1 : 1; n <= count; ++n) {
      for (const Change& change : hammerEdit(client, n)) agrid::apply(change, expected);
    }
  }
  expected.next_ids = knowledge.next_ids;
  if (!difference(expected, knowledge).empty())
    throw std::runtime_error("an edit is there in part");
  return counts;
}

}  // namespace agrid::test
