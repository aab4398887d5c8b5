// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <cstring>
#include <iostream>
#include <limits>
#include <locale>
#include <random>

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "agrid/storage.h"
#include "storage/checksum.h"
#include "storage/flow_text.h"
#include "storage/sample_knowledge.h"
#include "storage/snapshot.h"
#include "storage/tag_text.h"
#include "storage/yaml_document.h"

namespace agrid {
namespace {

std::string randomBytes(std::mt19937& random, std::size_t most) {
  std::string text(random() % (most + 1), ' ');
  for (char& c : text) c = static_cast<char>(random());
  return text;
}

/// All of it finite.
double randomNumber(std::mt19937& random) {
  double number = 0;
  do {
    const std::uint64_t bits = (std::uint64_t{random()} << 32) | random();
    std::memcpy(&number, &bits, sizeof number);
  } while (!std::isfinite(number));
  return number;
}

Snapshot randomSnapshot(std::mt19937& random) {
  Snapshot snapshot;
  snapshot.map.map_id = randomBytes(random, 9);
  snapshot.map.frame_id = randomBytes(random, 9);
  snapshot.history = random() + 1U;
  snapshot.sequence = random();
  Knowledge& known = snapshot.map.knowledge;
  for (std::uint32_t id = 1; id < 9; ++id) {
    AreaTag area = test::areaNamed(id, randomBytes(random, 20));
    area.category = randomBytes(random, 5);
    area.properties[randomBytes(random, 5)] = randomBytes(random, 20);
    area.seed_map = {randomNumber(random), randomNumber(random)};
    area.outline_map.resize(random() % 4, Point2(randomNumber(random), -0.0));
    agrid::apply(PutTag{area}, known);
    DoorTag door;
    door.id = DoorId{id * 7};
    door.pose_map = {{randomNumber(random), randomNumber(random)}, randomNumber(random)};
    door.width = std::abs(randomNumber(random));
    door.state = static_cast<DoorState>(random() % 3);
    door.absent = random() % 2 == 0;
    agrid::apply(PutTag{door}, known);
    ObjectTag object;
    object.id = ObjectId{id};
    object.name = randomBytes(random, 30);
    object.height = std::abs(randomNumber(random));
    object.source = static_cast<TagSource>(random() % 3);
    agrid::apply(DeferTag{{object, randomBytes(random, 5), randomBytes(random, 40)}}, known);
  }
  return snapshot;
}

void expectSame(const Snapshot& a, const Snapshot& b) {
  EXPECT_EQ(a.map.map_id, b.map.map_id);
  EXPECT_EQ(a.map.frame_id, b.map.frame_id);
  EXPECT_EQ(a.history, b.history);
  EXPECT_EQ(a.sequence, b.sequence);
  EXPECT_TRUE(difference(a.map.knowledge, b.map.knowledge).empty());
  EXPECT_TRUE(difference(b.map.knowledge, a.map.knowledge).empty());
}

std::string withoutChecksum(const std::string& text) {
  return text.substr(0, text.rfind("checksum: "));
}

TEST(StoredText, T9_AnyBytesComeBackAndAnyYamlReaderAgrees) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Snapshot snapshot = randomSnapshot(random);
    const std::string text = snapshotText(snapshot);
    const ReadSnapshot read = readSnapshot(text, "x");
    EXPECT_TRUE(read.warnings.empty());
    expectSame(read.snapshot, snapshot);
    // by yaml-cpp, since without checksum it is a file that a person may have written
    expectSame(readSnapshot(withoutChecksum(text), "x").snapshot, snapshot);
  }
}

TEST(StoredText, T9_WhatYamlWouldTakeForSomethingElseIsText) {
  for (const std::string name :
       {"a: b",       "- x",    "*a",     "&a",     "!!x",       "#",
        "# x",        "\"",     "'",      "{{",     "}",         "[",
        "---",        "...",    "~",      "null",   "true",      "1e3",
        "",           " ",      "\\",     "\\n",    "\n",        "\r\n",
        "\t",         "%x",     "@",      "`",      ",",         "a\\",
        "?",          "|",      ">",      "<<",     "caf\u00e9", "\u5ba2\u5385",
        "\U0001F600", "\u202e", "\ufeff", "\u2028", "\u0085"}) {
    const std::string text = quoted(name);
    EXPECT_EQ(text.find('\n'), std::string::npos);
    EXPECT_EQ(YAML::Load(text).as<std::string>(), name);
    EXPECT_EQ(YAML::Load("[" + text + ", 1]")[0].as<std::string>(), name);
    EXPECT_EQ(parseFlow(text, 1)->text, name);
    EXPECT_EQ(parseFlow("{" + text + ": 1}", 1)->children.at(0).key, name);
  }
  EXPECT_EQ(YAML::Load(quoted("\xff\x00z")).as<YAML::Binary>().size(), 1U);
}

