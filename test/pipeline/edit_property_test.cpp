// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "agrid/pipeline/edit.h"
#include "agrid/tags/name.h"
#include "support/edited_map.h"

namespace agrid {
namespace {

using test::EditedMap;

/// Rooms of random sizes with doors between most of them, at 0.1 m, and unknown space to the right.
OccupancyMap randomRooms(std::mt19937& random) {
  std::vector<std::string> rows(62, std::string(100, '.') + std::string(15, '?'));
  rows.front() = rows.back() = std::string(115, '#');
  for (std::string& row : rows) row[0] = row[99] = '#';
  for (std::size_t x = 20 + random() % 15; x < 85; x += 20 + random() % 15) {
    for (std::string& row : rows) row[x] = '#';
    const std::size_t y = 3 + random() % 45;
    for (std::size_t gap = 0; gap < 9; ++gap) rows[y + gap][x] = '.';
  }
  return test::asciiMap(rows, 0.1);
}

std::vector<std::string> namesOf(const std::string& name, const Properties& properties) {
  std::vector<std::string> names;
  if (!name.empty()) names.push_back(foldCase(name));
  const auto alias = properties.find("alias");
  std::istringstream list(alias == properties.end() ? "" : alias->second);
  for (std::string part; std::getline(list, part, ',');) {
    part.erase(0, part.find_first_not_of(' '));
    if (!part.empty()) names.push_back(foldCase(part));
  }
  return names;
}

/// The things of one kind, checked on the way in.
class Census {
 public:
  explicit Census(std::uint32_t next) : next_(next) {}

  template <typename T>
  void add(const T& tag) {
    const auto id = static_cast<std::uint32_t>(tag.id);
    EXPECT_TRUE(id > 0 && id < next_) << id;
    EXPECT_TRUE(ids_.insert(id).second) << "twice: " << id;
    std::set<std::string> own;
    for (const std::string& name : namesOf(tag.name, tag.properties)) own.insert(name);
    for (const std::string& name : own) {
      EXPECT_TRUE(names_.insert(name).second) << "two are called " << name;
    }
  }

 private:
  std::uint32_t next_;
  std::set<std::uint32_t> ids_;
  std::set<std::string> names_;
};

template <typename T>
void expectSorted(const std::vector<T>& tags) {
  EXPECT_TRUE(
      std::is_sorted(tags.begin(), tags.end(), [](const T& a, const T& b) { return a.id < b.id; }));
}

void expectSound(const Knowledge& known) {
  std::map<TagKind, Census> census{{TagKind::kArea, Census(known.next_ids.area)},
                                   {TagKind::kDoor, Census(known.next_ids.door)},
                                   {TagKind::kObject, Census(known.next_ids.object)}};
  for (const AreaTag& tag : known.areas) census.at(TagKind::kArea).add(tag);
  for (const DoorTag& tag : known.doors) census.at(TagKind::kDoor).add(tag);
  for (const ObjectTag& tag : known.objects) census.at(TagKind::kObject).add(tag);
  for (const PendingTag& pending : known.pending) {
    std::visit([&](const auto& tag) { census.at(kindOf(pending.tag)).add(tag); }, pending.tag);
    EXPECT_FALSE(pending.reason.empty());
  }
  expectSorted(known.areas);
  expectSorted(known.doors);
  expectSorted(known.objects);
}

class Requests {
 public:
  explicit Requests(std::uint32_t seed) : random_(seed) {}

  EditRequest any() {
    const auto id = static_cast<std::uint32_t>(1 + below(8));
    switch (below(8)) {
      case 0:
        return RemoveTag{static_cast<TagKind>(1 + below(3)), id};
      case 1:
        return SetDoor{DoorId{id}, static_cast<DoorState>(below(3)), source()};
      default:
        return addition(below(3));
    }
  }

