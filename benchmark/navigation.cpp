// SPDX-License-Identifier: BSD-3-Clause
// Global planners of move_base on the same costmap and the same goals: success, paths that are not
// free, length, cost, time. Started by benchmark/navigation/planners.launch.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <queue>
#include <random>
#include <string>
#include <vector>

#include <costmap_2d/costmap_2d_ros.h>
#include <nav_core/base_global_planner.h>
#include <pluginlib/class_loader.hpp>
#include <ros/ros.h>
#include <tf2_ros/buffer.h>

namespace {

using costmap_2d::Costmap2D;
using Pose = geometry_msgs::PoseStamped;
using Path = std::vector<Pose>;

constexpr int kBlocked = costmap_2d::INSCRIBED_INFLATED_OBSTACLE;

bool isOpen(const Costmap2D& map, unsigned index) {
  const int cost = map.getCharMap()[index];
  return cost < kBlocked || cost == costmap_2d::NO_INFORMATION;
}

/// What every pixel is connected with by the pixels' sides; -1 where it is blocked.
std::vector<int> components(const Costmap2D& map) {
  const unsigned width = map.getSizeInCellsX();
  const unsigned count = width * map.getSizeInCellsY();
  std::vector<int> component(count, -1);
  int next = 0;
  for (unsigned seed = 0; seed < count; ++seed) {
    if (component[seed] >= 0 || !isOpen(map, seed)) continue;
    std::queue<unsigned> queue({seed});
    component[seed] = next;
    while (!queue.empty()) {
      const unsigned i = queue.front();
      queue.pop();
      const auto visit = [&](unsigned k) {
        if (component[k] >= 0 || !isOpen(map, k)) return;
        component[k] = next;
        queue.push(k);
      };
      if (i % width > 0) visit(i - 1);
      if (i % width + 1 < width) visit(i + 1);
      if (i >= width) visit(i - width);
      if (i + width < count) visit(i + width);
    }
    ++next;
  }
  return component;
}

/// What a planner made of a goal.
struct Outcome {
  bool found = false;
  bool free = true;   ///< no point of the path is in a blocked pixel, but the start's
  double length = 0;  ///< [m]
  double cost = 0;    ///< [m], each part times 1 + 3 / 50 of the pixel's cost
  double seconds = 0;
  Path path;
};

void measure(const Costmap2D& map, Outcome& outcome) {
  constexpr int kParts = 16;
  unsigned start_x = 0, start_y = 0;
  const geometry_msgs::Point& start = outcome.path.front().pose.position;
  if (!map.worldToMap(start.x, start.y, start_x, start_y)) return;
  for (std::size_t i = 1; i < outcome.path.size(); ++i) {
    const geometry_msgs::Point& a = outcome.path[i - 1].pose.position;
    const geometry_msgs::Point& b = outcome.path[i].pose.position;
    const double step = std::hypot(b.x - a.x, b.y - a.y);
    outcome.length += step;
    for (int k = 0; k < kParts; ++k) {
      const double t = (k + 0.5) / kParts;
      unsigned x = 0, y = 0;
      if (!map.worldToMap(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), x, y)) continue;
      const int cost = map.getCost(x, y);
      const bool at_start = x == start_x && y == start_y;
      if (cost >= kBlocked && cost != costmap_2d::NO_INFORMATION && !at_start) outcome.free = false;
      outcome.cost += step / kParts * (1 + 3.0 / 50.0 * std::min(cost, kBlocked - 1));
    }
  }
}

struct Totals {
  std::string name;
  int goals = 0, found = 0, false_no = 0, not_free = 0;
  std::vector<double> length_ratio, cost_ratio, milliseconds;
};

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1) + 0.5)];
}

class Comparison {
 public:
  Comparison(const std::vector<std::string>& names, costmap_2d::Costmap2DROS& costmap)
      : loader_("nav_core", "nav_core::BaseGlobalPlanner"), costmap_(costmap) {
    for (const std::string& name : names) {
      planners_.push_back(loader_.createUniqueInstance(name));
      planners_.back()->initialize(loader_.getName(name), &costmap);
    }
    for (auto* totals : {&clear_, &blocked_}) {
      totals->resize(names.size());
      for (std::size_t i = 0; i < names.size(); ++i) (*totals)[i].name = names[i];
    }
  }

  /// Plans to each of the goals, then again with a disc of obstacles on the middle of the path.
  void run(int goals, std::uint32_t seed) {
    std::mt19937 random(seed);
    const Pose warm_up = anywhere(random);
    for (const auto& planner : planners_) planOnce(*planner, warm_up, anywhere(random));
    for (int i = 0; i < goals && ros::ok(); ++i) {
      const Pose start = anywhere(random);
      const Pose goal = anywhere(random);
      const Path path = compare(start, goal, clear_);
      double length = 0;
      for (std::size_t k = 1; k < path.size(); ++k) length += distance(path[k - 1], path[k]);
      if (length > 4) withObstacle(path[path.size() / 2], [&] { compare(start, goal, blocked_); });
    }
  }

  void print() const {
    for (const auto* totals : {&clear_, &blocked_}) {
      std::printf(
          "\n| %s | found | false no | not free | length: median, max | cost: median, max "
          "| ms: median, p95, max |\n|---|---|---|---|---|---|---|\n",
          totals == &clear_ ? "costmap as it is" : "an obstacle on the way");
      for (const Totals& t : *totals) {
        std::printf("| %s | %d of %d | %d | %d | %.3f, %.3f | %.3f, %.3f | %.1f, %.1f, %.1f |\n",
                    t.name.c_str(), t.found, t.goals, t.false_no, t.not_free,
                    quantile(t.length_ratio, 0.5), quantile(t.length_ratio, 1),
                    quantile(t.cost_ratio, 0.5), quantile(t.cost_ratio, 1),
                    quantile(t.milliseconds, 0.5), quantile(t.milliseconds, 0.95),
                    quantile(t.milliseconds, 1));
      }
    }
    std::fflush(stdout);
  }

