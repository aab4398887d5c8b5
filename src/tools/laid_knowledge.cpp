// SPDX-License-Identifier: BSD-3-Clause
#include "tools/laid_knowledge.h"

#include <utility>

#include "agrid/identity/recognition.h"

namespace agrid::tools {

LaidKnowledge layKnowledge(const Structure& structure, const StoredMap& known,
                           const PipelineParams& params, const StageListener& on_stage) {
  const Knowledge& knowledge = known.knowledge;
  const bool is_empty = knowledge.areas.empty() && knowledge.doors.empty() &&
                        knowledge.objects.empty() && knowledge.pending.empty();
  if (is_empty || known.map_id == structure.map->digest()) {
    return {annotate(structure, knowledge, params, on_stage), knowledge, {}};
  }
  const std::string& frame = known.frame_id;
  const SemanticMap fresh =
      annotate(structure, doorsFor(frame, knowledge, frame), params, on_stage);
  Recognition found = recognise(knowledge, frame, fresh, frame);
  SemanticMap map = retag(fresh, found.knowledge);
  return {std::move(map), std::move(found.knowledge), std::move(found.report)};
}

}  // namespace agrid::tools
