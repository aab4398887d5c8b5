// SPDX-License-Identifier: BSD-3-Clause
#include "ros/services.h"

#include <algorithm>
#include <thread>
#include <type_traits>
#include <utility>

#include "ros/boundary.h"
#include "ros/edit_answers.h"
#include "ros/question_answers.h"
#include "ros/request_error.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;

Parameters parametersOf(const Settings& settings) {
  const auto parameters = settings.parameters();
  return parameters ? *parameters : Parameters{};
}

RequestQueue::Limits limitsOf(const NodeParams& params) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return {params.max_parallel_plans == 0 ? cores : params.max_parallel_plans,
          params.max_queued_plans};
}

// so many edits share one write to the disk, see PlaceKeeper::edit
constexpr RequestQueue::Limits kEditLimits{8, 1000};
constexpr double kLongestWaitOfEdits = 30;  // [s]

template <typename Response>
void setStatus(Response& response, const Status& status) {
  // nav_msgs/GetPlan has no place for it
  if constexpr (!std::is_same_v<Response, nav_msgs::GetPlan::Response>) {
    response = Response();
    response.status = status;
  }
}

template <typename Response>
void remarkNewer(Response& response, const Snapshot& used, const SnapshotPtr& newest) {
  if constexpr (!std::is_same_v<Response, nav_msgs::GetPlan::Response>) {
    remarkChange(response.status, used, newest.get());
  }
}

}  // namespace

Services::Services(const ros::NodeHandle& private_nh, const Deps& deps)
    : deps_(deps),
      plan_limits_(limitsOf(parametersOf(deps.settings).node)),
      plan_queue_(plan_limits_, [this] { return parametersOf(deps_.settings).planner.timeout; }),
      edit_queue_(kEditLimits, [] { return kLongestWaitOfEdits; }),
      question_nh_(private_nh),
      plan_nh_(private_nh),
      edit_nh_(private_nh) {
  plan_nh_.setCallbackQueue(&plan_queue_);
  edit_nh_.setCallbackQueue(&edit_queue_);
  advertise<agrid_map::PlanAreas>(Kind::kPlan, "plan_areas", answerPlanAreas);
  advertise<agrid_map::PlanPath>(Kind::kPlan, "plan_path",
                                 [this](const auto& g, const auto& r) { return planPath(g, r); });
  advertise<nav_msgs::GetPlan>(Kind::kPlan, "make_plan",
                               [this](const auto& g, const auto& r) { return makePlan(g, r); });
  advertise<agrid_map::WhereIs>(Kind::kPlan, "where_is", answerWhereIs);
  advertise<agrid_map::LabelAt>(Kind::kQuestion, "label_at", answerLabelAt);
  advertise<agrid_map::GetAGrid>(Kind::kQuestion, "get_agrid", answerGetAGrid);
  advertise<agrid_map::GetGraph>(Kind::kQuestion, "get_graph", answerGetGraph);
  advertise<agrid_map::ListTags>(Kind::kQuestion, "list_tags", answerListTags);
  advertise<agrid_map::Query>(Kind::kQuestion, "query", [this](const auto& g, const auto& r) {
    return deps_.hearing.answerQuery(g, r);
  });
  advertiseEdit<agrid_map::AddTag>("add_tag", answerAddTag);
  advertiseEdit<agrid_map::RemoveTag>("remove_tag", answerRemoveTag);
  advertiseEdit<agrid_map::SetDoor>("set_door", answerSetDoor);
  advertiseEdit<agrid_map::SaveMap>("save_map", answerSaveMap);
  advertiseEdit<agrid_map::LoadMap>("load_map", answerLoadMap);
}

Services::~Services() {
  // first of all, as a server that shuts down hangs up on its clients
  plan_queue_.finish();
  edit_queue_.finish();
  for (ros::ServiceServer& server : servers_) server.shutdown();
}

template <typename Service>
void Services::advertise(Kind kind, const std::string& name, Answer<Service> answer) {
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  const boost::function<bool(Request&, Response&)> callback =
      [this, kind, answer = std::move(answer)](Request& request, Response& response) {
        serve<Service>(kind, answer, request, response);
        return true;
      };
  ros::NodeHandle& nh = kind == Kind::kPlan   ? plan_nh_
                        : kind == Kind::kEdit ? edit_nh_
                                              : question_nh_;
  servers_.push_back(nh.advertiseService(name, callback));
}

template <typename Service>
void Services::advertiseEdit(const std::string& name, EditAnswer<Service> answer) {
  advertise<Service>(Kind::kEdit, name, [this, answer](const Ground& ground, const auto& request) {
    return answer(ground, deps_.keeper, request);
  });
}

template <typename Service>
void Services::serve(Kind kind, const Answer<Service>& answer,
                     const typename Service::Request& request,
                     typename Service::Response& response) {
  const auto failure = attempt(deps_.log, "request", [&] {
    const auto waited = requireTurn(kind);
    const SnapshotPtr snapshot = requireSnapshot();
    const Frames frames(deps_.transforms, deps_.cancelled, snapshot->frame(),
                        snapshot->parameters->node.tf_timeout);
    response = answer(Ground{*snapshot, frames, deps_.cancelled, waited}, request);
    if (kind == Kind::kPlan) remarkNewer(response, *snapshot, deps_.keeper.snapshot());
  });
  if (!failure) return;
  deps_.log.warn("request", failure->message);
  setStatus(response, *failure);
}

RequestQueue::Clock::duration Services::requireTurn(Kind kind) const {
  if (kind == Kind::kQuestion) return {};
  const bool plans = kind == Kind::kPlan;
  const RequestQueue::Limits& limits = plans ? plan_limits_ : kEditLimits;
  const RequestQueue::Call call = (plans ? plan_queue_ : edit_queue_).current();
  switch (call.turn) {
    case Turn::kAnswer:
      break;
    case Turn::kBusy:
      throw RequestError(Status::BUSY, std::to_string(limits.running) +
                                           (plans ? " requests are being planned and "
                                                  : " edits are being made and ") +
                                           std::to_string(limits.waiting) + " wait; ask again");
    case Turn::kLate:
      throw RequestError(Status::TIMEOUT, "the request's turn did not come in time");
    case Turn::kCancelled:
      throw RequestError(Status::CANCELLED, "the node is shutting down");
  }
  return call.waited;
}

SnapshotPtr Services::requireSnapshot() const {
  if (SnapshotPtr snapshot = deps_.keeper.snapshot()) return snapshot;
  const std::string error = deps_.settings.error();
  if (!error.empty()) throw RequestError(Status::INVALID_REQUEST, "bad parameters: " + error);
  throw RequestError(Status::NO_MAP, "no map has been built yet");
}

agrid_map::PlanPath::Response Services::planPath(const Ground& ground,
                                                 const agrid_map::PlanPath::Request& request) {
  agrid_map::PlanPath::Response response = answerPlanPath(ground, request);
  if (response.status.code == Status::SUCCESS) deps_.outputs.publishPlan(response.path);
  return response;
}

nav_msgs::GetPlan::Response Services::makePlan(const Ground& ground,
                                               const nav_msgs::GetPlan::Request& request) {
  nav_msgs::GetPlan::Response response = answerMakePlan(ground, request);
  deps_.outputs.publishPlan(response.plan);
  return response;
}

}  // namespace agrid_map_ros
