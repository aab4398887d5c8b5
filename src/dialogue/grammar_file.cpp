// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>
#include <utility>

#include "agrid/map/map_io.h"
#include "agrid/tags/name.h"
#include "dialogue/answers.h"
#include "dialogue/grammar_tables.h"
#include "dialogue/yaml_reader.h"
#include "map/file_reader.h"
#include "map/printable.h"
#include "map/utf8.h"
#include "semantic_map/closest_names.h"

namespace agrid::dialogue {
namespace {

constexpr const char* kFormat = "agrid_map grammar 1";
constexpr std::size_t kLargestFile = 1000000;  // bytes
constexpr std::size_t kMostPatterns = 5000;

std::string nearest(const std::string& wanted, const std::vector<std::string>& known) {
  return "there is no such key; the nearest is '" + closestNames(wanted, known, 1).at(0) + "'";
}

/// Fills the tables from a file, a section at a time.
class Filler {
 public:
  explicit Filler(const YamlReader& file) : file_(file) {}

  GrammarTables tables() {
    using Section = void (Filler::*)(const YamlPlace&);
    // in the order in which they are read: patterns refer to lists
    static const std::vector<std::pair<std::string, Section>> kSections = {
        {"format", &Filler::readFormat},       {"language", &Filler::readLanguage},
        {"decimal_mark", &Filler::readMark},   {"ignored", &Filler::readIgnored},
        {"numbers", &Filler::readNumbers},     {"robot", &Filler::readRobot},
        {"kinds", &Filler::readKinds},         {"lists", &Filler::readLists},
        {"sentences", &Filler::readSentences}, {"answers", &Filler::readAnswers}};
    const auto entries = file_.entries(file_.root());
    std::vector<std::string> known;
    for (const auto& section : kSections) known.push_back(section.first);
    for (const auto& [key, place, value] : entries) {
      if (std::find(known.begin(), known.end(), key) == known.end()) {
        file_.refuse(place, nearest(key, known));
      }
    }
    for (const auto& [name, read] : kSections) {
      const auto entry = std::find_if(entries.begin(), entries.end(),
                                      [&, &key = name](const auto& e) { return e.key == key; });
      if (entry == entries.end()) file_.refuse(file_.root(), "key '" + name + "' is missing");
      (this->*read)(entry->value);
    }
    return std::move(tables_);
  }

 private:
  void readFormat(const YamlPlace& place) {
    if (file_.text(place) != kFormat) file_.refuse(place, std::string("must be '") + kFormat + "'");
  }

  void readLanguage(const YamlPlace& place) { file_.text(place); }

  void readMark(const YamlPlace& place) { tables_.decimal_mark = file_.text(place); }

