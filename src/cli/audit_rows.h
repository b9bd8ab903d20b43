#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace dimline {

/// The rows of the audit's table, and what exactly each counts. "Line" is one drawn line in one frame
/// (a chain's members are lines), "outside" one whose placement is outside or guide. All lengths are on screen unless
/// metres are named.
///
/// Words that the rows share:
///   parallel           the world directions agree within 0.001 rad, or the directions on screen within 5 degrees
///   beside each other  projected onto their mean direction on screen, two lines share at least 2 px; how far they are
///                      apart is measured over the shared stretch alone
///   on one guide       the carriers in the world agree within kSamePlaneAngleRad and kSamePlaneDistance of the model
///   one side           across their mean direction both lines have moved from their base lines to the same side, and the nearer one beyond the other's base
///                      line too: short of it, it stands at another part of the model
///   distance to model  to the nearest covered pixel's centre, less half a pixel (see MaskPicture)
enum class AuditRow : std::uint8_t {
  /// Outside lines that pass through a pixel of the mask eroded by 1 px (a pixel stays when its eight neighbours are
  /// covered too).
  kCrossesModel,
  /// Labels of outside lines, and handles that are no lines, whose box holds the centre of a covered pixel; and arcs
  /// that pass through a covered pixel.
  kTouchesModel,
  /// Least distance of an outside line to the model.
  kModelDistance,
  /// Least distance of two outside lines that are parallel, beside each other and not on one guide.
  kLineDistance,
  /// Offset of a line over the least at which it would keep kHandleSpacingPx from the model and from the outside lines
  /// earlier in the layout (the order of landing), in the picture, on its own plane to its own side, and not in a hole
  /// of the model. Found by trying offsets a quarter of a pixel apart. Lines that snapped to a guide, chains and object
  /// planes are left out.
  kOffset,
  /// Pairs of lines that cross by more than half a pixel, or lie on each other for more than 2 px. Of two lines inside
  /// whose base lines in view all do that, it is said that they have no other.
  kLineCrossings,
  /// Lines that cross an extension line of another line, or an arm of an arc, by more than half a pixel.
  kExtensionCrossings,
  /// Pairs of lines, or of a line and another handle, where a label lies on the other's label, line, box or arc, or a
  /// handle on the other's line. Two inside are left out.
  kLabelOverlaps,
  /// Of two lines (a chain is one, of its members' mean length) that are outside, parallel, beside each other, on one
  /// side, not on one guide and whose base lines differ by more than 1 % in the world, the longer is more than 1 px
  /// nearer to the model than the shorter.
  kNesting,
  /// Lines inside although a slow search finds a place outside: for a visible scope's base line and a plane that its
  /// annotation allows (not slip=none), where the line keeps kHandleSpacingPx from the model and all other outside
  /// lines, 4 px from everything else that is drawn, and its label has room too, not so far behind its base line that
  /// perspective makes it hard to compare (kMostDepthRatio), nor so far across the picture from it that nobody sees what
  /// it measures (kMostReachShare). Base lines of a chained parameter are tried each for itself.
  kNeedlesslyInside,
  /// Outside lines with an end, or a label's corner, out of the viewport; other handles likewise.
  kLeavesViewport,
  /// Parameters shown in two frames that follow each other whose lines' identities differ (a chain's without the
  /// member). Hidden in one of them is no change.
  kIdentityChanges,
  /// A parameter's identity (hidden counts as one) goes from A to another and is A again at most kTakenBackFrames
  /// later, in one steady movement.
  kFlicker,
  /// Lines of the same identity, members told apart, in two frames that follow each other, one of whose ends moves more
  /// than 40 px against the base line's.
  kJumps,
  /// Members that come or go while their chain's identity stays, of all members in either frame.
  kChainMembers,
  /// Lines that differ at all when the same camera is placed again, twice.
  kStillCamera,
  /// Annotated parameters without a line or other handle, though one of their scopes is in plain view: all of it in the
  /// viewport, at least half of its screen area not behind the model (by a depth picture of the audit's own), and, for
  /// a dimension line, with a base line that is plainly long enough, not foreshortened and half seen. Reason "crowded"
  /// is accepted under 20,000 px2 of viewport a parameter.
  kUnshown
};
inline constexpr std::size_t kAuditRowCount = 17;

