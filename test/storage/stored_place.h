// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

#include "agrid/storage.h"
#include "storage/sample_knowledge.h"

namespace agrid::test {

/// How a call fails.
template <typename Call>
StorageErrorCode codeOf(Call call) {
  try {
    call();
  } catch (const StorageError& error) {
    return error.code();
  }
  throw std::logic_error("it did not fail");
}

/// Opens a store in a folder, puts an area and folds.
inline StoredMap storedIn(const std::string& folder, const std::string& name = "office") {
  Store store(folder, name);
  StoredMap map = store.takeContents().map;
  map.frame_id = "map";
  map.map_id = "0123";
  store.append(putting(areaNamed(1, "kitchen"), map.knowledge));
  store.fold(map);
  return map;
}

inline StoreContents foundIn(const std::string& folder, const std::string& name = "office") {
  return Store(folder, name).takeContents();
}

}  // namespace agrid::test
