// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "agrid/geometry/point2.h"

namespace agrid {

using Json = nlohmann::json;

/// A tenth of a millimetre is finer than any map; more digits only hide what changed.
double rounded(double value);

/// [x, y]
Json jsonPoint(const Point2& point);

/// JSON as text. Names come from people: bytes that are no UTF-8 are replaced, not thrown at.
std::string jsonText(const Json& json, int indent = -1);

/// The member "crs" of a collection in metres of a frame: readers that find none take the numbers
/// for degrees (GDAL 3.6 reads this one, and neither null nor a name of its own).
Json jsonFrame(const std::string& frame_id);

/// An array with a line for each element, so that what changed shows line by line.
std::string jsonLines(const Json& array);

}  // namespace agrid