 private:
  static double distance(const Pose& a, const Pose& b) {
    return std::hypot(b.pose.position.x - a.pose.position.x, b.pose.position.y - a.pose.position.y);
  }

  /// The middle of a random pixel that may be entered and is known.
  Pose anywhere(std::mt19937& random) const {
    const Costmap2D& map = *costmap_.getCostmap();
    const unsigned count = map.getSizeInCellsX() * map.getSizeInCellsY();
    unsigned index = 0;
    do index = static_cast<unsigned>(random() % count);
    while (map.getCharMap()[index] >= kBlocked);
    Pose pose;
    pose.header.frame_id = costmap_.getGlobalFrameID();
    pose.pose.orientation.w = 1;
    map.mapToWorld(index % map.getSizeInCellsX(), index / map.getSizeInCellsX(),
                   pose.pose.position.x, pose.pose.position.y);
    return pose;
  }

  Outcome planOnce(nav_core::BaseGlobalPlanner& planner, const Pose& start, const Pose& goal) {
    Outcome outcome;
    const auto before = std::chrono::steady_clock::now();
    outcome.found = planner.makePlan(start, goal, outcome.path) && !outcome.path.empty();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - before;
    outcome.seconds = took.count();
    return outcome;
  }

  /// @return the first planner's path
  Path compare(const Pose& start, const Pose& goal, std::vector<Totals>& totals) {
    Costmap2D& map = *costmap_.getCostmap();
    const Costmap2D as_it_was(map);
    std::vector<Outcome> outcomes;
    for (const auto& planner : planners_) {
      outcomes.push_back(planOnce(*planner, start, goal));
      if (outcomes.back().found) measure(as_it_was, outcomes.back());
      map = as_it_was;  // global_planner draws into it
    }
    unsigned x = 0, y = 0;
    const std::vector<int> component = components(as_it_was);
    map.worldToMap(start.pose.position.x, start.pose.position.y, x, y);
    const int from = component[map.getIndex(x, y)];
    map.worldToMap(goal.pose.position.x, goal.pose.position.y, x, y);
    const bool connected = from >= 0 && from == component[map.getIndex(x, y)];
    const bool all = std::all_of(outcomes.begin(), outcomes.end(),
                                 [](const Outcome& outcome) { return outcome.found; });
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      Totals& t = totals[i];
      const Outcome& outcome = outcomes[i];
      ++t.goals;
      t.found += outcome.found ? 1 : 0;
      t.false_no += connected && !outcome.found ? 1 : 0;
      t.not_free += outcome.found && !outcome.free ? 1 : 0;
      t.milliseconds.push_back(1000 * outcome.seconds);
      if (!all || outcomes[0].length < 0.1) continue;
      t.length_ratio.push_back(outcome.length / outcomes[0].length);
      t.cost_ratio.push_back(outcome.cost / outcomes[0].cost);
    }
    return outcomes[0].path;
  }

  /// Does something while a disc of 0.5 m around a place is an obstacle, 0.2 m more inscribed.
  template <typename Action>
  void withObstacle(const Pose& place, const Action& action) {
    Costmap2D& map = *costmap_.getCostmap();
    const Costmap2D as_it_was(map);
    const auto& at = place.pose.position;
    for (unsigned y = 0; y < map.getSizeInCellsY(); ++y) {
      for (unsigned x = 0; x < map.getSizeInCellsX(); ++x) {
        double wx = 0, wy = 0;
        map.mapToWorld(x, y, wx, wy);
        const double away = std::hypot(wx - at.x, wy - at.y);
        const int cost = away <= 0.5 ? costmap_2d::LETHAL_OBSTACLE : away <= 0.7 ? kBlocked : 0;
        if (cost > map.getCost(x, y)) map.setCost(x, y, static_cast<unsigned char>(cost));
      }
    }
    action();
    map = as_it_was;
  }

  pluginlib::ClassLoader<nav_core::BaseGlobalPlanner> loader_;
  costmap_2d::Costmap2DROS& costmap_;
  std::vector<pluginlib::UniquePtr<nav_core::BaseGlobalPlanner>> planners_;
  std::vector<Totals> clear_, blocked_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "navigation");
  const ros::NodeHandle node("~");
  ros::AsyncSpinner spinner(2);
  spinner.start();
  tf2_ros::Buffer transforms;
  geometry_msgs::TransformStamped robot;  // somewhere: the goals have starts of their own
  robot.header.frame_id = "map";
  robot.child_frame_id = "base_link";
  robot.transform.rotation.w = 1;
  transforms.setTransform(robot, "here", true);
  transforms.setUsingDedicatedThread(true);  // nobody else will set any
  costmap_2d::Costmap2DROS costmap("costmap", transforms);
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(120);
  while (ros::ok() && !costmap.isCurrent() && ros::WallTime::now() < deadline)
    ros::WallDuration(0.2).sleep();
  ros::WallDuration(node.param("settle", 3.0)).sleep();
  costmap.stop();
  Comparison comparison(
      node.param("planners", std::vector<std::string>{"agrid_map/AGridPlanner",
                                                      "global_planner/GlobalPlanner"}),
      costmap);
  ros::WallDuration(1).sleep();  // for the graph
  comparison.run(node.param("goals", 100), static_cast<std::uint32_t>(node.param("seed", 1)));
  comparison.print();
  return 0;
}
