// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace agrid::test {

/// Every figure that the tests hold areas and doors to: what was measured. What comes out may be
/// worse by the margins below, which cover other compilers and libraries, not other methods.

constexpr double kAreaMargin = 0.005;  ///< of areas' means
constexpr double kDoorMargin = 0.01;   ///< of doors' means
constexpr double kViewMargin = 0.01;   ///< of the fall of the mean MCC

/// Means over some maps.
struct MeasuredScores {
  const char* maps;
  double iou_all;
  double mcc;
  double f1_50;
  double recall;  ///< on free pixels but for the plain floor plans
  double precision;
  double door_precision;
  double door_recall;
};

/// The floor plans of ../shared/maps/bormann.
constexpr MeasuredScores kPlainPlans{"plain", 0.9368, 0.9468, 0.9714,
                                     0.9845,  0.9816, 0.9558, 0.9437};
constexpr MeasuredScores kFurnishedPlans{"furnished", 0.9060, 0.9162, 0.9461,
                                         0.9847,      0.9782, 0.9440, 0.9236};
constexpr MeasuredScores kPaperOnPlainPlans{
    "plain, the paper's method", 0.6931, 0.7105, 0.7856, 0.9892, 0.9439, 1.0000, 0.6988};

/// The maps of real robots with rooms in ../shared/maps/real; not all have true doors.
constexpr MeasuredScores kRealMaps{"real", 0.5041, 0.5875, 0.6195, 0.9082, 0.7630, 0.5384, 0.6335};

/// Those of ../shared/maps/real whose rooms and doors are drawn by hand in test/data/truth.
constexpr MeasuredScores kHandDrawnRooms{
    "real, drawn by hand", 0.7885, 0.7811, 0.8600, 0.9571, 0.9691, 0.8087, 0.8993};

/// Drawn offices of 40 m a side, seeds 1 to 4.
constexpr MeasuredScores kEmptyOffices{"empty", 0.9099, 0.9117, 0.9466,
                                       0.9989,  0.9815, 0.9924, 0.9263};
constexpr MeasuredScores kFurnishedOffices{"with furniture", 0.9063, 0.9201, 0.9372,
                                           0.9884,           0.9819, 0.9738, 0.9263};
constexpr MeasuredScores kScannedOffices{
    "with furniture and noise", 0.8962, 0.9076, 0.9310, 0.9893, 0.9740, 0.9497, 0.9321};

/// By how much the mean MCC falls in another view of the same maps; negative: it rises.
struct MeasuredFall {
  const char* view;
  double plans;    ///< of three floor plans, plain and furnished
  double offices;  ///< of the drawn offices with furniture and noise
};
constexpr std::array<MeasuredFall, 7> kFalls{{
    {"turned by 7 deg", -0.0041, -0.0016},
    {"turned by 17 deg", 0.0491, -0.0086},
    {"turned by 30 deg", 0.0251, 0.0094},
    {"turned by 45 deg", -0.0022, -0.0201},
    {"at 0.1 m", 0.0246, 0.0739},
    {"at 0.025 m", -0.0046, 0.0000},
    {"with noise", 0.0022, -0.0069},
}};

}  // namespace agrid::test
