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
constexpr MeasuredScores kPlainPlans{"plain", 0.8955, 0.9123, 0.9223,
                                     0.9833,  0.9658, 0.8978, 0.8654};
constexpr MeasuredScores kFurnishedPlans{"furnished", 0.8638, 0.8572, 0.8923,
                                         0.9732,      0.9655, 0.8622, 0.8766};
constexpr MeasuredScores kPaperOnPlainPlans{
    "plain, the paper's method", 0.6931, 0.7105, 0.7856, 0.9892, 0.9439, 1.0000, 0.6988};

/// The maps of real robots with rooms in ../shared/maps/real; not all have true doors.
constexpr MeasuredScores kRealMaps{"real", 0.3880, 0.4667, 0.5260, 0.8260, 0.7317, 0.3652, 0.6258};

/// Those of ../shared/maps/real whose rooms and doors are drawn by hand in test/data/truth.
constexpr MeasuredScores kHandDrawnRooms{
    "real, drawn by hand", 0.7151, 0.7043, 0.7996, 0.9281, 0.9815, 0.7317, 0.8919};

/// Drawn offices of 40 m a side, seeds 1 to 4.
constexpr MeasuredScores kEmptyOffices{"empty", 0.9488, 0.9506, 0.9807,
                                       0.9907,  0.9843, 0.9604, 0.9410};
constexpr MeasuredScores kFurnishedOffices{"with furniture", 0.9272, 0.9155, 0.9673,
                                           0.9794,           0.9843, 0.9253, 0.9300};
constexpr MeasuredScores kScannedOffices{
    "with furniture and noise", 0.8937, 0.8902, 0.9457, 0.9772, 0.9792, 0.9002, 0.9281};

/// By how much the mean MCC falls in another view of the same maps; negative: it rises.
struct MeasuredFall {
  const char* view;
  double plans;    ///< of three floor plans, plain and furnished
  double offices;  ///< of the drawn offices with furniture and noise
};
constexpr std::array<MeasuredFall, 7> kFalls{{
    {"turned by 7 deg", -0.0076, -0.0006},
    {"turned by 17 deg", -0.0150, -0.0156},
    {"turned by 30 deg", 0.0019, 0.0113},
    {"turned by 45 deg", -0.0095, -0.0071},
    {"at 0.1 m", 0.0573, 0.0303},
    {"at 0.025 m", 0.0047, -0.0004},
    {"with noise", 0.0119, 0.0101},
}};

}  // namespace agrid::test
