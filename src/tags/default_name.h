// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <set>
#include <string>

namespace agrid {

/// What a thing that nobody named is called, such as area_7; with underscores behind it as long as
/// another one is called so.
/// @param used  names of things of that kind; gains the new one
inline std::string defaultName(const std::string& kind, std::uint32_t id,
                               std::set<std::string>& used) {
  std::string name = kind + "_" + std::to_string(id);
  while (!used.insert(name).second) name += "_";
  return name;
}

}  // namespace agrid
