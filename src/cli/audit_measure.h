#pragma once

#include <span>

#include "cli/audit_rows.h"
#include "cli/audit_search.h"

namespace dimline {

/// Measures the rows that concern one frame: all but identity changes, flicker, jumps, chain members and the still
/// camera. `searching`: also look for lesser offsets and for places outside, which takes longest.
void measureFrame(const AuditedFrame& frame, const FrameName& name, bool searching, AuditTally& tally);

/// Measures the rows that concern frames in their order: identity changes, flicker, jumps, chain members. `names`
/// belong to `layouts` one to one. `odds`: of the same flight, or null.
void measureSteps(const Model& model, std::span<const Layout> layouts, std::span<const FrameName> names, Odds* odds,
                  AuditTally& tally);

/// Measures the still camera: the same frame placed twice.
void measureStill(const Model& model, const Layout& first, const Layout& second, const FrameName& name,
                  AuditTally& tally);

/// The names of the parameters that an offence concerns: "SillHeight × WindowWidth", in alphabetical order.
std::string parameterNames(const Model& model, std::size_t a, std::size_t b);

}  // namespace dimline
