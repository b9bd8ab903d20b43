#pragma once

#include <string>

#include "model/parameter.h"

namespace dimline {

/// What a dimension line's label says: the value with its unit; a bare count says what it counts ("Floors 3"), since a number without unit
/// beside a building would be read as metres.
std::string labelText(const Parameter& parameter, double value);

}  // namespace dimline
