// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <string>
#include <vector>

#ifndef Q_MOC_RUN
#include <ros/ros.h>

#include <agrid_map/GetGraph.h>
#include <agrid_map/PlanAreas.h>
#include <agrid_map/PlanPath.h>
#include <agrid_map/TopologicalGraph.h>

#include "places.h"
#include "service_worker.h"
#endif

namespace agrid_map_rviz {

/// What panel, tool and display share: the newest graph of a node, its services, and what was done,
/// so that either takes back what the other one did. Lives and answers in the window's thread.
class EditSession : public QObject {
  Q_OBJECT

 public:
  /// The session with a node, made when it is asked for first.
  /// @param owner  what it lives as long as, and who shares an owner shares the session
  /// @param node   the nodelet's name, e.g. agrid
  static EditSession& of(QObject& owner, const QString& node);

  /// The newest graph; empty until one came.
  const agrid_map::TopologicalGraph& graph() const { return *graph_; }
  const QString& node() const { return node_; }

  /// Asks for changes, one after the other, up to the first that is refused.
  /// @param what  of the sentence for the user: 'kitchen renamed'
  void apply(const QString& what, const std::vector<Change>& changes);
  /// Takes back the last change that was made or asked for here.
  void undo();
  bool canUndo() const { return !done_.empty(); }

  void planPath(const agrid_map::PlanPath::Request& request);
  void planAreas(const agrid_map::PlanAreas::Request& request);
  /// Has one of the planned ways shown; one without areas: none.
  void chooseRoute(const agrid_map::Route& route) { Q_EMIT routeChosen(route); }

 Q_SIGNALS:
  void graphChanged();
  /// How a request ended, as a sentence.
  void answered(bool success, const QString& sentence);
  void pathPlanned(const agrid_map::PlanPath::Response& response);
  void routesPlanned(const agrid_map::PlanAreas::Response& response);
  void routeChosen(const agrid_map::Route& route);
  void undoChanged(bool possible);

 private:
  struct Done {
    QString what;
    std::vector<Change> inverse;
  };
  /// How far the changes of one request came.
  struct Result {
    agrid_map::GetGraph::Response before;
    std::vector<std::uint32_t> ids;  ///< one for each change that was made
    agrid_map::Status status;
  };

  EditSession(QObject& owner, const QString& node);
  std::string service(const char* name) const;
  Result make(const std::vector<Change>& changes);
  void finish(const QString& what, const std::vector<Change>& changes, const Result& result);
  void undoLast();
  void finishUndo(const Done& done, const Result& result);
  void setGraph(const agrid_map::TopologicalGraph::ConstPtr& graph);

  QString node_;
  agrid_map::TopologicalGraph::ConstPtr graph_;
  std::vector<Done> done_;
  ros::Subscriber subscriber_;
  ServiceWorker worker_;  // last: its jobs use what is above
};

}  // namespace agrid_map_rviz
