#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "placement/chooser.h"
#include "placement/foresight.h"
#include "placement/label_memory.h"
#include "placement/label_tidying.h"
#include "placement/mending.h"
#include "placement/placer.h"
#include "placement/placing_order.h"
#include "placement/visibility.h"

// What a Placer is made of; private to the placer's own files. placer.cpp keeps what is known from frame to frame and says how often a frame is placed, placer_attempt.cpp places it
// once: algorithm 1 of the paper, one parameter after the other. placer_rest.cpp lays out as a whole what has settled.

namespace dimline {

/// What is to be placed in a frame.
struct FrameToPlace {
  const View& view;
  const DistanceFields& fields;
  const Values& values;
  std::span<const PlacedLine> held;
  bool viewMoved = false;   ///< since the last frame, or lines may move as if it had
};

[[nodiscard]] inline bool isHidden(std::span<const HiddenParameter> hidden, std::size_t parameter) {
  return std::ranges::find(hidden, parameter, &HiddenParameter::parameter) != hidden.end();
}

/// What is left to be done once nothing moves any more.
enum class Rest : unsigned char {
  kMoved,    ///< lines are to look for better places
  kEdited,   ///< they are where someone wants them, but labels are to be laid out as a whole again
  kSettled,  ///< nothing
};

struct Placer::State {
  std::vector<Parameter> parameters;
  std::vector<Scope> scopes;
  Bounds bounds;                      ///< of the model (m)
  double toleranceM = 0;              ///< kSamePlaneDistance of its size
  std::vector<Measured> order;        ///< those with dimension lines, shortest first: by their ranks
  std::vector<Measured> others;       ///< those with other handles, in the order of their definition
  std::size_t editable = 0;           ///< how many of both can be edited; the other ones are measures
  std::size_t mostLines = 0;          ///< more are not in a frame: one a scope of each parameter
  std::vector<ObjectPlane> objectPlanes;

  /// Where handles and labels were in the frames before.
  struct Choices {
    std::vector<History> histories;   ///< one a parameter
    LookAhead lookAhead;
    LabelMemory labels;

    void forget();
    /// There are `count` parameters from now on, of which the first `common` are the same ones as before.
    void setParameters(std::size_t common, std::size_t count);
  };

  /// What is remembered of the frames before.
  struct Past : Choices {
    std::vector<Sight> sights;        ///< one a scope
    PlacingOrder placingOrder;
    std::vector<std::size_t> othersOrder;   ///< numbers of those that are placed beside the lines
    Mending mending;
    bool tangled = false;             ///< a line ran across another's extension line in the last frame
    int calmFrames = 0;               ///< moved frames on end before this one in which none did; counts to kCalmFrames
    std::optional<View> view;         ///< of the last frame
    bool sceneChanged = false;        ///< since the last frame
    Rest rest = Rest::kSettled;
    bool settles = false;             ///< with the next frame
    bool anew = false;                ///< see Placer::anew()
  };
  Past past;

  /// Lines settle in several frames, one step in each, of which the last alone is shown.
  struct Settling {
    int step = 0;                     ///< so many are done
    Past before;                      ///< what was remembered when the first began, and
    Foresight foresightBefore;        ///< what was ahead
    Past fromThere;                   ///< what came of the first step, and how good it is
    Outcome outcome;
    Layout layout;                    ///< what came of the last step
  };
  Settling settling;
  bool showHidden = false;
  Choices onDemand;                   ///< what showHidden adds has a memory of its own, or it would change what is shown without it
  bool showAll = false;               ///< that is what is being placed
  Outcome outcome;
  bool firm = false;                  ///< see ChoiceContext
  FrameKind kind;                     ///< of the frame that is placed
  bool asksForRoom = false;           ///< see ChoiceContext
  /// One a rank while a frame is mended; none of a line that does not look for another place.
  std::vector<AvoidedPlace> avoided;

  /// What stands in an attempt when the turn of a line comes, so that another attempt in which all goes the same way until then can go on from there.
  struct Turn {
    Occupied::Contents occupied;
    Outcome outcome;
    std::size_t lines = 0;            ///< of the layout
    std::size_t hidden = 0;
    LookAhead::Noted noted;
  };
  std::vector<Turn> turns;            ///< of this attempt, when they are kept: the first, and each further one after turnsBetween() more
  bool keepsTurns = false;
  bool attemptsAreWhole = false;

  // The best attempt at this frame so far, while another is made; and what all of them begin with.
  std::vector<Turn> bestTurns;
  std::vector<AvoidedPlace> bestAvoided;
  Past bestPast;
  Outcome bestOutcome;
  Layout bestLayout;
  Occupied bestOccupied;              ///< without the model
  Past beforeAttempts;                ///< or what tidying begins with

