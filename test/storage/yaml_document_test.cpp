// SPDX-License-Identifier: BSD-3-Clause
// The reader of the package's own layout must not tell anything but what yaml-cpp tells.
#include "storage/yaml_document.h"

#include <optional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "agrid/storage.h"

namespace agrid {
namespace {

using Entries = std::vector<std::string>;

void describe(const StoredNode& node, std::string& text) {
  text += std::to_string(static_cast<int>(node.kind)) + "@" + std::to_string(node.line) + "<" +
          node.key + "|" + node.text + "|";
  for (const StoredNode& child : node.children) describe(child, text);
  text += ">";
}

NodeSink into(Entries& entries) {
  return [&entries](const std::string& section, StoredNode&& node) {
    entries.push_back(section + ":");
    describe(node, entries.back());
  };
}

std::optional<Entries> readFast(const std::string& text) {
  Entries entries;
  return readOwnYaml(text, into(entries)) ? std::optional(entries) : std::nullopt;
}

std::optional<Entries> readAll(const std::string& text) {
  Entries entries;
  try {
    readYaml(text, "x", into(entries));
  } catch (const StorageError&) {
    return std::nullopt;
  }
  return entries;
}

TEST(YamlDocument, S15_ItemsThatAPersonChangedDoNotSlowTheOthersDown) {
  const std::string before = "version: 1\nareas:\n  - {id: 1, name: \"a\"}\n";
  const std::string after = "  - {id: 3, name: \"c\"}\ndoors: []\nend: true\n";
  for (const std::string item :
       {"  - {id: 2, name: kitchen, seed: [1, 2]}\n", "  - {id: 2, name: 'my place'}  # mine\n",
        "  - id: 2\n    name: Kitchen\n    seed: [1, 2]\n", "  - {id: 2,\n     name: \"b\"}\n",
        "  - id: 2\n\n    # said by Anna\n    name: |\n      a long\n        - name\n",
        "  - {id: 2, name: null}\n", "  - {name: \"two\nlines\"}\n"}) {
    SCOPED_TRACE(item);
    const auto fast = readFast(before + item + after);
    const bool is_cut = item.find("two\nlines") != std::string::npos;
    ASSERT_EQ(fast.has_value(), !is_cut);
    if (is_cut) continue;
    EXPECT_EQ(fast, readAll(before + item + after));
  }
}

TEST(YamlDocument, WhatIsReadFastIsWhatYamlSays) {
  const std::vector<std::string> lines{"a: 1",
                                       "a:",
                                       "b: []",
                                       "c: [1, \"x\"]",
                                       "d: {k: v}",
                                       "e: null",
                                       "\"f\": 1",
                                       "g : 2",
                                       "# note",
                                       "",
                                       "  - {i: 1}",
                                       "  - i: 1",
                                       "    j: 2",
                                       "  - [1, 2]",
                                       "  - {k: 1, k: 2}",
                                       "  - \"open",
                                       "close\"",
                                       "  - x # y",
                                       "    # z",
                                       "  - |",
                                       "      text",
                                       "  - - 1",
                                       "  - {k: null}",
                                       "---",
                                       "...",
                                       "  - &n {i: 1}",
                                       "  - *n",
                                       "   - 7",
                                       " - 8",
                                       "- 9",
                                       "  - null",
                                       "  - -",
                                       "h: -",
                                       "  - {a: b,",
                                       "      c: d}",
                                       "  - ",
                                       "    k: 'it''s'"};
  std::mt19937 random(15);
  int both = 0;
  for (int trial = 0; trial < 60000; ++trial) {
    std::string text = trial % 2 == 0 ? "s:\n" : "";
    const auto count = 1 + random() % 5;
    for (unsigned i = 0; i < count; ++i) text += lines[random() % lines.size()] + "\n";
    const auto fast = readFast(text);
    if (!fast) continue;
    ++both;
    ASSERT_EQ(fast, readAll(text)) << text;
  }
  EXPECT_GT(both, 1000);
}

}  // namespace
}  // namespace agrid
