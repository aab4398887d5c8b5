// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "evaluation/measured_scores.h"
#include "tools/case_scores.h"

namespace agrid::test {

using tools::CaseScores;
using tools::ViewScores;

/// The mean over the maps for which `value` says something; less than -1 stands for nothing.
inline double meanOf(const std::vector<CaseScores>& scores, std::size_t view,
                     const std::function<double(const ViewScores&)>& value) {
  double sum = 0;
  double count = 0;
  for (const CaseScores& one : scores) {
    const double known = value(one.views.at(view));
    if (known < -1) continue;
    sum += known;
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

/// Compares means with what was measured, and prints them in the form of measured_scores.h.
inline void expectAsMeasured(const std::vector<CaseScores>& scores, const MeasuredScores& measured,
                             RoomFloor floor) {
  const auto mean = [&](const std::function<double(const ViewScores&)>& value) {
    return meanOf(scores, 0, value);
  };
  const MeasuredScores now{
      measured.maps,
      mean([](const ViewScores& s) { return s.areas.iou_all; }),
      mean([](const ViewScores& s) { return s.areas.mcc; }),
      mean([](const ViewScores& s) { return s.areas.f1_50; }),
      mean([&](const ViewScores& s) {
        return floor == RoomFloor::kFree ? s.areas.recall_free : s.areas.recall;
      }),
      mean([](const ViewScores& s) { return s.areas.precision; }),
      mean([](const ViewScores& s) { return s.doors_complete ? s.doors.precision : -2; }),
      mean([](const ViewScores& s) { return s.doors.recall; }),
  };
  std::printf("{\"%s\", %.4f, %.4f, %.4f, %.4f, %.4f, %.4f, %.4f}\n", now.maps, now.iou_all,
              now.mcc, now.f1_50, now.recall, now.precision, now.door_precision, now.door_recall);
  SCOPED_TRACE(measured.maps);
  EXPECT_GE(now.iou_all, measured.iou_all - kAreaMargin);
  EXPECT_GE(now.mcc, measured.mcc - kAreaMargin);
  EXPECT_GE(now.f1_50, measured.f1_50 - kAreaMargin);
  EXPECT_GE(now.recall, measured.recall - kAreaMargin);
  EXPECT_GE(now.precision, measured.precision - kAreaMargin);
  EXPECT_GE(now.door_precision, measured.door_precision - kDoorMargin);
  EXPECT_GE(now.door_recall, measured.door_recall - kDoorMargin);
}

/// Compares how far the mean MCC falls from the first view to each other with what was measured.
inline void expectFallsAsMeasured(const std::vector<CaseScores>& scores,
                                  const std::vector<tools::View>& views,
                                  double MeasuredFall::*measured) {
  const auto mcc = [](const ViewScores& s) { return s.areas.mcc; };
  ASSERT_EQ(views.size(), kFalls.size() + 1);
  const double as_given = meanOf(scores, 0, mcc);
  for (std::size_t i = 0; i < kFalls.size(); ++i) {
    EXPECT_EQ(views[i + 1].name, kFalls[i].view);
    const double fall = as_given - meanOf(scores, i + 1, mcc);
    std::printf("{\"%s\", %.4f}\n", kFalls[i].view, fall);
    EXPECT_LE(fall, kFalls[i].*measured + kViewMargin) << kFalls[i].view;
  }
}

}  // namespace agrid::test
