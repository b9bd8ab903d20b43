#pragma once

#include <iosfwd>

#include "app/json_writer.h"
#include "cli/audit_run.h"

namespace dimline {

/// The table of one part of an audit, with the gravest `worst` groups of offences below each row that misses its aim.
void printAudit(const Model& model, const AuditPart& part, std::size_t worst, std::ostream& out);

/// One object a model:
///     {"model", "parts": [{"part", "flights", "frames", "framesMeasured", "rows": [
///       {"row", "title", "figure", "figure95", "aim", "aim95", "met", "judged", "offences", "frozen",
///        "worst": [{"parameters", "count", "flight", "frame", "azimuthDeg", "elevationDeg", "what"}]}]}]}
/// "frozen" is the figure of the lines that stay fixed in the world. A figure with nothing to judge is null, and so are
/// figure95 and aim95 but for the offset.
void writeAudit(JsonWriter& json, const Model& model, const std::vector<AuditPart>& parts, std::size_t worst);

}  // namespace dimline
