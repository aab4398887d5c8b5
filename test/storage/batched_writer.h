// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

#include "agrid/storage.h"

namespace agrid::test {

/// Lets many threads append to one store: while one of them waits for the disk, the edits of the
/// others gather, and the next one of them stores all of these at once.
class BatchedWriter {
 public:
  using Edits = std::vector<std::vector<Change>>;

  /// @param write  stores edits; never called by two threads at once. Must not throw.
  explicit BatchedWriter(std::function<void(const Edits&)> write) : write_(std::move(write)) {}

  /// Returns when the edit is stored.
  void append(std::vector<Change> edit) {
    std::unique_lock<std::mutex> lock(mutex_);
    waiting_.push_back(std::move(edit));
    const std::size_t batch = next_batch_;
    changed_.wait(lock, [&] { return !is_writing_ || stored_ > batch; });
    if (stored_ > batch) return;
    is_writing_ = true;
    ++next_batch_;
    const Edits edits = std::exchange(waiting_, {});
    lock.unlock();
    write_(edits);
    lock.lock();
    is_writing_ = false;
    stored_ = batch + 1;
    changed_.notify_all();
  }

 private:
  std::function<void(const Edits&)> write_;
  std::mutex mutex_;
  std::condition_variable changed_;
  Edits waiting_;
  std::size_t next_batch_ = 0;
  std::size_t stored_ = 0;  // batches
  bool is_writing_ = false;
};

}  // namespace agrid::test
