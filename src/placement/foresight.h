#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "core/constants.h"
#include "placement/object_planes.h"
#include "placement/slip_planes.h"

namespace dimline {

/// Which places the movement of the camera is about to take away. A plane that is turning edge-on is left out soon (paper 4.4), and so is the part of an object plane that a
/// neighbour is about to cut off; what the camera comes nearer to leaves the viewport, or its label does; what it goes away from grows too small to be measured; and a feature that turns away is soon hidden. A line that goes there has to
/// move again at once.
/// So whoever needs a new place asks what the movement will do to it when it goes on for a while as it does now. Beyond the paper, which judges each frame by itself.
class Foresight {
 public:
  /// A place outside the model.
  struct Place {
    const BaseLine& base;
    Slip slip;
    const SlipPlane& plane;
    int direction;          ///< +1 or -1
    double offsetM;
    const Segment& line;    ///< the final line
    double leastPx = 0;     ///< px, length of the shortest line that is shown; 0 for a chain, which is longer than its members
    Vec2 textSize{0.0};     ///< px, of its label; zero for a chain, whose members need not have one each
  };

  /// A frame begins. `before`: the view of the last frame, if there is one that this one follows from; when it is the same one, before a still camera, the movement is
  /// thought to go on as it did. A movement that neither turns nor changes sizes, as a shift of the picture does, is not thought to go on. `bounds`: of the model, in metres.
  void begin(const std::optional<View>& before, const View& now, const Bounds& bounds, std::span<const ObjectPlane> objectPlanes, double toleranceM);
  /// What the movement will do to a place.
  struct Prospect {
    double price = 0;          ///< px, to be added to the place's score
    bool brief = false;        ///< outside the model: it has no room any more, or its feature has turned away, before the view has turned by kForesightRad or zoomed by kBriefZoom
    bool passing = false;      ///< while the view turns: lost at the first look ahead
    bool goneSoon = false;     ///< while the camera comes nearer or goes away: what it measures is out of the picture, or too short to be shown, so soon that it is not worth being shown anew (kLooksAtLastMomentsAnew)
    bool outInVain = false;    ///< no place for a line inside the model to come out to, since it would soon be back: a brief one while the view turns; else one without room so soon that kLooksAtLastMomentsComingOut tell it
    bool lastMoments = false;  ///< while the camera comes nearer or goes away: there is room for it so briefly that it is not worth being begun (kLooksAtLastMoments)
  };
  /// At how many views ahead a place is looked at, and these, the nearest first.
  [[nodiscard]] std::size_t lookCount() const { return lookCount_; }
  [[nodiscard]] const View& viewAhead(std::size_t look) const { return looks_[look].view; }
  /// 1 for what is at the first look, in equal steps less for later ones, 0 for what is beyond the last.
  [[nodiscard]] double shareLeft(std::size_t look) const { return lookCount_ > 0 ? static_cast<double>(lookCount_ - look) / static_cast<double>(lookCount_) : 0.0; }
  /// Whether the camera comes nearer or goes away.
  [[nodiscard]] bool zooms() const { return lookCount_ > 0 && zooms_; }
  /// Whether the camera comes nearer.
  [[nodiscard]] bool nears() const { return zooms() && nears_; }
  /// Of a place outside the model. Its price is 0 when nothing happens to it; kScoreSoonGone when it is lost at the first look ahead, in equal steps less when
  /// later. A feature that turns away from the viewer costs kTurnedAwayShare of that, and so does one that is turned
  /// away when no movement is thought to go on. More of all when the camera comes nearer or goes away.
  [[nodiscard]] Prospect prospect(const Place& place);
  /// Of a base line inside the model, which is lost when nothing of it is left in the viewport or it is shorter there than `leastPx`.
  [[nodiscard]] Prospect prospectInside(const Segment& base, double leastPx) const;

 private:
  /// A view of the movement gone on with.
  struct Look {
    View view;
    std::vector<ObjectPlaneUse> objectUses;
  };
  [[nodiscard]] bool hasRoom(const Look& look, const Place& place);
  template <typename Lost>
  [[nodiscard]] std::size_t firstLook(Lost lost) const;
  [[nodiscard]] std::size_t firstLookWithout(const Segment& base, double leastPx) const;
  /// Whether what is lost at that look, or at none, is lost at one of the first `count` looks of a zoom. A quick one has fewer in all.
  [[nodiscard]] bool isLostAtOneOf(std::size_t count, std::size_t look) const { return zooms() && look < std::min(count, lookCount_); }

  std::vector<Look> looks_;         ///< the nearest first; memory for more than there are
  std::size_t lookCount_ = 0;       ///< none when no movement is thought to go on
  std::size_t briefCount_ = 0;      ///< how many of them come before what lasts is not brief
  double lossPrice_ = 0;            ///< px, of what is lost at the first look
  bool zooms_ = false;              ///< the movement comes nearer or goes away
  bool nears_ = false;              ///< it comes nearer
  View now_;                        ///< what the looks follow
  std::span<const ObjectPlane> objectPlanes_;
  double toleranceM_ = 0;
  std::vector<SlipPlane> planes_;   ///< memory for one base line's
};

}  // namespace dimline
