// SPDX-License-Identifier: BSD-3-Clause
#include "ros/diagnostics.h"

#include <cstdlib>

#include "place_fixture.h"

namespace agrid_map_ros {
namespace {

using diagnostic_msgs::DiagnosticStatus;

/// The value of a key; empty if there is none.
std::string valueOf(const DiagnosticStatus& status, const std::string& key) {
  for (const auto& value : status.values) {
    if (value.key == key) return value.value;
  }
  return {};
}

class Diagnosis : public test::PlaceFixture {
 protected:
  Findings ready() const {
    Findings findings;
    findings.state = MapBuilder::State::kReady;
    findings.snapshot = draft(test::twoRoomsAndACloset());
    return findings;
  }

  EventLog log_;
};

TEST_F(Diagnosis, TellsAtAGlanceWhatTheMapIsLike) {
  const DiagnosticStatus status = diagnose(ready(), log_);
  EXPECT_EQ(status.level, DiagnosticStatus::OK);
  EXPECT_EQ(status.message, "ready");
  EXPECT_EQ(valueOf(status, "areas"), "3");
  EXPECT_EQ(valueOf(status, "doors"), "1");
  EXPECT_EQ(valueOf(status, "unreachable areas"), "1");  // the closet
  EXPECT_GT(std::atof(valueOf(status, "process memory [MB]").c_str()), 1);
}

TEST_F(Diagnosis, WarnsWithoutAMapAndWhereNothingIsKept) {
  EXPECT_EQ(diagnose({}, log_).level, DiagnosticStatus::WARN);
  Findings findings = ready();
  findings.storage_problem = "no space";
  const DiagnosticStatus status = diagnose(findings, log_);
  EXPECT_EQ(status.level, DiagnosticStatus::WARN);
  EXPECT_NE(status.message.find("no space"), std::string::npos);
}

TEST_F(Diagnosis, ARefusedMapIsWorseWithoutAFormerOne) {
  Findings findings = ready();
  findings.state = MapBuilder::State::kFailed;
  EXPECT_EQ(diagnose(findings, log_).level, DiagnosticStatus::WARN);
  findings.snapshot.reset();
  EXPECT_EQ(diagnose(findings, log_).level, DiagnosticStatus::ERROR);
}

TEST_F(Diagnosis, SaysWhatIsWrongWithTheParameters) {
  Findings findings = ready();
  findings.parameter_error = "~robot_radius is a text";
  const DiagnosticStatus status = diagnose(findings, log_);
  EXPECT_EQ(status.level, DiagnosticStatus::ERROR);
  EXPECT_NE(status.message.find("~robot_radius is a text"), std::string::npos);
}

}  // namespace
}  // namespace agrid_map_ros
