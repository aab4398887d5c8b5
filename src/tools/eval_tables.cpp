// SPDX-License-Identifier: BSD-3-Clause
#include "tools/eval_tables.h"

#include <algorithm>
#include <array>

#include "tools/table_text.h"

namespace agrid::tools {
namespace {

using Row = TableRow;
using Numbers = std::vector<double>;

constexpr double kNone = -2;  // no score is that low

constexpr std::array<EvalGroup, 3> kGroups{EvalGroup::kPlain, EvalGroup::kFurnished,
                                           EvalGroup::kFolder};

std::string score(double value) { return value == kNone ? "-" : formatted("%.4f", value); }

std::vector<const CaseScores*> ofGroup(const std::vector<CaseScores>& scores, EvalGroup group) {
  std::vector<const CaseScores*> chosen;
  for (const CaseScores& one : scores) {
    if (one.about.group == group) chosen.push_back(&one);
  }
  return chosen;
}

double doorPrecision(const ViewScores& view) {
  return view.doors_complete ? view.doors.precision : kNone;
}

/// The columns of the tables: seven scores, then counts.
Numbers columnsOf(const ViewScores& view, EvalGroup group) {
  const AreaScores& areas = view.areas;
  return {areas.iou_all,
          areas.mcc,
          areas.f1_50,
          group == EvalGroup::kPlain ? areas.recall : areas.recall_free,
          areas.precision,
          doorPrecision(view),
          view.doors.recall,
          static_cast<double>(areas.areas),
          static_cast<double>(areas.rooms),
          static_cast<double>(areas.over_segmented),
          static_cast<double>(areas.under_segmented)};
}

constexpr std::size_t kScoreColumns = 7;

Row rowOf(const std::string& name, const Numbers& numbers, const char* count_format) {
  Row row{name};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    row.push_back(i < kScoreColumns ? score(numbers[i]) : formatted(count_format, numbers[i]));
  }
  return row;
}

/// The mean of each column over those that have it.
Numbers meanOf(const std::vector<Numbers>& rows) {
  Numbers mean;
  for (std::size_t i = 0; i < rows.front().size(); ++i) {
    double sum = 0;
    double count = 0;
    for (const Numbers& row : rows) {
      if (row[i] == kNone) continue;
      sum += row[i];
      ++count;
    }
    mean.push_back(count > 0 ? sum / count : kNone);
  }
  return mean;
}

std::string groupTable(const std::vector<const CaseScores*>& scores, EvalGroup group) {
  std::vector<Row> rows{{nameOf(group), "iou_all", "mcc", "f1",
                         group == EvalGroup::kPlain ? "recall" : "recall_free", "precision",
                         "door P", "door R", "areas", "rooms", "over", "under"}};
  std::vector<Numbers> all;
  for (const CaseScores* one : scores) {
    all.push_back(columnsOf(one->views.front(), group));
    rows.push_back(rowOf(one->about.name, all.back(), "%.0f"));
  }
  rows.push_back(rowOf("mean of " + std::to_string(all.size()), meanOf(all), "%.1f"));
  return markdownTable(rows);
}

double meanCorrelation(const std::vector<const CaseScores*>& scores, std::size_t view) {
  double sum = 0;
  for (const CaseScores* one : scores) sum += one->views[view].areas.mcc;
  return sum / static_cast<double>(scores.size());
}

std::string csvNumbers(const ViewScores& view) {
  const AreaScores& areas = view.areas;
  std::string line;
  for (const double value :
       {areas.iou_all, areas.iou_rooms, areas.mcc, areas.f1_50, areas.recall, areas.precision,
        areas.recall_free, areas.precision_free, doorPrecision(view), view.doors.recall}) {
    line += "," + (value == kNone ? std::string() : formatted("%.6f", value));
  }
  for (const std::size_t count : {areas.areas, areas.rooms, areas.over_segmented,
                                  areas.under_segmented, view.doors.doors, view.doors.borders}) {
    line += "," + std::to_string(count);
  }
  return line;
}

}  // namespace

std::string scoreTables(const std::vector<CaseScores>& scores) {
  std::string tables;
  for (const EvalGroup group : kGroups) {
    const auto chosen = ofGroup(scores, group);
    if (chosen.empty()) continue;
    tables += (tables.empty() ? "" : "\n") + groupTable(chosen, group);
  }
  return tables;
}

std::string robustnessTable(const std::vector<CaseScores>& scores, const std::vector<View>& views) {
  std::vector<Row> rows{{"view"}};
  for (const View& view : views) rows.push_back({view.name});
  for (const EvalGroup group : kGroups) {
    const auto chosen = ofGroup(scores, group);
    if (chosen.empty()) continue;
    rows.front().push_back(std::string(nameOf(group)) + ": mcc");
    rows.front().push_back("change");
    const double as_given = meanCorrelation(chosen, 0);
    for (std::size_t v = 0; v < views.size(); ++v) {
      const double mean = meanCorrelation(chosen, v);
      rows[v + 1].push_back(score(mean));
      rows[v + 1].push_back(v == 0 ? "" : formatted("%+.4f", mean - as_given));
    }
  }
  return markdownTable(rows);
}

std::string scoresCsv(const std::vector<CaseScores>& scores, const std::vector<View>& views) {
  std::string csv =
      "map,group,view,iou_all,iou_rooms,mcc,f1_50,recall,precision,recall_free,precision_free,"
      "door_precision,door_recall,areas,rooms,over,under,doors,true_doors\n";
  for (const CaseScores& one : scores) {
    for (std::size_t v = 0; v < views.size(); ++v) {
      csv += csvField(one.about.name) + "," + nameOf(one.about.group) + "," + views[v].name +
             csvNumbers(one.views[v]) + "\n";
    }
  }
  return csv;
}

}  // namespace agrid::tools