  void readIgnored(const YamlPlace& place) {
    for (const YamlText& phrase : file_.texts(place)) tables_.ignored.push_back(folded(phrase));
    std::stable_sort(tables_.ignored.begin(), tables_.ignored.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
  }

  void readNumbers(const YamlPlace& place) {
    for (const auto& [word, word_place, value] : file_.entries(place)) {
      const auto number = numberIn(file_.text(value), {});
      if (!number) file_.refuse(value, "must be a number in [0, 1000]");
      tables_.numbers[foldCase(word)] = *number;
    }
  }

  void readRobot(const YamlPlace& place) {
    for (const YamlText& phrase : file_.texts(place)) {
      tables_.robot.push_back(utf8Of(folded(phrase)));
    }
  }

  void readKinds(const YamlPlace& place) {
    static const std::map<std::string, TagKind> kKinds = {
        {"area", TagKind::kArea}, {"door", TagKind::kDoor}, {"object", TagKind::kObject}};
    for (const auto& [name, name_place, words] : file_.entries(place)) {
      const auto kind = kKinds.find(name);
      if (kind == kKinds.end()) file_.refuse(name_place, nearest(name, {"area", "door", "object"}));
      for (const YamlText& word : file_.texts(words)) {
        tables_.kinds[utf8Of(folded(word))] = kind->second;
      }
    }
  }

  void readLists(const YamlPlace& place) {
    for (const auto& [name, name_place, phrases] : file_.entries(place)) {
      for (const YamlText& phrase : file_.texts(phrases)) {
        parsed(phrase, nullptr);
        lists_[name].push_back(phrase.text);
      }
    }
  }

  void readSentences(const YamlPlace& place) {
    std::vector<std::string> known;
    for (const Intent& intent : allIntents()) known.push_back(intent.key);
    for (const auto& [key, key_place, patterns] : file_.entries(place)) {
      const auto index = std::find(known.begin(), known.end(), key) - known.begin();
      if (static_cast<std::size_t>(index) == known.size()) {
        file_.refuse(key_place, nearest(key, known));
      }
      const Intent& intent = allIntents()[static_cast<std::size_t>(index)];
      for (const YamlText& pattern : file_.texts(patterns)) readPattern(pattern, intent);
    }
  }

  void readPattern(const YamlText& text, const Intent& intent) {
    if (tables_.ways.size() >= kMostPatterns) {
      file_.refuse(text.place,
                   "there are more than " + std::to_string(kMostPatterns) + " patterns");
    }
    Pattern pattern = parsed(text, &lists_);
    std::string known;
    for (const auto* names : {&intent.one_of, &intent.allowed}) {
      for (const std::string& name : *names) known += " {" + name + "}";
    }
    std::set<std::string> strange = slotNames(pattern);
    for (const auto* names : {&intent.one_of, &intent.allowed}) {
      for (const std::string& name : *names) strange.erase(name);
    }
    if (!strange.empty()) {
      file_.refuse(text.place, "there is no slot {" + *strange.begin() + "} here, there is" +
                                   (known.empty() ? " none" : known));
    }
    const SlotCount count = countSlots(pattern, intent.one_of);
    if (!intent.one_of.empty() && (count.least != 1 || count.most != 1)) {
      file_.refuse(text.place, "it must hold exactly one of the slots {" + joined(intent.one_of) +
                                   "}, however it is said");
    }
    if (leastLetters(pattern) == 0)
      file_.refuse(text.place, "it can be said with no words of its own");
    tables_.ways.push_back({std::move(pattern), &intent});
  }

  void readAnswers(const YamlPlace& place) {
    std::vector<std::string> known;
    for (const AnswerKey& key : allAnswerKeys()) known.push_back(key.key);
    for (const auto& [key, key_place, value] : file_.entries(place)) {
      const auto index = std::find(known.begin(), known.end(), key) - known.begin();
      if (static_cast<std::size_t>(index) == known.size())
        file_.refuse(key_place, nearest(key, known));
      const std::string text = file_.text(value);
      const std::string problem =
          codePointsOf(text)
              ? problemOfTemplate(allAnswerKeys()[static_cast<std::size_t>(index)], text)
              : "it is not UTF-8";
      if (!problem.empty()) file_.refuse(value, problem);
      tables_.answers[key] = text;
    }
    std::vector<std::string> missing;
    std::copy_if(known.begin(), known.end(), std::back_inserter(missing),
                 [&](const std::string& key) { return tables_.answers.count(key) == 0; });
    if (!missing.empty()) file_.refuse(place, "missing: " + joined(missing));
  }

  Pattern parsed(const YamlText& pattern, const WordLists* lists) const {
    try {
      return parsePattern(pattern.text, lists);
    } catch (const PatternError& error) {
      file_.refuse(pattern.place,
                   "'" + printable(pattern.text.substr(0, 128)) + "': " + error.what());
    }
  }

  /// A phrase as it is compared with sentences.
  std::u32string folded(const YamlText& phrase) const {
    const auto sentence = sentenceOf(phrase.text);
    if (!sentence || sentence->folded.empty())
      file_.refuse(phrase.place, "it has no words in UTF-8");
    return sentence->folded;
  }

  const YamlReader& file_;
  WordLists lists_;
  GrammarTables tables_;
};

}  // namespace

Grammar parseGrammar(const std::string& text, const std::string& name) {
  const YamlReader file(text, printable(name));
  return Grammar(std::make_shared<const GrammarTables>(Filler(file).tables()));
}

Grammar loadGrammar(const std::string& path) {
  FileReader reader(path);
  if (reader.size() > kLargestFile) {
    reader.fail(FileErrorCode::kYaml, "larger than " + std::to_string(kLargestFile) + " bytes");
  }
  std::string text(static_cast<std::size_t>(reader.size()), '\0');
  text.resize(reader.read(reinterpret_cast<std::uint8_t*>(text.data()), text.size()));
  return parseGrammar(text, path);
}

}  // namespace agrid::dialogue
