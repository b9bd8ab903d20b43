#include "cli/audit_report.h"

#include <iomanip>
#include <ostream>

#include "core/text.h"

namespace dimline {

namespace {

constexpr int kTitleWidth = 55;
constexpr int kFigureWidth = 22;

/// What the figure of a row is measured for in frozen lines: they were not looked for a better place.
bool searched(AuditRow row) {
  return row == AuditRow::kOffset || row == AuditRow::kNeedlesslyInside || row == AuditRow::kStillCamera;
}

std::string shareText(double share) { return formatFixed(100 * share, 2) + " %"; }

std::string figureText(const RowDefinition& row, const Figure& figure) {
  if (row.kind == FigureKind::kCount) return std::to_string(figure.offences) + " of " + std::to_string(figure.judged);
  if (figure.judged == 0) return "-";
  switch (row.kind) {
    case FigureKind::kShare:
      return shareText(figure.value) + " of " + std::to_string(figure.judged);
    case FigureKind::kLeast:
      return formatFixed(figure.value, 1) + " (" + std::to_string(figure.offences) + " below)";
    case FigureKind::kRatios:
      return formatFixed(figure.value, 2) + ", 95th " + formatFixed(figure.value95, 2);
    case FigureKind::kCount:
      break;
  }
  return {};
}

std::string aimText(const RowDefinition& row) {
  switch (row.kind) {
    case FigureKind::kCount:
      return formatFixed(row.aim, 0);
    case FigureKind::kShare:
      return "<= " + formatFixed(100 * row.aim, 1) + " %";
    case FigureKind::kLeast:
      return ">= " + formatFixed(row.aim, 1);
    case FigureKind::kRatios:
      return "<= " + formatFixed(row.aim, 2) + ", " + formatFixed(row.aim95, 1);
  }
  return {};
}

void printGroup(const OffenceGroup& group, std::ostream& out) {
  out << "      " << group.names << ": " << group.count << "x; " << group.frame.flight << ", azimuth "
      << formatFixed(group.frame.azimuthDeg, 0) << " (frame " << group.frame.frame << "): " << group.what << "\n";
}

void writeNumber(JsonWriter& json, std::string_view key, bool there, double value) {
  json.key(key);
  there ? json.value(value) : json.null();
}

void writeRow(JsonWriter& json, const AuditPart& part, const RowDefinition& row, std::size_t worst) {
  const Figure figure = part.placed.figure(row.row);
  const Figure frozen = part.frozen.figure(row.row);
  const bool ratios = row.kind == FigureKind::kRatios;
  const bool frozenThere = !searched(row.row) && frozen.judged > 0;
  json.beginObject();
  json.key("row").value(row.id);
  json.key("title").value(row.title);
  writeNumber(json, "figure", figure.judged > 0, figure.value);
  writeNumber(json, "figure95", ratios && figure.judged > 0, figure.value95);
  json.key("aim").value(row.aim);
  writeNumber(json, "aim95", ratios, row.aim95);
  json.key("met").value(figure.met);
  json.key("judged").value(figure.judged);
  json.key("offences").value(figure.offences);
  json.key("atOdds").value(figure.atOdds);
  writeNumber(json, "frozen", frozenThere, frozen.value);
  json.key("worst").beginArray();
  for (const OffenceGroup& group : part.placed.worst(row.row, worst)) {
    json.beginObject();
    json.key("parameters").value(group.names);
    json.key("count").value(group.count);
    json.key("flight").value(group.frame.flight);
    json.key("frame").value(group.frame.frame);
    json.key("azimuthDeg").value(group.frame.azimuthDeg);
    json.key("elevationDeg").value(group.frame.elevationDeg);
    json.key("what").value(group.what);
    json.endObject();
  }
  json.endArray();
  json.endObject();
}

}  // namespace

void printAudit(const Model& model, const AuditPart& part, std::size_t worst, std::ostream& out) {
  std::size_t met = 0, measured = 0;
  out << model.definition.name << ", " << part.title << ": " << part.flights.size() << " flights, " << part.frames
      << " frames, " << part.framesMeasured << " of them held against their pixels, in " << formatFixed(part.seconds, 0)
      << " s\n";
  out << std::left << std::setw(kTitleWidth) << "measure" << std::setw(kFigureWidth) << "placed"
      << std::setw(kFigureWidth) << "fixed in the world" << std::setw(16) << "aim"
      << "\n";
  for (std::size_t i = 0; i < kAuditRowCount; ++i) {
    const RowDefinition& row = definition(static_cast<AuditRow>(i));
    if (!part.measures(row.row)) continue;
    ++measured;
    const Figure figure = part.placed.figure(row.row);
    met += figure.met ? 1 : 0;
    out << std::setw(kTitleWidth) << row.title << std::setw(kFigureWidth) << figureText(row, figure)
        << std::setw(kFigureWidth) << (searched(row.row) ? "-" : figureText(row, part.frozen.figure(row.row)))
        << std::setw(16) << aimText(row) << (figure.met ? "ok" : "MISSED") << "\n";
    if (figure.met) continue;
    if (figure.atOdds > 0) {
      out << std::setw(kTitleWidth) << "  of these at odds with another row" << figure.atOdds << "\n";
    }
    for (const OffenceGroup& group : part.placed.worst(row.row, worst)) printGroup(group, out);
  }
  out << met << " of " << measured << " aims met.\n";
  out << "(-: not measured. Of lines that are fixed in the world it is known that they do not look for a better place.)\n";
}

void writeAudit(JsonWriter& json, const Model& model, const std::vector<AuditPart>& parts, std::size_t worst) {
  json.beginObject();
  json.key("model").value(model.definition.name);
  json.key("parts").beginArray();
  for (const AuditPart& part : parts) {
    json.beginObject();
    json.key("part").value(part.title);
    json.key("flights").value(part.flights.size());
    json.key("frames").value(part.frames);
    json.key("framesMeasured").value(part.framesMeasured);
    json.key("rows").beginArray();
    for (std::size_t i = 0; i < kAuditRowCount; ++i) {
      const auto row = static_cast<AuditRow>(i);
      if (part.measures(row)) writeRow(json, part, definition(row), worst);
    }
    json.endArray();
    json.endObject();
  }
  json.endArray();
  json.endObject();
}

}  // namespace dimline
