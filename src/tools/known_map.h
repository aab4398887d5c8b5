// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "agrid/storage.h"
#include "tools/arguments.h"
#include "tools/laid_knowledge.h"
#include "tools/pipeline_options.h"

namespace agrid::tools {

/// What `--tags` names, or an empty place in frame 'map'; warnings and damage go to `warnings`.
/// @throws StorageError
StoredMap knownBefore(const Arguments& arguments, std::vector<std::string>& warnings);

/// The map of a file with what is known laid over it; all that looks wrong goes to `warnings`.
/// @throws FileError, MapError
SemanticMap makeMap(const std::string& yaml_path, const ConversionParams& params,
                    const StoredMap& known, std::vector<std::string>& warnings,
                    const StageListener& on_stage = {});

}  // namespace agrid::tools
