#include "cli/audit_rows.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace dimline {

namespace {

constexpr std::array<RowDefinition, kAuditRowCount> kRows{{
    {AuditRow::kCrossesModel, "crosses-model", "outside lines that cross the model", FigureKind::kCount, 0, 0},
    {AuditRow::kTouchesModel, "touches-model", "outside labels and handles that touch the model", FigureKind::kCount, 0,
     0},
    {AuditRow::kModelDistance, "model-distance", "least distance of an outside line to the model (px)",
     FigureKind::kLeast, 29.5, 0},
    {AuditRow::kLineDistance, "line-distance", "least distance of two parallel outside lines (px)", FigureKind::kLeast,
     29.5, 0},
    {AuditRow::kOffset, "offset", "offset against the least offset", FigureKind::kRatios, 1.05, 1.5},
    {AuditRow::kLineCrossings, "line-crossings", "line-line crossings", FigureKind::kCount, 0, 0},
    {AuditRow::kExtensionCrossings, "extension-crossings", "lines that cross another's extension line",
     FigureKind::kShare, 0.01, 0},
    {AuditRow::kLabelOverlaps, "label-overlaps", "labels on another label, line or handle", FigureKind::kCount, 0, 0},
    {AuditRow::kNesting, "nesting", "the longer of two parallel lines nearer to the model", FigureKind::kShare, 0.01,
     0},
    {AuditRow::kNeedlesslyInside, "needlessly-inside", "inside though an outside place exists", FigureKind::kCount, 0,
     0},
    {AuditRow::kLeavesViewport, "leaves-viewport", "outside lines and labels that leave the viewport",
     FigureKind::kCount, 0, 0},
    {AuditRow::kIdentityChanges, "identity-changes", "identity changes from frame to frame", FigureKind::kShare, 0.02,
     0},
    {AuditRow::kFlicker, "flicker", "changes taken back within 15 frames", FigureKind::kCount, 0, 0},
    {AuditRow::kJumps, "jumps", "moves of more than 40 px against the base line", FigureKind::kShare, 0.002, 0},
    {AuditRow::kChainMembers, "chain-members", "chain members that come or go", FigureKind::kShare, 0.02, 0},
    {AuditRow::kStillCamera, "still-camera", "lines that move before a still camera", FigureKind::kCount, 0, 0},
    {AuditRow::kUnshown, "unshown", "features in plain view without a line", FigureKind::kCount, 0, 0},
}};

/// The sample that a share of all samples does not exceed; `samples` is reordered.
double percentile(std::vector<double>& samples, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(samples.size() - 1) + 0.5);
  std::nth_element(samples.begin(), samples.begin() + rank, samples.end());
  return samples[static_cast<std::size_t>(rank)];
}

void keepWorse(OffenceGroup& group, const OffenceGroup& other) {
  if (group.count == 0 || other.badness > group.badness) {
    group.badness = other.badness;
    group.frame = other.frame;
    group.what = other.what;
  }
  group.count += other.count;
}

}  // namespace

const RowDefinition& definition(AuditRow row) {
  const RowDefinition& found = kRows[static_cast<std::size_t>(row)];
  assert(found.row == row);
  return found;
}

bool comparesFrames(AuditRow row) {
  return row == AuditRow::kIdentityChanges || row == AuditRow::kFlicker || row == AuditRow::kJumps || row == AuditRow::kChainMembers;
}

void AuditTally::measure(AuditRow row, double value) {
  Entry& entry = at(row);
  entry.least = entry.judged == 0 ? value : std::min(entry.least, value);
  ++entry.judged;
  if (definition(row).kind == FigureKind::kRatios) entry.samples.push_back(value);
}

void AuditTally::offend(AuditRow row, const std::string& names, double badness, const FrameName& frame,
                        const std::string& what, bool atOdds) {
  Entry& entry = at(row);
  ++entry.offences;
  entry.atOdds += atOdds ? 1 : 0;
  const std::string who = names + (atOdds ? ", at odds with another row" : "");
  OffenceGroup& group = entry.groups[who];
  group.names = who;
  keepWorse(group, {.names = who, .count = 1, .badness = badness, .frame = frame, .what = what});
}

void AuditTally::add(const AuditTally& other) {
  for (std::size_t i = 0; i < kAuditRowCount; ++i) {
    Entry& to = entries_[i];
    const Entry& from = other.entries_[i];
    if (from.judged > 0) to.least = to.judged == 0 ? from.least : std::min(to.least, from.least);
    to.judged += from.judged;
    to.offences += from.offences;
    to.atOdds += from.atOdds;
    to.samples.insert(to.samples.end(), from.samples.begin(), from.samples.end());
    for (const auto& [names, group] : from.groups) {
      OffenceGroup& mine = to.groups[names];
      mine.names = names;
      keepWorse(mine, group);
    }
  }
}

Figure AuditTally::figure(AuditRow row) const {
  const Entry& entry = at(row);
  const RowDefinition& rule = definition(row);
  Figure figure{.judged = entry.judged, .offences = entry.offences, .atOdds = entry.atOdds};
  if (entry.judged == 0) return figure;
  switch (rule.kind) {
    case FigureKind::kCount:
      figure.value = static_cast<double>(entry.offences);
      figure.met = figure.value <= rule.aim;
      break;
    case FigureKind::kShare:
      figure.value = static_cast<double>(entry.offences) / static_cast<double>(entry.judged);
      figure.met = figure.value <= rule.aim;
      break;
    case FigureKind::kLeast:
      figure.value = entry.least;
      figure.met = figure.value >= rule.aim;
      break;
    case FigureKind::kRatios: {
      std::vector<double> samples = entry.samples;
      figure.value = percentile(samples, 0.5);
      figure.value95 = percentile(samples, 0.95);
      figure.met = figure.value <= rule.aim && figure.value95 <= rule.aim95;
      break;
    }
  }
  return figure;
}

std::vector<OffenceGroup> AuditTally::worst(AuditRow row, std::size_t most) const {
  std::vector<OffenceGroup> groups;
  for (const auto& [names, group] : at(row).groups) groups.push_back(group);
  const FigureKind kind = definition(row).kind;
  const bool byBadness = kind == FigureKind::kLeast || kind == FigureKind::kRatios;
  std::ranges::stable_sort(groups, [&](const OffenceGroup& a, const OffenceGroup& b) {
    return byBadness ? a.badness > b.badness : a.count != b.count ? a.count > b.count : a.badness > b.badness;
  });
  if (groups.size() > most) groups.resize(most);
  return groups;
}

}  // namespace dimline
