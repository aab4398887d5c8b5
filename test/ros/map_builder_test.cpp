// SPDX-License-Identifier: BSD-3-Clause
#include "ros/map_builder.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include <boost/make_shared.hpp>
#include <gtest/gtest.h>
#include <ros/time.h>

#include "drawn_maps.h"

namespace agrid_map_ros {
namespace {

class Builder : public testing::Test {
 protected:
  Builder() { ros::Time::init(); }

  static nav_msgs::OccupancyGridConstPtr shared(nav_msgs::OccupancyGrid map) {
    return boost::make_shared<const nav_msgs::OccupancyGrid>(std::move(map));
  }
  static nav_msgs::OccupancyGridConstPtr open(const std::string& frame = "map") {
    return shared(test::drawn(test::twoRoomsAndACloset(), frame));
  }

  MapBuilder::Listeners listeners() {
    return {[this](const SnapshotPtr& snapshot) { note(&built_, snapshot->frame()); },
            [this](const std::string& text) { note(&warned_, text); },
            [this](const std::string& text) { note(&failed_, text); }};
  }
  void note(std::vector<std::string>* list, const std::string& text) {
    const std::lock_guard<std::mutex> lock(mutex_);
    list->push_back(text);
    changed_.notify_all();
  }
  /// Waits until a list has this many entries; 60 s are more than anything here takes.
  bool waitFor(const std::vector<std::string>& list, std::size_t count) {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, std::chrono::seconds(60), [&] { return list.size() >= count; });
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::string> built_;
  std::vector<std::string> warned_;
  std::vector<std::string> failed_;
  PlaceKeeper keeper_{PlaceKeeper::Listeners{[](const SnapshotPtr&) {}, [](const std::string&) {},
                                             [](const std::string&) {}}};
  std::shared_ptr<const Parameters> parameters_ = std::make_shared<const Parameters>();
};

TEST_F(Builder, BuildsWhatIsOffered) {
  MapBuilder builder(keeper_, listeners());
  EXPECT_EQ(keeper_.snapshot(), nullptr);
  EXPECT_EQ(builder.state(), MapBuilder::State::kWaiting);
  EXPECT_FALSE(builder.rebuild());
  builder.setParameters(parameters_);
  builder.offer(open());
  ASSERT_TRUE(waitFor(built_, 1));
  const SnapshotPtr snapshot = keeper_.snapshot();
  EXPECT_EQ(snapshot->stamp.version, 1U);
  EXPECT_EQ(snapshot->map->area_map.areas.size(), 3U);
  EXPECT_EQ(builder.state(), MapBuilder::State::kReady);
}

TEST_F(Builder, L3_WaitsForParameters) {
  MapBuilder builder(keeper_, listeners());
  builder.offer(open());
  EXPECT_EQ(keeper_.snapshot(), nullptr);
  builder.setParameters(parameters_);
  EXPECT_TRUE(waitFor(built_, 1));
}

TEST_F(Builder, M18_AnotherFrameIsANewMap) {
  MapBuilder builder(keeper_, listeners());
  builder.setParameters(parameters_);
  builder.offer(open());
  ASSERT_TRUE(waitFor(built_, 1));
  builder.offer(open("world"));
  ASSERT_TRUE(waitFor(built_, 2));
  EXPECT_EQ(keeper_.snapshot()->frame(), "world");
  EXPECT_EQ(keeper_.snapshot()->stamp.version, 2U);
}

TEST_F(Builder, M19_TheSameMapAgainIsNotBuilt) {
  MapBuilder builder(keeper_, listeners());
  builder.setParameters(parameters_);
  builder.offer(open());
  ASSERT_TRUE(waitFor(built_, 1));
  const SnapshotPtr former = keeper_.snapshot();
  auto again = test::drawn(test::twoRoomsAndACloset());
  again.header.stamp = ros::Time(99);
  builder.offer(shared(again));
  builder.offer(shared(test::drawn(test::walledUp())));
  ASSERT_TRUE(waitFor(built_, 2));
  EXPECT_EQ(keeper_.snapshot()->stamp.version, 2U);
  EXPECT_NE(keeper_.snapshot(), former);
}

TEST_F(Builder, RebuildMakesTheSameMapAnew) {
  MapBuilder builder(keeper_, listeners());
  builder.setParameters(parameters_);
  builder.offer(open());
  ASSERT_TRUE(waitFor(built_, 1));
  EXPECT_TRUE(builder.rebuild());
  ASSERT_TRUE(waitFor(built_, 2));
  EXPECT_EQ(keeper_.snapshot()->stamp.version, 2U);
}

TEST_F(Builder, M1_ABadMapLeavesTheFormerOne) {
  MapBuilder builder(keeper_, listeners());
  builder.setParameters(parameters_);
  builder.offer(open());
  ASSERT_TRUE(waitFor(built_, 1));
  const SnapshotPtr former = keeper_.snapshot();
  auto bad = test::drawn(test::walledUp());
  bad.data.pop_back();
  builder.offer(shared(bad));
  ASSERT_TRUE(waitFor(failed_, 1));
  EXPECT_EQ(keeper_.snapshot(), former);
  EXPECT_EQ(builder.state(), MapBuilder::State::kFailed);
  EXPECT_TRUE(builder.rebuild());  // the one in use
  ASSERT_TRUE(waitFor(built_, 2));
  EXPECT_EQ(keeper_.snapshot()->map->map().digest(), former->map->map().digest());
}

TEST_F(Builder, M14_MapsThatSayNothing) {
  MapBuilder builder(keeper_, listeners());
  builder.setParameters(parameters_);
  std::size_t count = 0;
  for (const char c : {'?', '#', '.'}) {
    builder.offer(shared(test::drawn(std::vector<std::string>(3, std::string(4, c)))));
    ASSERT_TRUE(waitFor(built_, ++count)) << c;
    EXPECT_LE(keeper_.snapshot()->map->area_map.areas.size(), 1U) << c;
  }
  EXPECT_FALSE(warned_.empty());
}

TEST_F(Builder, M24_OfManyMapsTheNewestIsBuilt) {
  MapBuilder builder(keeper_, listeners());
  builder.setParameters(parameters_);
  for (int i = 0; i < 200; ++i) builder.offer(open("frame_" + std::to_string(i)));
  const auto newest_is_built = [this] {
    return std::find(built_.begin(), built_.end(), "frame_199") != built_.end();
  };
  std::unique_lock<std::mutex> lock(mutex_);
  ASSERT_TRUE(changed_.wait_for(lock, std::chrono::seconds(60), newest_is_built));
  EXPECT_LT(built_.size(), 200U);
  EXPECT_TRUE(failed_.empty());
}

TEST_F(Builder, L1_EndsWhileItBuilds) {
  MapBuilder builder(keeper_, listeners());
  builder.setParameters(parameters_);
  builder.offer(open());
}

}  // namespace
}  // namespace agrid_map_ros
