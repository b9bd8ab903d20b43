#include "cli/audit_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cli/audit_geometry.h"
#include "cli/audit_planes.h"
#include "core/constants.h"

namespace dimline {

namespace {

// Offsets tried for the offset against the least: so many a pixel of way.
constexpr double kTriesPerPx = 4.0;
// Way between two places tried for a line that lies inside, and how many places on one plane.
constexpr double kPlaceStepPx = 2.0;
constexpr int kMostPlaces = 3000;
// What a mask's pixels can tell of handleSpacing (see MaskPicture), and slack for rounding between lines.
constexpr double kModelClearancePx = kHandleSpacingPx - 0.5;
constexpr double kLineClearancePx = kHandleSpacingPx - 0.01;
constexpr double kSmallClearancePx = 4.0;
// "Plainly": by so much more than the least that nobody could disagree.
constexpr double kPlainlyLonger = 1.25;
constexpr double kPlainlySeenShare = 0.5;

double leastLengthPx(const Annotation& annotation) { return std::max(kMinLineLengthPx, annotation.minLengthPx); }

bool contains(const Box2& box, const Vec2& p) {
  return p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y;
}
bool contains(const Box2& box, const Segment2& s) { return contains(box, s.start) && contains(box, s.end); }

/// The segment on screen, or nothing when part of it is not before the viewer.
std::optional<Segment2> project(const View& view, const Segment& s) {
  if (!view.inFrontOfNear(s)) return std::nullopt;
  return view.toScreen(s);
}

double angleToViewRad(const View& view, const Segment& s) {
  const Vec3 sight = view.directionTo(s.middle());
  const Vec3 along = s.end - s.start;
  return std::atan2(glm::length(glm::cross(along, sight)), std::abs(glm::dot(along, sight)));
}

Segment moved(const Segment& s, const Vec3& by) { return {s.start + by, s.end + by}; }

/// Everything else that is drawn, as far as it is in a line's or a label's way.
class Obstacles {
public:
  Obstacles(const AuditedFrame& frame, std::size_t except) : mask_(*frame.mask), view_(frame.layout->view) {
    const PlacedLine& self = frame.layout->lines[except];
    for (std::size_t i = 0; i < frame.layout->lines.size(); ++i) {
      const PlacedLine& line = frame.layout->lines[i];
      if (i == except || line.parameter == self.parameter) continue;
      (isOutside(line) ? far_ : near_).push_back(line.lineScreen);
      lines_.push_back(line.lineScreen);
      for (const auto* extension : {&line.extensionStart, &line.extensionEnd}) {
        for (std::size_t k = 1; k < extension->size(); ++k) near_.push_back({(*extension)[k - 1], (*extension)[k]});
      }
      if (line.label) labels_.push_back(*line.label);
    }
    for (const PlacedHandle& handle : frame.layout->others) {
      labels_.push_back(handle.box);
      const DrawnArc arc = drawnArc(handle, view_);
      for (const auto* lines : {&arc.curve, &arc.arms}) near_.insert(near_.end(), lines->begin(), lines->end());
    }
  }

  [[nodiscard]] bool haveRoomFor(const Segment2& line) const {
    if (!contains(view_.viewport().grown(-kViewportMarginPx), line) || !mask_.keepsDistance(line, kHandleSpacingPx))
      return false;
    const auto within = [&](const std::vector<Segment2>& others, double px) {
      return std::ranges::any_of(others, [&](const Segment2& other) { return gapPx(line, other) < px; });
    };
    if (within(far_, kHandleSpacingPx) || within(near_, kSmallClearancePx)) return false;
    return std::ranges::none_of(
        labels_, [&](const Box2& label) { return enters(line, label.grown(kSmallClearancePx + kTouchPx)); });
  }

  /// Whether a line runs across the extension lines of one that would lie there.
  [[nodiscard]] bool crossExtensionsOf(const Segment2& line, const Segment2& base) const {
    const std::array extensions{Segment2{base.start, line.start}, Segment2{base.end, line.end}};
    return std::ranges::any_of(lines_, [&](const Segment2& other) {
      return crossEachOther(other, extensions[0]) || crossEachOther(other, extensions[1]);
    });
  }