  // Memory of one frame, kept so that the next allocates nothing.
  Occupied occupied;
  Chooser chooser;
  Foresight foresight;
  Landed landedElsewhere;             ///< the lines as one look ahead sees them, or with other labels
  std::vector<ObjectPlaneUse> objectPlaneUses;
  std::vector<char> inView;           ///< one a scope
  std::vector<char> seen;             ///< one a scope: in view, and not hidden by the model
  std::vector<char> seenEnough;       ///< those of them that what is hidden may be shown for
  std::vector<std::size_t> scopesInSight;
  std::vector<HiddenParameter> wanting;   ///< what has no handle yet when those on demand are placed
  LabelTidying labelTidying;
  std::vector<std::size_t> bestOthersOrder;
  Occupied::Contents besideLines;     ///< what has landed before the others, and what was remembered
  std::vector<History> historiesBesideLines;
  std::vector<PlacedLine> spareLines;
  std::vector<PlacedHandle> spareHandles;

  [[nodiscard]] std::array<Choices*, 2> allChoices() { return {&past, &onDemand}; }

  /// See ChoiceContext. What an edit brings is shown at once, and so is what a picture has room for that will be looked at for long.
  [[nodiscard]] bool patient() const { return firm && !kind.rests() && !showAll; }

  // placer.cpp
  void keepChains(std::span<const Measured> before, const Measured& now);
  void placeInRounds(const FrameToPlace& frame, bool sceneChanged, Layout& layout);
  bool settleOn(const FrameToPlace& frame, Layout& layout);
  void placeSettling(const FrameToPlace& frame);
  void placeRound(const FrameToPlace& frame, bool isLast, Layout& layout);
  void breakOffSettling();
  void forgetOffsets();
  void forgetOthersOrder();
  bool beginFrame(const View& view);
  void findVisible(const View& view, const ScopeVisibility* visibility, int framesOn);
  void placeOnce(const FrameToPlace& frame, bool sceneChanged, bool shown, Layout& layout);
  void placeMended(const FrameToPlace& frame, bool sceneChanged, bool shown, Layout& layout);
  void mend(const FrameToPlace& frame, Layout& layout);
  [[nodiscard]] double tanglesAhead(std::span<const PlacedLine> lines);
  void beginAttempt(const Attempt& attempt, Layout& layout);
  [[nodiscard]] std::size_t turnsInCommon() const;
  [[nodiscard]] AvoidedPlace bestPlaceOf(std::size_t rank, bool withSide) const;
  [[nodiscard]] bool looksInVain() const;
  void swapWithBest(Layout& layout);
  void placeOnDemand(const FrameToPlace& frame, bool sceneChanged, Layout& layout);
  void jogExtensions(std::span<PlacedLine> lines) const;

  // placer_attempt.cpp
  void placeAllLines(const FrameToPlace& frame, Layout& layout);
  void emptyLayout(Layout& layout);
  [[nodiscard]] std::size_t turnsBetween() const { return order.size() / kMostKeptTurns + 1; }
  void makeRoomForTurns();
  void keepTurn(std::size_t turn, const Layout& layout);
  void goOnFromBest(std::size_t turn, Layout& layout);
  void placeFrom(std::size_t firstTurn, const FrameToPlace& frame, Layout& layout);
  [[nodiscard]] static bool hasOnePlace(const Measured& other);
  [[nodiscard]] bool hasRoomForLines(const View& view) const;
  [[nodiscard]] bool hasRoomForPills(const View& view) const;
  void placeBesideLines(const FrameToPlace& frame, Layout& layout);
  void placeAllHidden(const FrameToPlace& frame, Layout& layout);
  void labelInside(const FrameToPlace& frame, std::span<PlacedLine> lines);
  [[nodiscard]] ChoiceContext contextOf(const FrameToPlace& frame, const ObjectPlanesInFrame& object, const Measured& measured, const AvoidedPlace* avoid);
  [[nodiscard]] std::span<const char> usableScopes(const Measured& measured) const;
  [[nodiscard]] BaseLineTally scopesOutOfSight(const Measured& measured) const;
  void placeLines(std::size_t rank, const ChoiceContext& context, double value, Layout& layout);
  void noteChoice(const Measured& measured);
  void judgeChoice(std::size_t rank, const History& history);
  void judgeHidden(const History& history);
  void landChoice(const Measured& measured, double value, Layout& layout);
  void hold(const PlacedLine& held);
  void landHeld(Measured& measured, const PlacedLine& held, Layout& layout);
  int guideThrough(const PlacedLine& line);
  void placeOther(const Measured& measured, const FrameToPlace& frame, Layout& layout);

  // placer_rest.cpp
  void tidy(const FrameToPlace& frame, Layout& layout);
  void tidyLabels(const FrameToPlace& frame, std::span<PlacedLine> lines);
  [[nodiscard]] double worthOfPills(std::span<const PlacedHandle> placed) const;
  void placeInBestOrder(const FrameToPlace& frame, Layout& layout);
};

}  // namespace dimline
