// SPDX-License-Identifier: BSD-3-Clause
#include "plan_requests.h"

#include <QObject>
#include <QStringList>

namespace agrid_map_rviz {
namespace {

constexpr std::uint8_t kMaxRoutes = 4;
/// How far start and goal may be moved to where the robot fits [m].
constexpr double kTolerance = 0.5;

QString areasOf(const agrid_map::Route& route) {
  QStringList names;
  for (const std::string& name : route.names) names << QString::fromStdString(name);
  return names.join(" → ");
}

}  // namespace

agrid_map::PlanPath::Request pathRequest(const agrid_map::TopologicalGraph& graph,
                                         std::uint32_t start, const Place& goal) {
  agrid_map::PlanPath::Request request;
  request.goal_name = nameOf(graph, goal).toStdString();
  request.goal_at_anchor = true;
  request.tolerance = kTolerance;
  const agrid_map::Area* area = find(graph.areas, start);
  request.start_from_robot = !area;
  if (area) request.start.pose.position = area->anchor;
  return request;
}

agrid_map::PlanAreas::Request routesRequest(const agrid_map::TopologicalGraph& graph,
                                            std::uint32_t start, const Place& goal) {
  agrid_map::PlanAreas::Request request;
  request.goal = nameOf(graph, goal).toStdString();
  request.max_routes = kMaxRoutes;
  const agrid_map::Area* area = find(graph.areas, start);
  request.start_from_robot = !area;
  if (area) request.start = area->name;
  return request;
}

QString describe(const agrid_map::PlanPath::Response& response) {
  const QString message = QString::fromStdString(response.status.message);
  return QObject::tr("%1 m: %2").arg(response.length, 0, 'f', 1).arg(areasOf(response.route)) +
         (message.isEmpty() ? QString() : "; " + message);
}

QString describe(const agrid_map::Route& route) {
  return QObject::tr("%1 m: %2").arg(route.length, 0, 'f', 1).arg(areasOf(route));
}

}  // namespace agrid_map_rviz
