// SPDX-License-Identifier: BSD-3-Clause
#include "ros/request_queue.h"

#include <algorithm>
#include <utility>

namespace agrid_map_ros {

RequestQueue::RequestQueue(const Limits& limits, std::function<double()> max_wait_seconds)
    : limits_(limits), max_wait_seconds_(std::move(max_wait_seconds)) {
  for (int i = 0; i < limits_.running; ++i) threads_.emplace_back([this] { answerWaiting(); });
  threads_.emplace_back([this] { refuseOthers(); });
}

RequestQueue::~RequestQueue() { finish(); }

void RequestQueue::addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner_id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (finishing_) return;
  const std::size_t places = static_cast<std::size_t>(limits_.running + limits_.waiting);
  if (waiting_.size() + static_cast<std::size_t>(running_) < places) {
    waiting_.push_back({callback, owner_id, Clock::now(), Turn::kAnswer});
    may_answer_.notify_one();
  } else {
    refused_.push_back({callback, owner_id, Clock::now(), Turn::kBusy});
  }
  // also for one that waits: it may become late
  may_refuse_.notify_one();
}

void RequestQueue::removeByID(std::uint64_t owner_id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (std::deque<Entry>* line : {&waiting_, &refused_}) {
    line->erase(std::remove_if(line->begin(), line->end(),
                               [=](const Entry& entry) { return entry.owner_id == owner_id; }),
                line->end());
  }
}

RequestQueue::Call RequestQueue::current() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return calls_.at(std::this_thread::get_id());
}

void RequestQueue::finish() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    finishing_ = true;
    for (Entry& entry : waiting_) {
      entry.turn = Turn::kCancelled;
      refused_.push_back(std::move(entry));
    }
    waiting_.clear();
  }
  may_answer_.notify_all();
  may_refuse_.notify_all();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

void RequestQueue::answerWaiting() {
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    may_answer_.wait(lock, [this] { return finishing_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    const Entry entry = std::move(waiting_.front());
    waiting_.pop_front();
    ++running_;
    run(entry, lock);
    --running_;
  }
}

void RequestQueue::refuseOthers() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (const std::optional<Entry> entry = nextRefused(lock)) run(*entry, lock);
}

std::optional<RequestQueue::Entry> RequestQueue::nextRefused(std::unique_lock<std::mutex>& lock) {
  for (;;) {
    if (!refused_.empty()) {
      Entry entry = std::move(refused_.front());
      refused_.pop_front();
      return entry;
    }
    if (finishing_) return std::nullopt;
    if (waiting_.empty()) {
      may_refuse_.wait(lock);
      continue;
    }
    const auto late =
        waiting_.front().arrived + std::chrono::duration_cast<Clock::duration>(
                                       std::chrono::duration<double>(max_wait_seconds_()));
    if (Clock::now() < late) {
      may_refuse_.wait_until(lock, late);
      continue;
    }
    Entry entry = std::move(waiting_.front());
    waiting_.pop_front();
    entry.turn = Turn::kLate;
    return entry;
  }
}

void RequestQueue::run(const Entry& entry, std::unique_lock<std::mutex>& lock) {
  calls_[std::this_thread::get_id()] = {entry.turn, Clock::now() - entry.arrived};
  lock.unlock();
  entry.callback->call();
  lock.lock();
  calls_.erase(std::this_thread::get_id());
}

}  // namespace agrid_map_ros
