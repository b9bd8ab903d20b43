#pragma once

#include "cli/program.h"

namespace dimline {

/// dimline bench: how long placing lines takes.
Command benchCommand();

}  // namespace dimline