  /// Whether a text of that size has room on a line, beside it, or beyond its ends.
  [[nodiscard]] bool haveRoomForLabelOf(const Segment2& line, const Vec2& size) const {
    const Vec2 along = (line.end - line.start) / line.length();
    const Vec2 across(-along.y, along.x);
    const double reachAlong = 0.5 * (size.x * std::abs(along.x) + size.y * std::abs(along.y));
    const double reachAcross = 0.5 * (size.x * std::abs(across.x) + size.y * std::abs(across.y));
    const double free = 0.5 * line.length() - reachAlong - kArrowLengthPx - 2 * kLabelPaddingPx;
    std::vector<Vec2> centers;
    for (const double share : {0.0, -1.0, 1.0}) {
      if (free >= 0) centers.push_back(line.middle() + along * (share * free));
    }
    for (const double side : {-1.0, 1.0}) {
      centers.push_back(line.middle() + across * (side * (reachAcross + 2 * kLabelPaddingPx)));
      centers.push_back(line.middle() + along * (side * (0.5 * line.length() + reachAlong + 2 * kLabelPaddingPx)));
    }
    return std::ranges::any_of(centers, [&](const Vec2& center) {
      return haveRoomFor(Box2{center - size * 0.5, center + size * 0.5});
    });
  }

private:
  [[nodiscard]] bool haveRoomFor(const Box2& label) const {
    const Box2 allowed = view_.viewport().grown(-kViewportMarginPx);
    if (!contains(allowed, label.min) || !contains(allowed, label.max)) return false;
    const Box2 grown = label.grown(kSmallClearancePx + kTouchPx);
    if (mask_.touches(grown)) return false;
    const auto entered = [&](const std::vector<Segment2>& lines) {
      return std::ranges::any_of(lines, [&](const Segment2& line) { return enters(line, grown); });
    };
    return !entered(far_) && !entered(near_) &&
           std::ranges::none_of(labels_, [&](const Box2& other) { return overlap(grown, other); });
  }

