// SPDX-License-Identifier: BSD-3-Clause
#include "edit_session.h"

#include <boost/make_shared.hpp>

namespace agrid_map_rviz {
namespace {

/// Calls the service that a change belongs to.
struct Caller {
  ServiceWorker& worker;
  std::string node;
  std::uint32_t id = 0;  ///< what add_tag answered

  agrid_map::Status operator()(agrid_map::AddTag::Request request) {
    agrid_map::AddTag::Response response;
    worker.call<agrid_map::AddTag>(node + "/add_tag", request, response);
    id = response.id;
    return response.status;
  }
  agrid_map::Status operator()(agrid_map::RemoveTag::Request request) {
    agrid_map::RemoveTag::Response response;
    worker.call<agrid_map::RemoveTag>(node + "/remove_tag", request, response);
    return response.status;
  }
  agrid_map::Status operator()(agrid_map::SetDoor::Request request) {
    agrid_map::SetDoor::Response response;
    worker.call<agrid_map::SetDoor>(node + "/set_door", request, response);
    return response.status;
  }
};

QString sentence(const QString& what, const agrid_map::Status& status) {
  const QString message = QString::fromStdString(status.message);
  if (status.code != agrid_map::Status::SUCCESS) return message;
  return message.isEmpty() ? what : what + ": " + message;
}

}  // namespace

EditSession& EditSession::of(QObject& owner, const QString& node) {
  for (QObject* child : owner.children()) {
    auto* session = qobject_cast<EditSession*>(child);
    if (session && session->node_ == node) return *session;
  }
  return *new EditSession(owner, node);
}

EditSession::EditSession(QObject& owner, const QString& node)
    : QObject(&owner), node_(node), graph_(boost::make_shared<agrid_map::TopologicalGraph>()) {
  subscriber_ = ros::NodeHandle().subscribe(service("graph"), 1, &EditSession::setGraph, this);
}

std::string EditSession::service(const char* name) const {
  return node_.toStdString() + "/" + name;
}

void EditSession::setGraph(const agrid_map::TopologicalGraph::ConstPtr& graph) {
  graph_ = graph;
  Q_EMIT graphChanged();
}

EditSession::Result EditSession::make(const std::vector<Change>& changes) {
  Result result;
  agrid_map::GetGraph::Request request;
  // the topic may be behind: the service shows every change that was answered
  worker_.call<agrid_map::GetGraph>(service("get_graph"), request, result.before);
  result.status = result.before.status;
  if (result.status.code != agrid_map::Status::SUCCESS) return result;
  for (const Change& change : changes) {
    Caller caller{worker_, node_.toStdString()};
    result.status = std::visit(caller, change);
    if (result.status.code != agrid_map::Status::SUCCESS) break;
    result.ids.push_back(caller.id);
  }
  return result;
}

void EditSession::apply(const QString& what, const std::vector<Change>& changes) {
  worker_.post([this, what, changes] {
    const Result result = make(changes);
    QMetaObject::invokeMethod(
        this, [this, what, changes, result] { finish(what, changes, result); },
        Qt::QueuedConnection);
  });
}

void EditSession::finish(const QString& what, const std::vector<Change>& changes,
                         const Result& result) {
  Done done{what, {}};
  for (std::size_t i = result.ids.size(); i-- > 0;) {
    const std::vector<Change> inverse = inverseOf(result.before.graph, changes[i], result.ids[i]);
    done.inverse.insert(done.inverse.end(), inverse.begin(), inverse.end());
  }
  if (!done.inverse.empty()) {
    done_.push_back(done);
    Q_EMIT undoChanged(true);
  }
  Q_EMIT answered(result.status.code == agrid_map::Status::SUCCESS, sentence(what, result.status));
}

void EditSession::undo() {
  // behind what is still asked for, so that it takes that back
  worker_.post([this] {
    QMetaObject::invokeMethod(
        this, [this] { undoLast(); }, Qt::QueuedConnection);
  });
}

void EditSession::undoLast() {
  if (done_.empty()) {
    Q_EMIT answered(false, tr("nothing was changed here that could be taken back"));
    return;
  }
  const Done done = done_.back();
  done_.pop_back();
  Q_EMIT undoChanged(canUndo());
  worker_.post([this, done] {
    const Result result = make(done.inverse);
    QMetaObject::invokeMethod(
        this, [this, done, result] { finishUndo(done, result); }, Qt::QueuedConnection);
  });
}

void EditSession::finishUndo(const Done& done, const Result& result) {
  const bool success = result.status.code == agrid_map::Status::SUCCESS;
  if (!success) {
    // what was not taken back can be tried again
    Done rest = done;
    rest.inverse.erase(rest.inverse.begin(),
                       rest.inverse.begin() + static_cast<std::ptrdiff_t>(result.ids.size()));
    done_.push_back(rest);
    Q_EMIT undoChanged(true);
  }
  Q_EMIT answered(success, sentence(tr("taken back: %1").arg(done.what), result.status));
}

void EditSession::planPath(const agrid_map::PlanPath::Request& request) {
  worker_.post([this, request] {
    agrid_map::PlanPath::Response response;
    worker_.call<agrid_map::PlanPath>(service("plan_path"), request, response);
    QMetaObject::invokeMethod(
        this, [this, response] { Q_EMIT pathPlanned(response); }, Qt::QueuedConnection);
  });
}

void EditSession::planAreas(const agrid_map::PlanAreas::Request& request) {
  worker_.post([this, request] {
    agrid_map::PlanAreas::Response response;
    worker_.call<agrid_map::PlanAreas>(service("plan_areas"), request, response);
    QMetaObject::invokeMethod(
        this, [this, response] { Q_EMIT routesPlanned(response); }, Qt::QueuedConnection);
  });
}

}  // namespace agrid_map_rviz
