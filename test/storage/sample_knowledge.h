// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "agrid/tags/knowledge.h"

namespace agrid::test {

inline AreaTag areaNamed(std::uint32_t id, const std::string& name) {
  AreaTag tag;
  tag.id = AreaId{id};
  tag.name = name;
  tag.seed_map = {0.5 * id, 1};
  tag.source = TagSource::kManual;
  return tag;
}

/// The edit that puts a tag, which is applied to `knowledge`.
inline std::vector<Change> putting(const Tag& tag, Knowledge& knowledge) {
  std::vector<Change> edit;
  edit.emplace_back(PutTag{tag});
  agrid::apply(edit.front(), knowledge);
  return edit;
}

}  // namespace agrid::test
