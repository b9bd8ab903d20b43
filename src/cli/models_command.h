#pragma once

#include "cli/program.h"

namespace dimline {

/// dimline models: the built-in models with their sizes.
Command modelsCommand();

}  // namespace dimline
