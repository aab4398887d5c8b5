// SPDX-License-Identifier: BSD-3-Clause
#include "service_worker.h"

#include <utility>

namespace agrid_map_rviz {

ServiceWorker::ServiceWorker() : thread_([this] { run(); }) {}

ServiceWorker::~ServiceWorker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
    // drops the connection, so that a call that waits for its answer returns
    if (running_) running_.shutdown();
  }
  wake_.notify_all();
  thread_.join();
}

void ServiceWorker::post(std::function<void()> job) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  wake_.notify_all();
}

agrid_map::Status ServiceWorker::unreachable(const std::string& message) {
  agrid_map::Status status;
  status.code = agrid_map::Status::CANCELLED;
  status.message = message;
  return status;
}

void ServiceWorker::hold(const ros::ServiceClient& client) {
  const std::lock_guard<std::mutex> lock(mutex_);
  running_ = client;
  if (stopping_ && running_) running_.shutdown();
}

void ServiceWorker::run() {
  for (;;) {
    std::function<void()> job;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      wake_.wait(lock, [this] { return stopping_ || !jobs_.empty(); });
      if (stopping_) return;
      job = std::move(jobs_.front());
      jobs_.pop_front();
    }
    job();
  }
}

}  // namespace agrid_map_rviz
