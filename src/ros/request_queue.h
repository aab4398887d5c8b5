// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include <ros/callback_queue_interface.h>

namespace agrid_map_ros {

/// What is to become of a request whose turn has come.
enum class Turn {
  kAnswer,
  kBusy,      ///< too many wait already
  kLate,      ///< it has waited as long as it may
  kCancelled  ///< the queue is ending
};

/// A callback queue of roscpp for requests that take their time: some are answered at once, each in
/// a thread of its own, some wait in line, and all others are refused at once by one more thread,
/// so that however many come, there are never more threads. A callback that runs asks what its turn
/// is.
class RequestQueue : public ros::CallbackQueueInterface {
 public:
  using Clock = std::chrono::steady_clock;
  struct Limits {
    int running = 1;  ///< at least 1
    int waiting = 0;  ///< further ones are refused
  };
  struct Call {
    Turn turn = Turn::kAnswer;
    Clock::duration waited{};  ///< from arrival to now that its turn has come
  };

  /// @param max_wait_seconds  how long a request may wait in line; asked again and again
  RequestQueue(const Limits& limits, std::function<double()> max_wait_seconds);
  ~RequestQueue() override;
  RequestQueue(const RequestQueue&) = delete;
  RequestQueue& operator=(const RequestQueue&) = delete;

  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner_id) override;
  /// Drops those of an owner that wait; one that runs goes on.
  void removeByID(std::uint64_t owner_id) override;

  /// Of the callback that this thread is running; must be called from one.
  Call current() const;

  /// Gives those that wait their turn as kCancelled and returns when all threads have ended.
  /// Callbacks that are added later are dropped.
  void finish();

 private:
  struct Entry {
    ros::CallbackInterfacePtr callback;
    std::uint64_t owner_id = 0;
    Clock::time_point arrived;
    Turn turn = Turn::kAnswer;
  };

  void answerWaiting();
  void refuseOthers();
  /// The next to be refused; waits for it.
  /// @return none if the queue is ending and nobody is left
  std::optional<Entry> nextRefused(std::unique_lock<std::mutex>& lock);
  void run(const Entry& entry, std::unique_lock<std::mutex>& lock);

  Limits limits_;
  std::function<double()> max_wait_seconds_;
  mutable std::mutex mutex_;
  std::condition_variable may_answer_;
  std::condition_variable may_refuse_;
  std::deque<Entry> waiting_;
  std::deque<Entry> refused_;
  std::map<std::thread::id, Call> calls_;
  int running_ = 0;
  bool finishing_ = false;
  std::vector<std::thread> threads_;  // last: they use all of the above
};

}  // namespace agrid_map_ros