  const MaskPicture& mask_;
  const View& view_;
  std::vector<Segment2> lines_;  ///< outside and inside
  std::vector<Segment2> far_;    ///< outside lines, from which another keeps handleSpacing
  std::vector<Segment2> near_;   ///< extension lines, lines inside, and arcs
  std::vector<Box2> labels_;     ///< and handles that are no lines
};

Vec2 labelSize(const PlacedLine& line) {
  if (line.label) return line.label->max - line.label->min;
  return {0.6 * kLabelFontSizePx * static_cast<double>(line.text.size()), 1.4 * kLabelFontSizePx};
}

bool showable(const View& view, const Annotation& annotation, const Segment& base) {
  const auto screen = project(view, base);
  return screen && screen->length() > kPlainlyLonger * leastLengthPx(annotation) &&
         angleToViewRad(view, base) > kForeshortenedAngleRad + kPlainlyMoreRad;
}

/// Whether perspective draws a line much smaller than the base line that it stands for, which makes it no place.
bool farBehind(const View& view, const Segment& line, const Segment& base) {
  return !view.camera().orthoHeightM && view.depth(line.middle()) > kMostDepthRatio * view.depth(base.middle());
}

/// Whether a line lies so far across the picture from its base line that nobody sees what it measures, which makes it
/// no place.
bool outOfReach(const View& view, const Segment2& line, const Segment2& base) {
  const double reachPx = std::max(kMostReachShare * std::hypot(view.widthPx(), view.heightPx()), kLeastReachPx);
  return std::ranges::any_of(std::array{line.start - base.start, line.end - base.end},
                             [&](const Vec2& way) { return std::max(std::abs(way.x), std::abs(way.y)) > reachPx; });
}

/// A length that every base line of a type that turns with the view has on screen: half the least size of the box.
double radiusOnScreenPx(const View& view, const Obb& box) {
  return 0.5 * std::min({box.size.x, box.size.y, box.size.z}) / view.metresPerPixelAt(box.center());
}

/// The first place on one way from a base line.
std::optional<OutsidePlace> placeOnTheWay(const AuditedFrame& frame, const Obstacles& obstacles,
                                          const Annotation& annotation, const Segment& base, const SlipWay& way,
                                          const Vec2& textSize, PlacesWanted wanted) {
  const View& view = frame.layout->view;
  const double modelSizeM = frame.scene->bounds.diagonal();
  const auto baseScreen = project(view, base);
  if (!baseScreen) return std::nullopt;
  double offsetM = 0;
  for (int i = 0; i < kMostPlaces; ++i) {
    const Segment line = moved(way.from, way.direction * offsetM);
    const auto screen = project(view, line);
    if (!screen || farBehind(view, line, base) || outOfReach(view, *screen, *baseScreen)) {
      return std::nullopt;
    }
    if (staysWithin(way, line, modelSizeM) && screen->length() > leastLengthPx(annotation) &&
        obstacles.haveRoomFor(*screen) && obstacles.haveRoomForLabelOf(*screen, textSize) &&
        frame.mask->outside(screen->middle()) &&
        (wanted == PlacesWanted::kAll || !obstacles.crossExtensionsOf(*screen, *baseScreen))) {
      return OutsidePlace{*screen, frame.mask->seesAnEdge(*screen)};
    }
    offsetM += kPlaceStepPx * view.metresPerPixelAt(line.middle());
    // Once the line is out of the picture as a whole, and was on its way out, there is nothing more to find.
    if (!contains(view.viewport().grown(view.widthPx() + view.heightPx()), screen->middle())) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> offsetRatio(const AuditedFrame& frame, std::size_t number) {
  const Layout& layout = *frame.layout;
  const PlacedLine& line = layout.lines[number];
  if (line.placement != PlacementKind::kOutside || line.chain >= 0) return std::nullopt;
  if (line.planeKind == PlaneKind::kObject || line.planeKind == PlaneKind::kNone) return std::nullopt;
  std::vector<Segment2> earlier;
  for (std::size_t i = 0; i < number; ++i) {
    if (isOutside(layout.lines[i])) earlier.push_back(layout.lines[i].lineScreen);
  }
  const Vec3 offset = line.line.start - line.base.start;
  const double wayPx = std::max(glm::length(line.lineScreen.start - line.baseScreen.start),
                                glm::length(line.lineScreen.end - line.baseScreen.end));
  const int tries = std::max(1, static_cast<int>(std::ceil(wayPx * kTriesPerPx)));
  const auto clear = [&](const Segment2& s) {
    return frame.mask->keepsDistance(s, kModelClearancePx) &&
           std::ranges::none_of(earlier, [&](const Segment2& other) { return gapPx(s, other) < kLineClearancePx; }) &&
           frame.mask->outside(s.middle());
  };
  for (int i = 0; i < tries; ++i) {
    const auto screen = project(layout.view, moved(line.base, offset * (static_cast<double>(i) / tries)));
    // A least offset of under a pixel counts as one, so that a line that moves for nothing does show.
    if (screen && clear(*screen))
      return tries / std::max(static_cast<double>(i), std::min(kTriesPerPx, static_cast<double>(tries)));
  }
  return 1.0;
}

std::optional<OutsidePlace> outsidePlace(const AuditedFrame& frame, std::size_t number, PlacesWanted wanted) {
  const Layout& layout = *frame.layout;
  const PlacedLine& line = layout.lines[number];
  const Annotation& annotation = *frame.model->annotations[line.parameter];
  const Obstacles obstacles(frame, number);
  const Vec2 textSize = labelSize(line);
  const std::vector<ObjectFace> object =
      annotation.slip == Slip::kObject ? objectFaces(*frame.model, *frame.scene) : std::vector<ObjectFace>{};
  for (const std::size_t scope : layout.visibleScopes) {
    if (frame.scene->scopes[scope].name != annotation.scope) continue;
    const Obb& box = frame.scene->scopes[scope].box;
    for (const Segment& base :
         isLinear(annotation.type) ? linearBaseLines(annotation, box) : std::vector<Segment>{line.base}) {
      if (!showable(layout.view, annotation, base) ||
          !contains(layout.view.viewport(), layout.view.toScreen(base.middle())))
        continue;
      for (const SlipWay& way : slipWays(annotation, box, base, layout.view, object, frame.scene->bounds.diagonal())) {
        const auto place = placeOnTheWay(frame, obstacles, annotation, base, way, textSize, wanted);
        if (place) return place;
      }
    }
  }
  return std::nullopt;
}

namespace {

/// The base lines of a parameter that a line inside could lie on, on screen.
std::vector<Segment2> baseLinesInView(const AuditedFrame& frame, std::size_t parameter) {
  const View& view = frame.layout->view;
  const Annotation& annotation = *frame.model->annotations[parameter];
  std::vector<Segment2> found;
  for (const std::size_t scope : frame.layout->visibleScopes) {
    if (frame.scene->scopes[scope].name != annotation.scope) continue;
    for (const Segment& base : linearBaseLines(annotation, frame.scene->scopes[scope].box)) {
      const auto screen = project(view, base);
      if (screen && showable(view, annotation, base) && enters(*screen, view.viewport())) found.push_back(*screen);
    }
  }
  return found;
}

}  // namespace

bool mustCross(const AuditedFrame& frame, std::size_t one, std::size_t other) {
  const auto first = baseLinesInView(frame, frame.layout->lines[one].parameter);
  const auto second = baseLinesInView(frame, frame.layout->lines[other].parameter);
  if (first.empty() || second.empty()) return false;
  return std::ranges::all_of(first, [&](const Segment2& a) {
    return std::ranges::all_of(second, [&](const Segment2& b) { return crossEachOther(a, b) || lieOnEachOther(a, b); });
  });
}

namespace {

bool inPicture(const View& view, const Vec3& p) {
  return view.inFrontOfNear(p) && contains(view.viewport(), view.toScreen(p));
}

/// Whether a scope has a base line about which nobody could say that it is too short, foreshortened or hidden. Of the
/// handles that are no lines, an arc must not be seen edge-on.
bool hasPlainBaseLine(const AuditedFrame& frame, const Annotation& annotation, const Obb& box) {
  const View& view = frame.layout->view;
  if (annotation.type == HandleType::kAngular) {
    const int axis = std::max(0, axisOf(annotation.orient).axis);
    const double facing = glm::dot(box.axes[static_cast<std::size_t>(axis)], view.directionTo(box.center()));
    return std::abs(facing) > std::sin(kArcForeshortenedAngleRad + kPlainlyMoreRad);
  }
  if (!isLine(annotation.type)) return true;
  if (!isLinear(annotation.type)) return radiusOnScreenPx(view, box) > kPlainlyLonger * leastLengthPx(annotation);
  const double skinM = kScopeSkinShare * frame.scene->bounds.diagonal();
  return std::ranges::any_of(linearBaseLines(annotation, box), [&](const Segment& base) {
    return showable(view, annotation, base) && inPicture(view, base.start) && inPicture(view, base.end) &&
           frame.depth->seenShare(base, skinM) >= kPlainlySeenShare;
  });
}

}  // namespace

std::optional<std::size_t> scopeInPlainView(const AuditedFrame& frame, std::size_t parameter) {
  const View& view = frame.layout->view;
  const Annotation& annotation = *frame.model->annotations[parameter];
  const double skinM = kScopeSkinShare * frame.scene->bounds.diagonal();
  for (std::size_t i = 0; i < frame.scene->scopes.size(); ++i) {
    if (frame.scene->scopes[i].name != annotation.scope) continue;
    const Obb& box = frame.scene->scopes[i].box;
    bool whole = true;
    for (int k = 0; k < 8; ++k) whole = whole && inPicture(view, box.corner(k));
    if (!whole) continue;
    if (!hasPlainBaseLine(frame, annotation, box)) continue;
    const DepthPicture::Seen seen = frame.depth->test(box, skinM);
    if (seen.pixels > 0 && seen.seen >= kPlainlySeenShare * seen.pixels) return i;
  }
  return std::nullopt;
}

}  // namespace dimline
