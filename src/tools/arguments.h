// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace agrid::tools {

/// The command line is not what the command takes; the usage follows it on standard error.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An option of a command.
struct Option {
  std::string name{};   ///< without dashes
  char letter = 0;      ///< short form; 0: none
  std::string value{};  ///< what its value is called in the help; empty: it takes none
  std::string help{};   ///< a line, without full stop
  bool required = false;
  bool repeatable = false;
};

/// What a command takes. Every command also takes --help.
struct Syntax {
  std::string command;
  std::string summary;                ///< what it does, in one line
  std::vector<std::string> operands;  ///< their names in the help; all are required
  std::vector<Option> options;
};

/// The line "usage: ..." of a command, without its options' meaning.
std::string usageLine(const Syntax& syntax);
/// All about a command: usage, summary, options.
std::string helpText(const Syntax& syntax);

/// The words after a command's name, taken apart: `--name value`, `--name=value`, `-n value`,
/// `-nvalue`; `--` ends the options.
class Arguments {
 public:
  /// @throws UsageError if an option is unknown or repeated, or lacks its value or has one that it
  ///         does not take, or if an operand or a required option is missing (not with --help)
  Arguments(const Syntax& syntax, const std::vector<std::string>& words);

  bool has(const std::string& option) const { return values_.count(option) > 0; }
  const std::string& operand(std::size_t index) const { return operands_.at(index); }
  /// The value of an option that is required or known to be given.
  const std::string& value(const std::string& option) const { return values_.at(option).front(); }
  std::string valueOr(const std::string& option, const std::string& otherwise) const;
  /// Every value of an option, in their order.
  std::vector<std::string> values(const std::string& option) const;
  /// @throws UsageError if the value is not a whole number in [low, high]
  long long integerOr(const std::string& option, long long otherwise, long long low,
                      long long high) const;
  /// @throws UsageError if the value is not a finite number in [low, high]
  double numberOr(const std::string& option, double otherwise, double low, double high) const;

 private:
  /// Takes the option at words[i], and its value; returns where the next word is.
  std::size_t takeOption(const Syntax& syntax, const std::vector<std::string>& words,
                         std::size_t i);
  void checkComplete(const Syntax& syntax) const;

  std::map<std::string, std::vector<std::string>> values_;
  std::vector<std::string> operands_;
};

/// The whole text as a number, whatever the locale; none if it is not a finite one.
std::optional<double> parseNumber(const std::string& text);

}  // namespace agrid::tools