/// Within so many frames a change that is undone counts as taken back (AuditRow::kFlicker): what is seen for less than
/// a quarter of a second flickers.
inline constexpr std::size_t kTakenBackFrames = 15;

/// How a row's figure is made, and how it meets the aim.
enum class FigureKind : std::uint8_t {
  kCount,  ///< offences; at most the aim
  kShare,  ///< offences in all that was judged; at most the aim
  kLeast,  ///< least value; at least the aim
  kRatios  ///< median and 95th percentile; at most aim and aim95
};

struct RowDefinition {
  AuditRow row;
  std::string_view id;     ///< as the JSON names it
  std::string_view title;  ///< as the table says it
  FigureKind kind;
  double aim;
  double aim95;
};
const RowDefinition& definition(AuditRow row);

/// Whether a row compares a frame with those before it.
bool comparesFrames(AuditRow row);

/// Where in the audit a frame is.
struct FrameName {
  std::string flight{};  ///< "elevation 10", "RoofPitch=45 elevation 10", "flight 3, 640x480, 0.7 deg"
  int frame = 0;
  double azimuthDeg = 0;
  double elevationDeg = 0;
  int leg = 0;  ///< frames of one number belong to one steady movement
};

/// A row's figure.
struct Figure {
  std::size_t judged = 0;  ///< how much there was to judge; with nothing the row has no figure and meets its aim
  std::size_t offences = 0;
  std::size_t atOdds = 0;  ///< of the offences, those that are at odds with another row (AuditTally::offend)
  double value = 0;    ///< offences, share, least value, or median
  double value95 = 0;  ///< 95th percentile, of kRatios
  bool met = true;
};

/// Offences of the same parameters in the same row: how many, and the worst.
struct OffenceGroup {
  std::string names;  ///< "SillHeight × WindowWidth"
  std::size_t count = 0;
  double badness = 0;  ///< of the worst; comparable within a row
  FrameName frame;
  std::string what;
};

/// Adds up what frames were found to be like. Sums of parts, in order, are the sum of the whole.
class AuditTally {
public:
  /// So much was looked at.
  void judge(AuditRow row, std::size_t count = 1) { at(row).judged += count; }
  /// A value of a kLeast or kRatios row; judges one.
  void measure(AuditRow row, double value);
  /// One more offence. `badness` orders offences of one row; `atOdds`: who does without it commits one in another row,
  /// so that it is listed by itself. It counts all the same.
  void offend(AuditRow row, const std::string& names, double badness, const FrameName& frame, const std::string& what,
              bool atOdds = false);
  void add(const AuditTally& other);

  [[nodiscard]] Figure figure(AuditRow row) const;
  /// The `most` gravest groups of a row: by badness where the figure is an extreme or a percentile, else by count.
  [[nodiscard]] std::vector<OffenceGroup> worst(AuditRow row, std::size_t most) const;

private:
  struct Entry {
    std::size_t judged = 0;
    std::size_t offences = 0;
    std::size_t atOdds = 0;
    double least = 0;
    std::vector<double> samples;  ///< of kRatios
    std::map<std::string, OffenceGroup> groups;
  };
  [[nodiscard]] Entry& at(AuditRow row) { return entries_[static_cast<std::size_t>(row)]; }
  [[nodiscard]] const Entry& at(AuditRow row) const { return entries_[static_cast<std::size_t>(row)]; }

  std::array<Entry, kAuditRowCount> entries_;
};

}  // namespace dimline
