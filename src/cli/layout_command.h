#pragma once

#include "cli/program.h"

namespace dimline {

/// dimline layout: the dimension lines of a model for one or more cameras, as JSON, masks and drawings.
Command layoutCommand();

}  // namespace dimline