  AddTag addition(std::uint32_t kind) {
    AddTag request;
    const Pose2 pose{place(), uniform(-4, 4)};
    const std::uint32_t id = below(3) > 0 ? 0 : 1 + below(8);
    const std::string name =
        pick({"", "", "kitchen", "Kitchen", "hall", "lab", "area_2", "door_1"});
    const Properties properties{{"alias", pick({"", "", "", "hall", "galley, Lab"})}};
    if (kind == 0) {
      request.tag =
          AreaTag{AreaId{id}, name, pick({"", "office"}), pose.position, source(), properties, {}};
    } else if (kind == 1) {
      request.tag = DoorTag{
          DoorId{id}, name,       pose, below(2) * uniform(0, 2), static_cast<DoorState>(below(3)),
          source(),   properties, false};
    } else {
      request.tag = ObjectTag{ObjectId{id}, name, pick({"", "fridge"}), pose,
                              {0.5, 0.5},   1,    TagSource::kManual,   properties};
    }
    request.replace = below(3) == 0;
    request.force = below(3) == 0;
    request.placement = static_cast<Placement>(below(6) == 0 ? 2 : below(2));
    return request;
  }

 private:
  std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(random_() % end); }
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  std::string pick(const std::vector<std::string>& texts) {
    return texts[random_() % texts.size()];
  }
  TagSource source() { return static_cast<TagSource>(below(3)); }
  /// One of a few places, so that some are said again.
  Point2 place() {
    if (below(4) == 0) return {uniform(-0.2, 11.7), uniform(-0.2, 6.4)};
    return {1.27 + 1.53 * below(7), 0.73 + 1.49 * below(4)};
  }

  std::mt19937 random_;
};

Knowledge after(const Knowledge& known, const Edit& edit) {
  Knowledge result = known;
  for (const Change& change : edit.changes) apply(change, result);
  return result;
}

struct Tally {
  int accepted = 0;
  int unchanged = 0;
  std::map<EditErrorCode, int> refused;
};

/// Decides on a request, and checks what must hold for any.
void expectSoundEdit(const EditRequest& request, EditedMap& map, Tally& tally) {
  const Knowledge before = map.known();
  try {
    const Edit decided = decide(request, map.map());
    expectSound(after(before, decided));
    const Edit edit = map.edit(request);
    EXPECT_TRUE(edit.id == decided.id && edit.message == decided.message);
    EXPECT_FALSE(edit.message.empty());
    expectSound(map.known());
    ++(edit.changed() ? tally.accepted : tally.unchanged);
    EXPECT_LE(before.next_ids.area, map.known().next_ids.area);
    EXPECT_LE(before.next_ids.door, map.known().next_ids.door);
    if (std::holds_alternative<RemoveTag>(request)) {
      EXPECT_THROW(map.edit(request), EditError);
    } else {
      const Edit again = map.edit(request);
      EXPECT_FALSE(again.changed()) << edit.message << "\n" << again.message;
      EXPECT_EQ(again.id, edit.id);
    }
  } catch (const EditError& error) {
    ++tally.refused[error.code()];
    EXPECT_TRUE(difference(before, map.known()).empty()) << error.what();
  }
}

TEST(EditProperty, AnyEditKeepsWhatIsKnownSoundAndSaidAgainChangesNothing) {
  Tally tally;
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    EditedMap map(annotate(
        extractStructure(std::make_shared<const OccupancyMap>(randomRooms(random)), {}), {}, {}));
    Requests requests(seed);
    for (int i = 0; i < 60 && !testing::Test::HasFailure(); ++i) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", request " << i);
      expectSoundEdit(requests.any(), map, tally);
    }
  }
  EXPECT_GT(tally.accepted, 100);
  for (const EditErrorCode code : {EditErrorCode::kInvalid, EditErrorCode::kUnknownName,
                                   EditErrorCode::kNameTaken, EditErrorCode::kOutside}) {
    EXPECT_GT(tally.refused[code], 5) << static_cast<int>(code);
  }
}

}  // namespace
}  // namespace agrid
