#pragma once

#include <span>
#include <vector>

#include "core/reserved.h"
#include "placement/landed.h"
#include "placement/measured.h"

namespace dimline {

/// Where the lines that are still to be placed in a frame would lie, had each kept the place that it had in the frame before. The greedy order of the paper (4.5) lets a
/// short line take the place of a longer one, which then moves, and pushes others on; a line that looks ahead leaves the later ones where they are when it can.
class LookAhead {
 public:
  /// A frame begins. `changed`: the view or the scene is another than in the last frame; before a still camera the same lines are looked at again, so that
  /// nothing moves with time alone. `shown`: somebody saw that frame, and would see lines give way to labels; nobody sees the first rounds of a first picture. To be followed by project().
  void begin(bool changed, bool shown = true);
  /// `lines` by their ranks, which are placed in this order. All of them are ahead.
  void project(std::span<const Measured> lines, std::span<const std::uint32_t> order, const View& view, const DistanceFields& model);
  /// It is the turn of the line of that rank: those up to its own in the order are no longer ahead.
  void reach(std::size_t rank);
  [[nodiscard]] Landed::Crossings crossings(const Segment2& base, const Segment2& foot, const Segment2& line) const {
    return outside_.ahead.crossings(base, foot, line);
  }
  /// Whether a line comes nearer than handleSpacing to one ahead.
  [[nodiscard]] bool crowds(const Segment2& line) const;
  /// Whether a line ahead stood free towards a viewport edge and no longer would: the line, or one of its extension lines, comes between it and each edge
  /// from which it was seen.
  [[nodiscard]] bool shadows(const Segment2& foot, const Segment2& line) const;
  /// A line of this frame has landed: in the world its base line, that line's foot on the plane, and the final line.
  void note(std::size_t parameter, const Segment& base, const Segment& foot, const Segment& line) { outside_.present.push_back({parameter, base, foot, line}); }
  /// Whether a base line inside the model crosses, or lies on, one ahead that was shown inside in the last frame.
  [[nodiscard]] bool runsIntoInside(const Segment2& base) const { return inside_.ahead.runsInto(base); }
  /// A base line of this frame is shown inside the model.
  void noteInside(std::size_t parameter, const Segment& base) { inside_.present.push_back({parameter, base, base, base}); }
  /// Whether a label's box keeps kLabelClearancePx from the extension lines ahead and from the lines inside the model, and no line ahead has to give way to it; where nobody sees it, one may, but not far.
  [[nodiscard]] bool leavesRoom(const Box2& label) const {
    return (shown_ ? outside_.ahead.hasRoom(label) : outside_.ahead.clearsExtensions(label)) && inside_.ahead.hasRoom(label) && !shadows(label);
  }
  /// How much of this frame has been noted.
  struct Noted {
    std::size_t outside = 0, inside = 0;
  };
  [[nodiscard]] Noted noted() const { return {outside_.present.size(), inside_.present.size()}; }
  /// Notes what another one had noted of the same frame by then.
  void noteAgain(const LookAhead& other, const Noted& noted);
  void forget();

 private:
  [[nodiscard]] bool shadows(const Box2& label) const;
  template <typename ComesBetween>
  [[nodiscard]] bool shadowsAny(ComesBetween comesBetween) const;

  struct Line {
    std::size_t parameter = 0;
    Segment base, foot, line;
  };
  /// Lines outside the model, or lines inside it.
  struct Lines {
    std::vector<Line> past = withRoomFor<Line>(Landed::kReservedLines);      ///< of the last frame that differed from this one
    std::vector<Line> present = withRoomFor<Line>(Landed::kReservedLines);   ///< of this frame so far
    Landed ahead;
    std::vector<Landed::Mark> marks;   ///< one a rank: how much of `ahead` is of later ranks

    void begin(bool changed);
    void forgetAhead(std::size_t ranks);
  };
  Lines outside_;
  Lines inside_;
  struct Free {
    Segment2 line;
    unsigned edges = 0;   ///< bit set of the viewport edges from which it is seen past the model
  };
  bool shown_ = true;
  std::vector<Free> free_;            ///< the lines of `outside_.ahead`, in its order
};

}  // namespace dimline
