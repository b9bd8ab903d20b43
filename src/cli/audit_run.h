#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "cli/audit_flight.h"
#include "cli/audit_rows.h"
#include "core/result.h"
#include "model/model.h"

namespace dimline {

/// What an audit looks at.
struct AuditPlan {
  double stepDeg = 1;  ///< of the orbits; the rows that compare frames mean one degree
  int widthPx = 1000;  ///< of the orbits
  int heightPx = 1000;
  bool extremes = false;  ///< also the orbits at each parameter's least and greatest value, and at each choice
  int flights = 0;        ///< also so many random flights
  std::optional<double> restDeg{};  ///< also orbits and flights with a rest after each such turn (in a flight after as many steps), by the pictures at rest
  /// Every frame is placed and compared with the one before; of so many frames one is held against its pixels. Unless
  /// told: each of the orbits at the given values, one of 15 at the extremes, one of 12 in flights.
  std::optional<int> every;
};

/// One table: what was found over some flights.
struct AuditPart {
  std::string title;  ///< "orbits", "rests", "extremes", "flights", "flight-rests"
  /// The ways that were flown, and at which values of the parameters.
  struct Leg {
    Values values;
    Flight flight;
  };
  std::vector<Leg> flights;
  std::size_t frames = 0;
  std::size_t framesMeasured = 0;  ///< held against their pixels
  double seconds = 0;
  AuditTally placed;
  AuditTally frozen;  ///< the first frame's lines of each flight, fixed in the world

  /// Whether a row was measured. Of flights that rest the pictures at rest are, and other frames lie between them.
  [[nodiscard]] bool measures(AuditRow row) const { return !comparesFrames(row) || flights.empty() || flights.front().flight.restEvery == 0; }
};

/// Places a model along many ways round it and measures every AuditRow. Uses all processors; the
/// same plan gives the same result however many there are. Tells of its progress on `progress`.
std::vector<AuditPart> auditModel(const Model& model, const Values& values, const AuditPlan& plan,
                                  std::ostream& progress);

/// Writes the drawings of the frames that the report lists, the gravest `worst` of each row that misses its aim, as
/// FOLDER/orbits-flicker-1.svg and so on, in a folder that is there. Flies there again for that.
Status drawWorst(const Model& model, const std::vector<AuditPart>& parts, std::size_t worst, const std::string& folder);

}  // namespace dimline
