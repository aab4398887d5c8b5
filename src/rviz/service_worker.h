// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#ifndef Q_MOC_RUN
#include <ros/ros.h>

#include <agrid_map/Status.h>
#endif

namespace agrid_map_rviz {

/// One thread that calls services, so that the window does not wait for them.
class ServiceWorker {
 public:
  ServiceWorker();
  /// Ends the call that runs and drops those that wait.
  ~ServiceWorker();
  ServiceWorker(const ServiceWorker&) = delete;
  ServiceWorker& operator=(const ServiceWorker&) = delete;

  /// Runs a job after those that were given before.
  void post(std::function<void()> job);

  /// Calls a service and waits for its answer; in a job only.
  /// @return whether an answer came; if not, `response.status` says why
  template <typename Service>
  bool call(const std::string& name, typename Service::Request request,
            typename Service::Response& response) {
    if (!ros::service::exists(name, false)) {
      response.status = unreachable("nobody offers the service " + name + "; is the node running?");
      return false;
    }
    ros::ServiceClient client = ros::NodeHandle().serviceClient<Service>(name, true);
    hold(client);
    const bool answered = client.call(request, response);
    hold({});
    if (!answered) response.status = unreachable("the service " + name + " did not answer");
    return answered;
  }

 private:
  static agrid_map::Status unreachable(const std::string& message);
  void hold(const ros::ServiceClient& client);
  void run();

  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::function<void()>> jobs_;
  ros::ServiceClient running_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace agrid_map_rviz
