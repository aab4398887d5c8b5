// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include <nav_msgs/OccupancyGrid.h>

#include "ros/place_keeper.h"

namespace agrid_map_ros {

/// Makes drafts of snapshots out of maps in a thread of its own, for the keeper to lay what is
/// known over them. While it works, the former snapshot stays in use; of maps that arrive meanwhile
/// only the newest is kept.
class MapBuilder {
 public:
  /// What the builder has to tell, from its own thread and one at a time.
  struct Listeners {
    std::function<void(const SnapshotPtr&)> built;
    std::function<void(const std::string&)> warned;  ///< accepted, but looks wrong
    std::function<void(const std::string&)> failed;  ///< refused; the former snapshot stays
  };

  /// kFailed: the last map was refused; the former one, if any, stays in use.
  enum class State { kWaiting, kBuilding, kReady, kFailed };

  /// @param keeper  must outlive this
  MapBuilder(PlaceKeeper& keeper, Listeners listeners);
  /// Ends after the stage of the pipeline that is running.
  ~MapBuilder();
  MapBuilder(const MapBuilder&) = delete;
  MapBuilder& operator=(const MapBuilder&) = delete;

  /// Takes effect with the next map; no map is built before it was called.
  void setParameters(std::shared_ptr<const Parameters> parameters);
  /// A map to build, unless it is the one in use: the same pixels in the same frame.
  void offer(nav_msgs::OccupancyGridConstPtr map);
  /// Builds the newest map again, even if it is the same.
  /// @return false if there is none
  bool rebuild();

  State state() const;

 private:
  void run();
  void build(const nav_msgs::OccupancyGridConstPtr& map, bool forced);
  /// @return false if the builder is to end
  bool fill(Snapshot& snapshot, std::shared_ptr<const agrid::OccupancyMap> metric) const;
  void accept(const nav_msgs::OccupancyGridConstPtr& map);
  void refuse(const std::string& error);

  PlaceKeeper& keeper_;
  Listeners listeners_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::shared_ptr<const Parameters> parameters_;
  nav_msgs::OccupancyGridConstPtr newest_;
  nav_msgs::OccupancyGridConstPtr accepted_;  ///< what the snapshot was made from
  bool pending_ = false;
  bool forced_ = false;
  State state_ = State::kWaiting;
  std::atomic<bool> stopping_{false};
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace agrid_map_ros
