#include <algorithm>
#include <map>

#include "cli/audit_run.h"
#include "cli/output_file.h"
#include "core/text.h"
#include "render/svg_writer.h"

namespace dimline {

namespace {

/// What a drawing shows.
struct Wanted {
  std::string path;
  OffenceGroup offence;
};

/// The frames to draw, by flight and number.
using WantedFrames = std::map<std::string, std::multimap<int, Wanted>>;

WantedFrames wantedFrames(const AuditPart& part, std::size_t worst, const std::string& folder) {
  WantedFrames wanted;
  for (std::size_t i = 0; i < kAuditRowCount; ++i) {
    const RowDefinition& row = definition(static_cast<AuditRow>(i));
    if (part.placed.figure(row.row).met) continue;
    int number = 0;
    for (const OffenceGroup& group : part.placed.worst(row.row, worst)) {
      const std::string path =
          folder + "/" + part.title + "-" + std::string(row.id) + "-" + std::to_string(++number) + ".svg";
      wanted[group.frame.flight].insert({group.frame.frame, {path, group}});
    }
  }
  return wanted;
}

Status drawFlight(const Model& model, const AuditPart::Leg& leg, const std::multimap<int, Wanted>& frames) {
  const Scene scene = model.definition.build(leg.values);
  const auto last = static_cast<std::size_t>(frames.rbegin()->first) + 1;  // frames know of those before them alone
  Flight flight = leg.flight;
  flight.cameras.resize(last);
  flight.names.resize(last);
  AuditTally ignored;
  const FlownFlight flown = fly(model, scene, leg.values, std::move(flight), ignored);
  for (const auto& [number, wanted] : frames) {
    const FrameName& frame = wanted.offence.frame;
    const std::string title = wanted.offence.names + ": " + wanted.offence.what + " (" + frame.flight + ", azimuth " +
                              formatFixed(frame.azimuthDeg, 0) + ")";
    const Status status =
        writeFile(wanted.path, writeSvg(scene, flown.layouts[static_cast<std::size_t>(number)], title));
    if (!status) return status;
  }
  return okStatus();
}

}  // namespace

Status drawWorst(const Model& model, const std::vector<AuditPart>& parts, std::size_t worst,
                 const std::string& folder) {
  for (const AuditPart& part : parts) {
    for (const auto& [name, frames] : wantedFrames(part, worst, folder)) {
      const auto leg = std::ranges::find_if(
          part.flights, [&](const AuditPart::Leg& l) { return l.flight.names.front().flight == name; });
      if (leg == part.flights.end()) continue;
      if (Status status = drawFlight(model, *leg, frames); !status) return status;
    }
  }
  return okStatus();
}

}  // namespace dimline
