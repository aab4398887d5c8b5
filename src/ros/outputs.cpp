// SPDX-License-Identifier: BSD-3-Clause
#include "ros/outputs.h"

#include "agrid_map_ros/markers.h"
#include "ros/boundary.h"

namespace agrid_map_ros {

Outputs::Outputs(ros::NodeHandle& private_nh, EventLog& log)
    : log_(log),
      agrid_(private_nh.advertise<agrid_map::AGrid>("agrid", 1, true)),
      graph_(private_nh.advertise<agrid_map::TopologicalGraph>("graph", 1, true)),
      markers_(private_nh.advertise<visualization_msgs::MarkerArray>("markers", 1, true)),
      areas_(private_nh.advertise<nav_msgs::OccupancyGrid>("areas", 1, true)),
      plan_(private_nh.advertise<nav_msgs::Path>("plan", 1, true)),
      thread_([this] { run(); }) {}

Outputs::~Outputs() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void Outputs::offer(const SnapshotPtr& snapshot) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    newest_ = snapshot;
  }
  wake_.notify_all();
}

void Outputs::run() {
  for (;;) {
    SnapshotPtr snapshot;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      wake_.wait(lock, [this] { return stopping_ || newest_; });
      if (stopping_) return;
      snapshot.swap(newest_);
    }
    attempt(log_, "outputs", [&] { publish(*snapshot); });
  }
}

void Outputs::publish(const Snapshot& snapshot) {
  agrid_.publish(gridToMsg(*snapshot.map, snapshot.stamp));
  areas_.publish(areasToMsg(*snapshot.map, snapshot.stamp.header));
  markers_.publish(makeMarkers(*snapshot.map, snapshot.stamp.header));
  // last: who has the graph may expect the others to be there
  graph_.publish(graphToMsg(*snapshot.map, snapshot.stamp));
}

void Outputs::publishPlan(const nav_msgs::Path& path) { plan_.publish(path); }

}  // namespace agrid_map_ros
