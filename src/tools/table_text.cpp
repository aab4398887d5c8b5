// SPDX-License-Identifier: BSD-3-Clause
#include "tools/table_text.h"

#include <algorithm>
#include <cstdio>

namespace agrid::tools {

std::string formatted(const char* format, double value) {
  char digits[64];
  std::snprintf(digits, sizeof digits, format, value);
  return digits;
}

std::string markdownTable(const std::vector<TableRow>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const TableRow& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string table;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    table += "|";
    for (std::size_t i = 0; i < rows[r].size(); ++i) {
      const std::string padding(widths[i] - rows[r][i].size(), ' ');
      table += " " + (i == 0 ? rows[r][i] + padding : padding + rows[r][i]) + " |";
    }
    table += "\n";
    if (r > 0) continue;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      table += "|" + std::string(widths[i] + 1, '-') + (i == 0 ? "-" : ":");
    }
    table += "|\n";
  }
  return table;
}

std::string csvField(const std::string& value) {
  if (value.find_first_of(",\"\n") == std::string::npos) return value;
  std::string quoted = "\"";
  for (const char c : value) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace agrid::tools
