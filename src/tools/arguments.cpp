// SPDX-License-Identifier: BSD-3-Clause
#include "tools/arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>

namespace agrid::tools {
namespace {

const Option kHelp{"help", 'h', "", "show this text", false, false};

/// An option as found on the command line; `attached` is the value in the same word.
struct Match {
  const Option* option = nullptr;
  std::optional<std::string> attached;
};

bool isOption(const std::string& word) { return word.size() > 1 && word[0] == '-'; }

const Option* findOption(const Syntax& syntax, const std::string& name, char letter) {
  const auto same = [&](const Option& o) {
    return letter != 0 ? o.letter == letter : o.name == name;
  };
  if (same(kHelp)) return &kHelp;
  const auto found = std::find_if(syntax.options.begin(), syntax.options.end(), same);
  return found == syntax.options.end() ? nullptr : &*found;
}

Match matchOption(const Syntax& syntax, const std::string& word) {
  Match match;
  if (word[1] == '-') {
    const auto equals = word.find('=');
    match.option = findOption(syntax, word.substr(2, equals - 2), 0);
    if (equals != std::string::npos) match.attached = word.substr(equals + 1);
  } else {
    match.option = findOption(syntax, "", word[1]);
    if (word.size() > 2) match.attached = word.substr(2);
  }
  return match;
}

std::string optionName(const Option& option) {
  std::string name = option.letter ? std::string("-") + option.letter + ", " : "    ";
  name += "--" + option.name;
  return option.value.empty() ? name : name + " " + option.value;
}

std::string optionUsage(const Option& option) {
  const std::string name =
      option.letter ? std::string("-") + option.letter : std::string("--") + option.name;
  const std::string full = option.value.empty() ? name : name + " " + option.value;
  return option.required ? full : "[" + full + "]";
}

}  // namespace

std::string usageLine(const Syntax& syntax) {
  std::string line = "usage: agrid_map_tool " + syntax.command;
  for (const std::string& operand : syntax.operands) line += " " + operand;
  for (const Option& option : syntax.options) line += " " + optionUsage(option);
  return line;
}

std::string helpText(const Syntax& syntax) {
  std::string text = usageLine(syntax) + "\n\n" + syntax.summary + "\n\n";
  std::vector<Option> options = syntax.options;
  options.push_back(kHelp);
  std::size_t width = 0;
  for (const Option& option : options) width = std::max(width, optionName(option).size());
  for (const Option& option : options) {
    std::string name = optionName(option);
    name.resize(width + 2, ' ');
    text += "  " + name + option.help + "\n";
  }
  return text;
}

Arguments::Arguments(const Syntax& syntax, const std::vector<std::string>& words) {
  std::size_t i = 0;
  while (i < words.size() && words[i] != "--") {
    if (isOption(words[i])) {
      i = takeOption(syntax, words, i);
    } else {
      operands_.push_back(words[i++]);
    }
  }
  for (++i; i < words.size(); ++i) operands_.push_back(words[i]);
  if (!has("help")) checkComplete(syntax);
}

std::size_t Arguments::takeOption(const Syntax& syntax, const std::vector<std::string>& words,
                                  std::size_t i) {
  Match match = matchOption(syntax, words[i]);
  if (!match.option) throw UsageError("unknown option '" + words[i] + "'");
  const Option& option = *match.option;
  if (option.value.empty() && match.attached) {
    throw UsageError("option '--" + option.name + "' takes no value");
  }
  if (!option.value.empty() && !match.attached) {
    // A known option in the value's place is a forgotten value, not a value.
    const bool missing = i + 1 == words.size() || words[i + 1] == "--" ||
                         (isOption(words[i + 1]) && matchOption(syntax, words[i + 1]).option);
    if (missing) throw UsageError("option '--" + option.name + "' needs a value");
    match.attached = words[++i];
  }
  if (has(option.name) && !option.repeatable && option.name != "help") {
    throw UsageError("option '--" + option.name + "' is given twice");
  }
  values_[option.name].push_back(match.attached.value_or(""));
  return i + 1;
}

void Arguments::checkComplete(const Syntax& syntax) const {
  if (operands_.size() < syntax.operands.size()) {
    throw UsageError(syntax.operands[operands_.size()] + " is missing");
  }
  if (operands_.size() > syntax.operands.size()) {
    throw UsageError("unexpected '" + operands_[syntax.operands.size()] + "'");
  }
  for (const Option& option : syntax.options) {
    if (option.required && !has(option.name)) {
      throw UsageError("option '--" + option.name + "' is missing");
    }
  }
}

std::string Arguments::valueOr(const std::string& option, const std::string& otherwise) const {
  return has(option) ? value(option) : otherwise;
}

std::vector<std::string> Arguments::values(const std::string& option) const {
  return has(option) ? values_.at(option) : std::vector<std::string>{};
}

long long Arguments::integerOr(const std::string& option, long long otherwise, long long low,
                               long long high) const {
  if (!has(option)) return otherwise;
  const std::string& text = value(option);
  long long number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < low || number > high) {
    throw UsageError("option '--" + option + "' takes a whole number from " + std::to_string(low) +
                     " to " + std::to_string(high) + ", not '" + text + "'");
  }
  return number;
}

double Arguments::numberOr(const std::string& option, double otherwise, double low,
                           double high) const {
  if (!has(option)) return otherwise;
  const auto number = parseNumber(value(option));
  if (!number || *number < low || *number > high) {
    std::ostringstream message;
    message << "option '--" << option << "' takes a number from " << low << " to " << high
            << ", not '" << value(option) << "'";
    throw UsageError(message.str());
  }
  return *number;
}

std::optional<double> parseNumber(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double number = 0;
  stream >> std::noskipws >> number;
  if (!stream || stream.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

}  // namespace agrid::tools
