// SPDX-License-Identifier: BSD-3-Clause
#include "planning/table.h"

#include <cmath>
#include <cstdio>

#include "planning/clock.h"

namespace agrid::bench {
namespace {

/// Four significant digits, and no exponent where a person would write none.
std::string number(double value) {
  if (!std::isfinite(value)) return "";
  char text[32];
  const double size = std::abs(value);
  const bool plain = size == 0 || (size >= 1e-3 && size < 1e7);
  const int decimals = size >= 1000 ? 0 : size >= 100 ? 1 : size >= 10 ? 2 : size >= 0.1 ? 3 : 4;
  if (plain) {
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
  } else {
    std::snprintf(text, sizeof text, "%.2e", value);
  }
  return text;
}

std::string count(std::size_t value) { return std::to_string(value); }

std::string ratio(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4f", value);
  return std::isfinite(value) ? text : "";
}

double largest(const std::vector<double>& values) { return quantile(values, 1); }
double median(const std::vector<double>& values) { return quantile(values, 0.5); }

struct Column {
  const char* name;   ///< in the CSV
  const char* title;  ///< in the Markdown table
  std::string (*text)(const Figures&);
};

const Column kColumns[] = {
    {"map", "", [](const Figures& f) { return f.map; }},
    {"megapixels", "Mpx", [](const Figures& f) { return number(f.megapixels); }},
    {"pairs", "pairs", [](const Figures& f) { return count(f.pairs); }},
    {"false_no", "false 'no path'", [](const Figures& f) { return count(f.false_no); }},
    {"false_found", "false 'found'", [](const Figures& f) { return count(f.false_found); }},
    {"not_free", "paths not free", [](const Figures& f) { return count(f.not_free); }},
    {"compared_with", "length compared with",
     [](const Figures& f) { return std::string(f.best_known ? "best known" : "reference"); }},
    {"lengths", "lengths compared", [](const Figures& f) { return count(f.length_ratios.size()); }},
    {"length_mean", "length ratio mean",
     [](const Figures& f) { return ratio(mean(f.length_ratios)); }},
    {"length_p95", "length ratio p95",
     [](const Figures& f) { return ratio(quantile(f.length_ratios, 0.95)); }},
    {"length_max", "length ratio max",
     [](const Figures& f) { return ratio(largest(f.length_ratios)); }},
    {"bound_gap_mean", "length over its bound, mean - 1",
     [](const Figures& f) { return ratio(mean(f.bound_gaps)); }},
    {"query_ms_median", "query median [ms]",
     [](const Figures& f) { return number(1e3 * median(f.query_seconds)); }},
    {"query_ms_p95", "query p95 [ms]",
     [](const Figures& f) { return number(1e3 * quantile(f.query_seconds, 0.95)); }},
    {"query_ms_max", "query max [ms]",
     [](const Figures& f) { return number(1e3 * largest(f.query_seconds)); }},
    {"transform_ms", "distanceTransform [ms]",
     [](const Figures& f) { return number(1e3 * median(f.transform_seconds)); }},
    {"transform_over_query", "distanceTransform / query median",
     [](const Figures& f) {
       return number(median(f.transform_seconds) / median(f.query_seconds));
     }},
    {"a_star_pairs", "pairs given to pixel A*",
     [](const Figures& f) { return count(f.a_star_seconds.size()); }},
    {"a_star_ms_median", "pixel A* median [ms]",
     [](const Figures& f) { return number(1e3 * median(f.a_star_seconds)); }},
    {"a_star_over_query", "pixel A* median / query median",
     [](const Figures& f) {
       return number(median(f.a_star_seconds) / median(f.compared_query_seconds));
     }},
    {"build_s", "build, all cores [s]", [](const Figures& f) { return number(f.build_seconds); }},
    {"build_over_transform", "build / distanceTransform",
     [](const Figures& f) { return number(f.build_seconds / median(f.transform_seconds)); }},
    {"bytes_per_pixel", "kept by the planner [bytes a pixel]",
     [](const Figures& f) { return number(f.bytes / f.megapixels * 1e-6); }},
    {"no_paths", "proved 'no path'",
     [](const Figures& f) { return count(f.no_path_seconds.size()); }},
    {"no_path_ms_median", "proved 'no path' median [ms]",
     [](const Figures& f) { return number(1e3 * median(f.no_path_seconds)); }},
    {"no_path_ms_max", "proved 'no path' max [ms]",
     [](const Figures& f) { return number(1e3 * largest(f.no_path_seconds)); }},
    {"door_ms_median", "a door closed or opened, median [ms]",
     [](const Figures& f) { return number(1e3 * median(f.door_seconds)); }},
    {"door_ms_max", "a door closed or opened, max [ms]",
     [](const Figures& f) { return number(1e3 * largest(f.door_seconds)); }},
    {"door_plan_ms_median", "... and the first plan past it, median [ms]",
     [](const Figures& f) { return number(1e3 * median(f.first_plan_seconds)); }},
    {"door_plan_ms_max", "... and the first plan past it, max [ms]",
     [](const Figures& f) { return number(1e3 * largest(f.first_plan_seconds)); }},
};

}  // namespace

std::string markdownTable(const std::vector<Figures>& maps) {
  std::string table;
  for (const Column& column : kColumns) {
    table += std::string("| ") + column.title + " |";
    for (const Figures& figures : maps) table += " " + column.text(figures) + " |";
    table += "\n";
    if (&column != kColumns) continue;
    table += "|---|";
    for (std::size_t i = 0; i < maps.size(); ++i) table += "---|";
    table += "\n";
  }
  return table;
}

std::string csvTable(const std::vector<Figures>& maps) {
  std::string table;
  for (const Column& column : kColumns)
    table += (&column == kColumns ? "" : ",") + std::string(column.name);
  table += "\n";
  for (const Figures& figures : maps) {
    for (const Column& column : kColumns) {
      table += (&column == kColumns ? "" : ",") + column.text(figures);
    }
    table += "\n";
  }
  return table;
}

}  // namespace agrid::bench
