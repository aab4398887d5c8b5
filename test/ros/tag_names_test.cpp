// SPDX-License-Identifier: BSD-3-Clause
// What people call things is shown and stored, and nothing else is done with it.
#include <agrid_map/TopologicalGraph.h>

#include "agrid_map_ros/conversions.h"
#include "agrid_map_ros/markers.h"
#include "place_fixture.h"
#include "ros/edit_answers.h"

namespace agrid_map_ros {
namespace {

const std::vector<std::string> kWildNames{"../../etc/x", "/",   "..",     ".hidden",  ";id;",
                                          "$(touch x)",  "`x`", "%s%n%s", "a\\b",     "map",
                                          "x.yaml",      "~/x", "*",      "<script>", "C:\\x"};

class Names : public test::PlaceFixture {
 protected:
  Names() {
    keeper_ = keeper();
    keeper_->adopt(draft(test::twoRoomsAndACloset()));
    for (const std::string& name : kWildNames) keeper_->edit(put(object(name)));
    auto area = kitchen();
    area.name = kWildNames.front();
    keeper_->edit(put(area));
  }
  std::unique_ptr<PlaceKeeper> keeper_;
};

TEST_F(Names, T10_NoNameBecomesAPath) {
  keeper_->saveAs("copy");
  keeper_.reset();  // folds
  for (const auto& [name, content] : agrid::test::contentsOfFolder(folder_.path())) {
    EXPECT_TRUE(name.rfind("place.", 0) == 0 || name.rfind("copy.", 0) == 0) << name;
    EXPECT_TRUE(std::filesystem::is_regular_file(folder_ / name)) << name;
  }
  std::vector<std::string> stored;
  const auto known = agrid::readStoredMap(folder_ / "place.yaml").map.knowledge;
  for (const auto& tag : known.objects) stored.push_back(tag.name);
  EXPECT_EQ(stored, kWildNames);
}

TEST_F(Names, T10_NamesAreTheTextsOfMarkersOnly) {
  std_msgs::Header header;
  header.frame_id = "map";
  std::size_t shown = 0;
  for (const auto& marker : makeMarkers(*keeper_->snapshot()->map, header).markers) {
    EXPECT_EQ(marker.header.frame_id, "map");
    EXPECT_TRUE(marker.mesh_resource.empty());
    EXPECT_EQ(std::count(kWildNames.begin(), kWildNames.end(), marker.ns), 0) << marker.ns;
    shown +=
        static_cast<std::size_t>(std::count(kWildNames.begin(), kWildNames.end(), marker.text));
  }
  EXPECT_EQ(shown, kWildNames.size() + 1);  // the area has the first one as well
}

TEST_F(Names, T10_NoNameBecomesAFrame) {
  std_msgs::Header header;
  header.frame_id = "map";
  for (const auto& tag : keeper_->snapshot()->map->knowledge.objects) {
    EXPECT_EQ(tagOf(tag, header).header.frame_id, "map");
  }
}

}  // namespace
}  // namespace agrid_map_ros
