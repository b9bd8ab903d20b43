#pragma once

#include "cli/program.h"

namespace dimline {

/// dimline audit: DESIGN.md section 8's first table, measured.
Command auditCommand();

}  // namespace dimline
