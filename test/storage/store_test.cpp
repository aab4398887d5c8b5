// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "agrid/storage.h"
#include "storage/sample_knowledge.h"
#include "support/temporary_folder.h"

namespace agrid {
namespace {

using test::areaNamed;
using test::putting;

TEST(Store, WhatWasAppendedIsThereAfterwardsWithAndWithoutFolding) {
  const test::TemporaryFolder folder;
  StoredMap map;
  {
    Store store(folder.path(), "office");
    map = store.takeContents().map;
    map.frame_id = "map";
    for (std::uint32_t id = 1; id <= 3; ++id) {
      store.append(putting(areaNamed(id, "room"), map.knowledge));
      if (id == 2) store.fold(map);
    }
  }
  Store store(folder.path(), "office");
  const StoreContents found = store.takeContents();
  EXPECT_FALSE(found.is_new);
  EXPECT_TRUE(found.errors.empty());
  EXPECT_TRUE(found.warnings.empty());
  EXPECT_EQ(found.map.frame_id, "map");
  EXPECT_TRUE(difference(found.map.knowledge, map.knowledge).empty());
}

}  // namespace
}  // namespace agrid