TEST(StoredText, NumbersAreTheShortestThatReadBack) {
  EXPECT_EQ(numberText(0.1), "0.1");
  EXPECT_EQ(numberText(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(numberText(-0.0), "-0");
  EXPECT_TRUE(std::signbit(*numberOf("-0")));
  EXPECT_EQ(numberOf("+1.5"), 1.5);
  for (const char* text :
       {"", "nan", ".nan", "inf", "1e999", "0,5", "1 ", " 1", "0x10", "1.5m", "-"}) {
    EXPECT_FALSE(numberOf(text)) << text;
  }
}

/// A decimal comma and dots between thousands, as German and Italian locales have them.
struct CommaPunctuation : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(StoredText, L13_TheLocaleDoesNotMatter) {
  std::mt19937 random(2);
  const Snapshot snapshot = randomSnapshot(random);
  const std::string expected = snapshotText(snapshot);
  const std::locale former = std::locale::global(std::locale(std::locale(), new CommaPunctuation));
  const char* named = std::setlocale(LC_ALL, "de_DE.UTF-8");
  const std::string text = snapshotText(snapshot);
  const ReadSnapshot own = readSnapshot(text, "x");
  const ReadSnapshot by_hand = readSnapshot(withoutChecksum(text), "x");
  std::locale::global(former);
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(text, expected);
  expectSame(own.snapshot, snapshot);
  expectSame(by_hand.snapshot, snapshot);
  RecordProperty("c_locale", named == nullptr ? "not installed" : named);
}

TEST(StoredText, APersonMayWriteLittle) {
  const ReadSnapshot read = readSnapshot(
      "format_version: 1\n"
      "areas:\n"
      "- name: kitchen\n"
      "  seed: [1, 2.5]\n"
      "- {id: 7, name: 315, seed: [3, 4], floor: 2}\n"
      "doors: [{pose: [1, 1]}]\n"
      "objects:\n"
      "end_of_file: true\n",
      "x.yaml");
  const StoredMap& map = read.snapshot.map;
  ASSERT_EQ(map.knowledge.areas.size(), 2U);
  EXPECT_EQ(map.knowledge.areas[0].name, "315");
  EXPECT_EQ(map.knowledge.areas[1].name, "kitchen");
  EXPECT_EQ(map.knowledge.areas[1].id, AreaId{8});  // never one that is taken
  EXPECT_EQ(map.knowledge.areas[1].source, TagSource::kManual);
  EXPECT_EQ(map.knowledge.areas[1].seed_map, Point2(1, 2.5));
  EXPECT_EQ(map.knowledge.doors.at(0).id, DoorId{1});
  EXPECT_EQ(map.knowledge.doors.at(0).state, DoorState::kUnknown);
  EXPECT_EQ(map.knowledge.next_ids.area, 9U);
  EXPECT_EQ(map.knowledge.next_ids.door, 2U);
  ASSERT_EQ(read.warnings.size(), 2U);
  EXPECT_EQ(read.warnings[1], "x.yaml:5: unknown key 'floor' left out");
}

TEST(StoredText, WhatMakesNoSenseIsRefusedByPathLineAndKey) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"areas: [{seed: [1]}]", "x:2: seed must be [x, y], is a list of 1"},
      {"areas: [{name: a}]", "x:2: key 'seed' is missing"},
      {"areas: [{seed: [1, .nan]}]", "x:2: must be a number, is '.nan'"},
      {"areas: [{seed: [1, 0,5]}]", "x:2: seed must be [x, y], is a list of 3"},
      {"areas: [{id: 0, seed: [1, 2]}]",
       "x:2: id must be a whole number in [1, 4294967294], is '0'"},
      {"areas: [{id: 3, seed: [1, 2]},\n {id: 3, seed: [1, 2]}]",
       "x:3: area id 3 is there twice, first in line 2"},
      {"areas: [{seed: [1, 2], name: [a]}]", "x:2: name must be a text, is a list"},
      {"areas: [{seed: [1, 2], seed: [1, 2]}]", "x:2: key 'seed' is there twice"},
      {"areas: 5", "x:2: areas must be a list"},
      {"areas: [5]", "x:2: must be a mapping of keys to values"},
      {"doors: [{pose: [1, 2], width: -1}]", "x:2: width must not be negative, is '-1'"},
      {"doors: [{pose: [1, 2], state: ajar}]",
       "x:2: state must be unknown, open or closed, is 'ajar'"},
      {"doors: [{pose: [1, 2], absent: 1}]", "x:2: absent must be true or false, is '1'"},
      {"objects: [{pose: [1, 2, 3], source: me}]",
       "x:2: source must be automatic, manual or interaction, is 'me'"},
      {"pending: [{seed: [1, 2]}]", "x:2: key 'kind' is missing"},
      {"next_ids: {area: -1}", "x:2: area must be a whole number in [1, 4294967295], is '-1'"},
      {"history: 12", "x:2: history must be 16 hexadecimal digits"},
      {"areas: &a [*a]", "x:2: aliases are not supported"},
      {"areas: [[[[[[[[[[1]]]]]]]]]]", "x:2: nested too deeply"},
      {"areas: [", "x:3:"},
      {"{}: 1", "x:2: a key is not a text"},
      {"format_version: 1", "x:2: key 'format_version' is there twice"}};
  for (const auto& [line, message] : cases) {
    try {
      readSnapshot("format_version: 1\n" + line + "\nend_of_file: true\n", "x");
      ADD_FAILURE() << line << " was taken";
    } catch (const StorageError& error) {
      EXPECT_EQ(error.code(), StorageErrorCode::kCorrupt) << line;
      EXPECT_EQ(std::string(error.what()).substr(0, message.size()), message) << line;
    }
  }
}

