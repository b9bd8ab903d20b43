#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/reserved.h"
#include "placement/layout.h"

namespace dimline {

/// The extension lines of a line, from its base line by way of its foot on the plane, in parts, the last ones of both first. A foot that is the base line's own end makes a part of no length, which
/// crosses nothing.
constexpr std::size_t kExtensionParts = 4;
inline std::array<Segment2, kExtensionParts> extensionParts(const Segment2& base, const Segment2& foot, const Segment2& line) {
  return {Segment2{foot.start, line.start}, Segment2{foot.end, line.end}, Segment2{base.start, foot.start}, Segment2{base.end, foot.end}};
}
/// Whether the part of that number is the last of its extension line, which may have a jog; of several lines' parts, one line's after the other's.
constexpr bool isLastPart(std::size_t number) { return number % kExtensionParts < 2; }

/// What has been placed so far in this frame, as it lies on screen: the exact side of what the fields know by strips. Answers the score's Intersect term,
/// whether a label has room, and whether a line may lie on a guide. It stands for the flags that the paper keeps with the fields' values (4.5, figure 16): those tell that a line
/// comes to where an earlier one has changed a strip, this tells whether the two cross.
class Landed {
 public:
  /// There is room for so many from the start: inside the model are none in most frames, and then suddenly some.
  static constexpr std::size_t kReservedLines = 32;
  /// No parameter's number.
  static constexpr int kNobody = -2;

  void clear();
  /// Room for as much as another one has room for.
  void makeRoomLike(const Landed& other);
  /// `guide`: the number of the guide that the line lies on or has made; -1 when it has none.
  void add(const PlacedLine& line, int guide);
  /// A line on screen with its base line and its foot on the plane, without a label.
  void add(const Segment2& base, const Segment2& foot, const Segment2& line);
  void addLabel(const Box2& label) { labels_.push_back(label); }
  /// Takes a label away that was added just so.
  void removeLabel(const Box2& label);
  /// Whether this part of an extension line has landed already, with a line of that parameter (-1: of one that was added without): neighbours in a chain share one.
  [[nodiscard]] bool hasExtension(const Segment2& part, int parameter = -1) const;
  /// What a line that stands where it stands will take up when its turn comes; to be released then. Until then it counts as an extension line, which labels keep off and
  /// lines cross at a price: what is nearer to the model must still find room between.
  void reserve(const PlacedLine& line);
  void release(const PlacedLine& line);
  /// A pill, or an arc with its label.
  void add(const PlacedHandle& handle, const View& view);

  /// How much there is, and taking back what was added since.
  struct Mark {
    std::size_t lines = 0, extensions = 0, labels = 0;
  };
  [[nodiscard]] Mark mark() const { return {lines_.size(), extensions_.size(), labels_.size()}; }
  void backTo(const Mark& mark);
  /// A part of an extension line, and the parameter whose line it belongs to; -1 with a line that was added without.
  struct Extension {
    enum class Kind : char {
      kRigid,   ///< before the bend at the plane, an arc's leg, or a line for which room is reserved
      kLast,    ///< the last part, up to the line, which may have a jog
      kThread   ///< from a pill to its anchor, in place of an extension line
    };
    Segment2 segment;
    int parameter = -1;
    Kind kind = Kind::kRigid;
  };
  /// What of extension lines has landed since. Neighbours in a chain share one, which landed with the first.
  [[nodiscard]] std::span<const Extension> extensionsSince(const Mark& mark) const { return std::span(extensions_).subspan(mark.extensions); }

  /// What a line, or one of its extension lines from the base line by way of its foot on the plane, runs across of what has landed.
  struct Crossings {
    bool lines = false;        ///< a line or an extension line, with either (paper 4.2, Intersect)
    bool extensions = false;   ///< an extension line with the line, or a line with one of its extension lines, where that has no jog
    bool labels = false;
  };
  [[nodiscard]] Crossings crossings(const Segment2& base, const Segment2& foot, const Segment2& line) const;

