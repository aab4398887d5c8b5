// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tools/place_view.h"
#include "tools/tag_sentences.h"

namespace agrid::tools {

/// What is wrong whatever the map: names that several things of a kind bear, whatever their case,
/// and tags that wait.
void findInTags(const Knowledge& knowledge, Sentences& findings);

/// What is wrong with the place: doors with an area on one side only or the same on both, areas
/// that no door leads to, seeds of several areas in one, objects in none, warnings.
void findInPlace(const PlaceView& view, Sentences& findings);

}  // namespace agrid::tools