TEST(StoredText, S6_EveryFlippedBitAndEveryMissingEndIsFound) {
  std::mt19937 random(3);
  Snapshot snapshot;
  agrid::apply(PutTag{test::areaNamed(1, "kitchen")}, snapshot.map.knowledge);
  const std::string text = snapshotText(snapshot);
  for (std::size_t bit = 0; bit < text.size() * 8; ++bit) {
    std::string flipped = text;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
    try {
      expectSame(readSnapshot(flipped, "x").snapshot, snapshot);
    } catch (const StorageError&) {
      continue;
    }
    EXPECT_GT(bit / 8, text.rfind("end_of_file") + 15) << "only the checksum itself may be false";
  }
  const std::size_t end = text.rfind("checksum: ");
  for (std::size_t size = 0; size + 1 < text.size(); ++size) {
    try {
      readSnapshot(text.substr(0, size), "x");
      EXPECT_GE(size + 1, end);
    } catch (const StorageError&) {
    }
  }
}

TEST(StoredText, S7_ANewerVersionIsToldApartWhateverElseItSays) {
  try {
    readSnapshot("# x\nformat_version: 2\nareas: {new: form}\n", "x");
    FAIL();
  } catch (const StorageError& error) {
    EXPECT_EQ(error.code(), StorageErrorCode::kVersion);
  }
}

TEST(StoredText, AFlippedBitIsFoundByItsChecksum) {
  std::string text = "some text that was written";
  const std::uint64_t checksum = checksumOf(text);
  EXPECT_EQ(checksumOf("123456789"), 0x995DC9BBDF1939FAu);  // the catalogue's check value
  text[5] = static_cast<char>(text[5] ^ 4);
  EXPECT_EQ(flippedByte(text, checksum), 5U);
  text[9] = static_cast<char>(text[9] ^ 1);
  EXPECT_FALSE(flippedByte(text, checksum));
}

TEST(StoredText, S15_AHundredThousandTagsStaySmall) {
  Snapshot snapshot;
  for (std::uint32_t id = 1; id <= 100000; ++id) {
    AreaTag area = test::areaNamed(id, "office " + std::to_string(id));
    area.category = "office";
    area.properties["floor"] = "2";
    snapshot.map.knowledge.areas.push_back(area);
  }
  snapshot.map.knowledge.next_ids.area = 100001;
  const auto now = [] { return std::chrono::steady_clock::now(); };
  const auto start = now();
  const std::string text = snapshotText(snapshot);
  const auto written = now();
  expectSame(readSnapshot(text, "x").snapshot, snapshot);
  const auto read = now();
  std::string by_hand = text;
  by_hand.insert(by_hand.find('\n', by_hand.find("  - {")), "  # by hand");
  const auto changed = now();
  expectSame(readSnapshot(by_hand, "x").snapshot, snapshot);
  const auto read_again = now();
  EXPECT_LT(text.size(), 50e6);
  using Seconds = std::chrono::duration<double>;
  std::cout << "100 000 tags: " << static_cast<double>(text.size()) / 1e6 << " MB, made in "
            << Seconds(written - start).count() << " s, read in " << Seconds(read - written).count()
            << " s, changed by hand in " << Seconds(read_again - changed).count() << " s\n";
}

}  // namespace
}  // namespace agrid
