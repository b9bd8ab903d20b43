#pragma once

#include "cli/program.h"

namespace dimline {

/// dimline audit: what good lines look like (AuditRow), measured.
Command auditCommand();

}  // namespace dimline
