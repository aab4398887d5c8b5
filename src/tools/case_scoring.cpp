// SPDX-License-Identifier: BSD-3-Clause
#include "tools/case_scoring.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <iostream>
#include <mutex>
#include <thread>
#include <utility>

#include <unistd.h>

namespace agrid::tools {
namespace {

/// Scores the maps, some at a time.
class Scoring {
 public:
  Scoring(const std::vector<EvalCase>& cases, const ConversionParams& params,
          const std::vector<View>& views)
      : cases_(cases), params_(params), views_(views), scores_(cases.size()) {}

  /// @throws what went wrong with the first map that failed, in their order
  std::vector<CaseScores> run(int threads) {
    std::vector<std::thread> others;
    for (int i = 1; i < threads; ++i) others.emplace_back([this] { work(); });
    work();
    for (std::thread& other : others) other.join();
    if (show_) std::cerr << "\r\033[K" << std::flush;
    if (failure_) std::rethrow_exception(failure_);
    return std::move(scores_);
  }

 private:
  void work() {
    while (true) {
      const std::size_t i = next_++;
      if (i >= cases_.size()) return;
      try {
        scores_[i] = scoreCase(cases_[i], params_, views_);
      } catch (...) {
        // The maps before this one have been taken already: one of them may still fail.
        next_ = cases_.size();
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!failure_ || i < failed_) failure_ = std::current_exception();
        failed_ = std::min(failed_, i);
      }
      const std::lock_guard<std::mutex> lock(mutex_);
      ++done_;
      if (show_) std::cerr << "\r\033[Keval: " << done_ << " of " << cases_.size() << std::flush;
    }
  }

  const std::vector<EvalCase>& cases_;
  const ConversionParams& params_;
  const std::vector<View>& views_;
  std::vector<CaseScores> scores_;
  const bool show_ = isatty(STDERR_FILENO) != 0;
  std::atomic<std::size_t> next_{0};
  std::mutex mutex_;
  std::size_t done_ = 0;
  std::size_t failed_ = static_cast<std::size_t>(-1);
  std::exception_ptr failure_;
};

}  // namespace

std::vector<CaseScores> scoreCases(const std::vector<EvalCase>& cases,
                                   const ConversionParams& params, const std::vector<View>& views,
                                   int threads) {
  return Scoring(cases, params, views).run(threads);
}

}  // namespace agrid::tools
