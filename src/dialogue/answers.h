// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "dialogue/grammar_tables.h"

namespace agrid::dialogue {

/// A sentence that can be answered, and what may fill its slots.
struct AnswerKey {
  std::string key;
  std::vector<std::string> slots;
};

/// Every key that a grammar's answers must have.
const std::vector<AnswerKey>& allAnswerKeys();

/// What is wrong with a template, such as a slot that its key does not know; empty if nothing is.
std::string problemOfTemplate(const AnswerKey& key, const std::string& text);

/// The template of a key with its slots filled.
std::string say(const GrammarTables& tables, const std::string& key, const Slots& slots = {});

/// A length in metres with one decimal.
std::string lengthText(const GrammarTables& tables, double length);

/// 'a', 'a and b', 'a, b and c'.
std::string listText(const GrammarTables& tables, const std::vector<std::string>& items);

}  // namespace agrid::dialogue
