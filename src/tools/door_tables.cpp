// SPDX-License-Identifier: BSD-3-Clause
#include "tools/door_tables.h"

#include <array>

#include "tools/table_text.h"

namespace agrid::tools {
namespace {

/// Each bin goes up to, but not with, the bound of the next one; the last one holds 1 too.
constexpr std::array<double, 6> kLowerBounds{0, 0.5, 0.7, 0.8, 0.9, 0.95};

struct Bin {
  double doors = 0;
  double true_doors = 0;
  double confidence = 0;  ///< sum
  void add(const Bin& other) {
    doors += other.doors;
    true_doors += other.true_doors;
    confidence += other.confidence;
  }
};

TableRow rowOf(const std::string& name, const Bin& bin) {
  if (bin.doors == 0) return {name, "0", "-", "-"};
  return {name, formatted("%.0f", bin.doors), formatted("%.3f", bin.confidence / bin.doors),
          formatted("%.3f", bin.true_doors / bin.doors)};
}

std::string nameOfBin(std::size_t i) {
  const bool last = i + 1 == kLowerBounds.size();
  const std::string high = last ? "1]" : formatted("%.2f", kLowerBounds[i + 1]) + ")";
  return formatted("[%.2f, ", kLowerBounds[i]) + high;
}

}  // namespace

std::string doorsCsv(const std::vector<CaseScores>& scores) {
  std::string csv = "map,door,kind,width,confidence,true\n";
  for (const CaseScores& one : scores) {
    for (const JudgedDoor& door : one.doors) {
      csv += csvField(one.about.name) + "," + std::to_string(door.id) + "," +
             (door.kind == DoorKind::kDoor ? "DOOR" : "PASSAGE") + formatted(",%.3f", door.width) +
             formatted(",%.6f", door.confidence) + (door.is_true ? ",1\n" : ",0\n");
    }
  }
  return csv;
}

std::string reliabilityTable(const std::vector<CaseScores>& scores) {
  std::array<Bin, kLowerBounds.size()> bins;
  Bin all;
  for (const CaseScores& one : scores) {
    for (const JudgedDoor& door : one.doors) {
      std::size_t i = bins.size() - 1;
      while (i > 0 && door.confidence < kLowerBounds[i]) --i;
      const Bin of_door{1, door.is_true ? 1. : 0., door.confidence};
      bins[i].add(of_door);
      all.add(of_door);
    }
  }
  std::vector<TableRow> rows{{"confidence", "doors", "mean", "true"}};
  for (std::size_t i = 0; i < bins.size(); ++i) rows.push_back(rowOf(nameOfBin(i), bins[i]));
  rows.push_back(rowOf("all", all));
  return markdownTable(rows);
}

}  // namespace agrid::tools
