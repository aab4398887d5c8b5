// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <atomic>
#include <exception>
#include <iostream>
#include <memory>
#include <mutex>
#include <thread>

#include <opencv2/core.hpp>
#include <unistd.h>

#include "agrid/map/map_io.h"
#include "map/file_writer.h"
#include "tools/case_scores.h"
#include "tools/commands.h"
#include "tools/eval_tables.h"
#include "tools/pipeline_options.h"

namespace agrid::tools {
namespace {

/// Each thread works on a map of its own; OpenCV's threads would only get in their way.
class OpenCvThreads {
 public:
  explicit OpenCvThreads(int count) : former_(cv::getNumThreads()) { cv::setNumThreads(count); }
  ~OpenCvThreads() { cv::setNumThreads(former_); }
  OpenCvThreads(const OpenCvThreads&) = delete;
  OpenCvThreads& operator=(const OpenCvThreads&) = delete;

 private:
  int former_;
};

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

std::vector<EvalCase> casesOf(const Arguments& arguments) {
  const std::string& folder = arguments.operand(0);
  EvalCases found = findEvalCases(folder, arguments.valueOr("truth", ""));
  for (const std::string& name : found.without_truth) {
    std::cerr << "warning: " << name << ": no truth, passed over\n";
  }
  if (found.cases.empty()) {
    const char* what = found.without_truth.empty() ? ": no maps there" : ": no map has truth";
    throw FileError(FileErrorCode::kPath, folder + what);
  }
  return std::move(found.cases);
}

int eval(const Arguments& arguments) {
  const ConversionParams params = conversionParams(arguments);
  const auto cores = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 256U));
  const auto threads = static_cast<int>(arguments.integerOr("threads", cores, 1, 256));
  const std::vector<EvalCase> cases = casesOf(arguments);
  std::unique_ptr<FileWriter> csv;
  if (arguments.has("csv")) csv = std::make_unique<FileWriter>(arguments.value("csv"));
  const std::vector<View> views = evalViews(arguments.has("robustness"));

  const OpenCvThreads one_each(1);
  const std::vector<CaseScores> scores = Scoring(cases, params, views).run(threads);
  for (const CaseScores& one : scores) {
    for (const std::string& warning : one.warnings) {
      std::cerr << "warning: " << one.about.name << ": " << warning << "\n";
    }
  }
  if (csv) {
    csv->write(scoresCsv(scores, views));
    csv->commit();
  }
  std::cout << scoreTables(scores);
  if (views.size() > 1) std::cout << "\n" << robustnessTable(scores, views);
  return kDone;
}

}  // namespace

Command evalCommand() {
  Syntax syntax;
  syntax.command = "eval";
  syntax.summary = "Scores areas and doors of a folder of maps against rooms drawn by people.";
  syntax.operands = {"DIR"};
  syntax.options = {
      {"truth", 0, "DIR", "look here first for the truth, in the same layout"},
      {"csv", 0, "FILE", "also write every score of every map"},
      {"robustness", 0, "", "score each map also turned, at 0.1 and 0.025 m, and with noise"},
      {"threads", 0, "N", "maps at a time (all cores)"},
  };
  for (const Option& option : pipelineOptions()) syntax.options.push_back(option);
  return {syntax, eval};
}

}  // namespace agrid::tools