  /// The lines that run across another's extension line, of this one and those that have landed, where that has no jog.
  struct Tangle {
    int lines = 0;           ///< how many
    int parameter = -1;      ///< whose line, or extension line, is in it with this one; -1 without one, and for a handle that is no line
  };
  /// `line`: a line, or a chain from its one end to the other. `extensions`: its extension lines in parts, or those of all its members.
  [[nodiscard]] Tangle tangle(const Segment2& line, std::span<const Segment2> extensions) const;
  /// Where the last part of an extension line bends to get past the line that has landed across which it runs (jogs.h). Nothing where there is none, or it cannot get past.
  [[nodiscard]] std::optional<Vec2> jogOf(const Segment2& lastPart) const;
  /// Whether one of these, which are the extension lines of one or more lines in parts, runs across a line that has landed, or through a label.
  [[nodiscard]] Crossings extensionCrossings(std::span<const Segment2> extensions) const;

  /// Whether a line that measures `lengthM` and one that has landed, on another guide, run beside each other on the same side of their base lines, and the longer one, in the world, is nearer to the
  /// model. Lengths that differ by 1 % or less are equal.
  [[nodiscard]] bool nestsWrongly(const Segment2& base, const Segment2& line, double lengthM, int guide) const;

  /// Whether a line comes nearer than `px` to one that has landed.
  [[nodiscard]] bool comesWithin(double px, const Segment2& line) const;

  /// Whether a segment crosses a line that has landed.
  [[nodiscard]] bool crossesLine(const Segment2& segment) const;
  /// Whether it crosses an extension line that has landed.
  [[nodiscard]] bool crossesExtension(const Segment2& segment) const;
  /// Whether it lies on one, so that the two look like one line.
  [[nodiscard]] bool runsAlongExtension(const Segment2& segment) const;
  /// Whether a segment crosses a line that has landed, or lies on one.
  [[nodiscard]] bool runsInto(const Segment2& segment) const;
  /// How many of the lines, the extension lines, the threads of pills and the labels that have landed a segment runs across.
  struct Across {
    int lines = 0;
    int extensions = 0;
    int threads = 0;
    int labels = 0;
  };
  [[nodiscard]] Across across(const Segment2& segment) const;
  /// Whether a segment runs through a label that has landed.
  [[nodiscard]] bool coversLabel(const Segment2& segment) const;
  /// Whether a segment lies on a line that has landed, so that the two are drawn as one.
  [[nodiscard]] bool liesOnLine(const Segment2& segment) const;

  /// Whether a line on a guide keeps handleSpacing from the lines of other guides and kLabelClearancePx from all labels, and crosses no extension line.
  [[nodiscard]] bool hasRoom(const Segment2& line, int guide) const;

  /// Whether a label's box keeps kLabelClearancePx from every extension line.
  [[nodiscard]] bool clearsExtensions(const Box2& label) const;
  /// Whether a label's box keeps kLabelClearancePx from every line, extension line and label that has landed; from lines and labels alone when extension lines may run under it. Lines of the parameter `own` do
  /// not count.
  [[nodiscard]] bool hasRoom(const Box2& label, bool overExtensions = false, int own = kNobody) const;

 private:
  struct Line {
    Segment2 segment;
    int guide = -1;
    Vec2 away{0.0};   ///< px, from the middle of its base line to its own
    int parameter = -1;
    double lengthM = 0;   ///< of its base line
  };
  /// Whether a line runs across a part of an extension line, and that, if it is the last one, has no jog past it. Neither of the two need have landed.
  [[nodiscard]] bool runsAcross(const Segment2& line, const Segment2& part, bool isLast) const;
  /// An extension line across which a line runs; null for none.
  [[nodiscard]] const Extension* findUnder(const Segment2& line) const;
  /// Whether any line that has landed runs across a part of an extension line.
  [[nodiscard]] bool isUnderAny(const Segment2& part, bool isLast) const;

  std::vector<Line> lines_ = withRoomFor<Line>(kReservedLines);
  std::vector<Extension> extensions_ = withRoomFor<Extension>(2 * kReservedLines);
  std::vector<Box2> labels_ = withRoomFor<Box2>(kReservedLines);
};

}  // namespace dimline
