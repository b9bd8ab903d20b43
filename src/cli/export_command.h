#pragma once

#include "cli/program.h"

namespace dimline {

/// dimline export: a model as a .glb file.
Command exportCommand();

}  // namespace dimline
