// SPDX-License-Identifier: BSD-3-Clause
#include "identity/tag_words.h"

namespace agrid {

std::string words(const Tag& tag) {
  static const char* const kKinds[] = {"area ", "door ", "object "};
  const std::string name = nameOf(tag);
  return kKinds[tag.index()] + std::to_string(idOf(tag)) + (name.empty() ? "" : " '" + name + "'");
}

void wait(const Tag& tag, bool waited, const std::string& frame, const std::string& reason,
          Recognition& result) {
  apply(DeferTag{{tag, frame, reason}}, result.knowledge);
  if (!waited) result.report.push_back(words(tag) + " waits: " + reason);
}

}  // namespace agrid
