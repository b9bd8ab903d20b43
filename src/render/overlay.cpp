#include "render/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/constants.h"

namespace dimline {

namespace {

/// Stroke widths (px). A dimension line is to be seen at once, an extension line only when it is looked for.
constexpr double kLineWidthPx = 1.25;
constexpr double kLineWidthHoveredPx = 1.75;
constexpr double kExtensionWidthPx = 1.0;
/// How far the halo reaches beyond the ink (px), and over how much of that it fades.
constexpr double kHaloReachPx = 2.5;
constexpr double kHaloSoftnessPx = 2.0;
/// The same round extension lines, which are many and often lie over the model: less of it, or they would show as white bars.
constexpr double kExtensionHaloReachPx = 1.5;
constexpr float kExtensionHaloOpacity = 0.5F;
/// What is left of a line that the model hides, which would otherwise seem to measure what it is drawn over.
constexpr float kLineHiddenShare = 0.35F;
/// Of an extension line: it is seen to go on, and no more.
constexpr float kExtensionHiddenShare = 0.3F;
/// Dash and gap of an indirect line (px).
constexpr double kDashPx = 4.0;
/// A line's arrowheads never take more than this share of it, so that something of the line is left between them.
constexpr double kArrowsShare = 0.75;
/// The stroke ends that share of an arrowhead, or of a ball's radius, behind its tip: where it is wide enough to hide the stroke's corners.
constexpr double kStrokeInset = 0.7;
/// A ball's highlight: its radius and how far it is off the middle, in radii, and how bright it is.
constexpr double kHighlightRadius = 0.55;
constexpr double kHighlightOffset = 0.28;
constexpr float kHighlightOpacity = 0.45F;
/// px. Radius of the dot with which a thread begins.
constexpr double kAnchorRadiusPx = 2.5;
/// A drag's marks are quieter than the line they stand beside: widths (px) and opacities.
constexpr double kTickWidthPx = 1.0;
constexpr float kTickOpacity = 0.6F;
constexpr double kLimitWidthPx = 1.5;
constexpr float kLimitOpacity = 0.55F;
constexpr double kLimitReachedWidthPx = 2.5;
constexpr float kGhostOpacity = 0.35F;
/// Edges of a scope that a parameter drives, where they are seen and where the model hides them.
constexpr double kEdgeWidthPx = 1.25;
constexpr float kEdgeOpacity = 0.75F;
constexpr float kEdgeHiddenShare = 0.27F;
/// A colour of the author's under the pointer is so much darker.
constexpr float kLitShade = 0.8F;

/// What a line or an arc ends with; a ball's length is its radius.
struct Arrow {
  double lengthPx = 0;
  double halfWidthPx = 0;
};

/// What is shared by the pieces of one line.
struct Pieces {
  std::array<Segment2, 2> strokes;   ///< the line left and right of its label, each from its outer end
  std::size_t strokeCount = 0;
  std::array<Segment2, 2> extensions;
  Arrow startArrow, endArrow;
  Vec2 along{1, 0};
  double lengthPx = 0;
};

/// How a line fares where the model hides it.
struct Hiding {
  EndDepths depths{0.0F};
  float share = 1.0F;   ///< see OverlayShape::hiddenShare
};

/// Where something is hidden it has no halo.
Hiding haloOf(const Hiding& hiding) { return {hiding.depths, hiding.share < 1.0F ? 0.0F : 1.0F}; }

std::uint32_t pack(const glm::vec4& color, float opacity) {
  const auto byte = [](float v) { return static_cast<std::uint32_t>(std::lround(std::clamp(v, 0.0F, 1.0F) * 255.0F)); };
  return byte(color.r) | (byte(color.g) << 8U) | (byte(color.b) << 16U) | (byte(color.a * opacity) << 24U);
}

Arrow arrowOf(bool sphere, bool draggable, double lengthPx, float handleScale) {
  const double atRest = sphere ? kSphereRadiusPx : kArrowLengthPx;
  const double wanted = atRest * (draggable ? static_cast<double>(handleScale) : 1.0);
  const double length = std::min(wanted, lengthPx * kArrowsShare * 0.5);
  // On a short line it gets broader for its length: in its own proportions its colour, which says that it can be dragged, would hardly be seen.
  const double proportion = length < kArrowLengthPx ? std::sqrt(length / kArrowLengthPx) : length / kArrowLengthPx;
  return {length, sphere ? length : kArrowHalfWidthPx * proportion};
}

Pieces piecesOf(const OverlayLine& line) {
  Pieces pieces;
  pieces.lengthPx = line.line.length();
  pieces.along = (line.line.end - line.line.start) / pieces.lengthPx;
  pieces.startArrow = arrowOf(line.sphereEnds, line.startDraggable, pieces.lengthPx, line.handleScale);
  pieces.endArrow = arrowOf(line.sphereEnds, line.endDraggable, pieces.lengthPx, line.handleScale);
  // The stroke ends inside the arrowheads, so that their tips stay sharp.
  const Segment2 stroke{line.line.start + pieces.along * (pieces.startArrow.lengthPx * kStrokeInset),
                        line.line.end - pieces.along * (pieces.endArrow.lengthPx * kStrokeInset)};
  pieces.strokes[0] = stroke;
  pieces.strokeCount = 1;
  if (!line.label) return pieces;
  const auto covered = stretchWithin(stroke, line.label->grown(kLabelPaddingPx));
  if (!covered || covered->enter == covered->leave) return pieces;
  pieces.strokeCount = 0;
  if (covered->enter > 0.0) pieces.strokes[pieces.strokeCount++] = {stroke.start, stroke.at(covered->enter)};
  if (covered->leave < 1.0) pieces.strokes[pieces.strokeCount++] = {stroke.end, stroke.at(covered->leave)};
  return pieces;
}

/// Window depths at the points of an extension line: where it begins, where it bends at the plane or has a jog, and where it ends.
using PointDepths = std::array<float, 4>;

/// Of the extension line at one end of the line, 0 or 1, as told for ExtensionDepths; along what is straight on screen depth grows evenly.
PointDepths pointDepths(std::span<const Vec2> polyline, const ExtensionDepths& known, glm::length_t end) {
  const float line = known.line[end];
  PointDepths depths{known.base[end], line, line, line};
  const std::size_t jog = known.foot && polyline.size() > 2 ? 2 : 1;
  if (jog == 2) depths[1] = (*known.foot)[end];
  if (polyline.size() != jog + 2) return depths;
  const double before = glm::length(polyline[jog] - polyline[jog - 1]), after = glm::length(polyline[jog + 1] - polyline[jog]);
  depths[jog] = glm::mix(depths[jog - 1], line, static_cast<float>(before / (before + after)));
  return depths;
}

/// Runs emit(segment, depths of its ends) over an extension line: it stands off the base line's end and runs on past the final line.
template <typename Emit>
void eachExtensionPiece(std::span<const Vec2> polyline, const PointDepths& depths, Emit emit) {
  double length = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i) length += glm::length(polyline[i] - polyline[i - 1]);
  if (!(length > kExtensionGapPx) || !std::isfinite(length)) return;
  double skip = kExtensionGapPx;
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    Segment2 piece{polyline[i - 1], polyline[i]};
    const double pieceLength = piece.length();
    if (!(pieceLength > skip)) {
      skip -= pieceLength;
      continue;
    }
    const Vec2 direction = (piece.end - piece.start) / pieceLength;
    piece.start += direction * skip;
    const EndDepths ends(glm::mix(depths[i - 1], depths[i], static_cast<float>(skip / pieceLength)), depths[i]);
    skip = 0;
    if (i + 1 == polyline.size()) piece.end += direction * kExtensionOvershootPx;
    emit(piece, ends);
  }
}

/// Which way a curve runs at a point of its polyline: half way between the pieces before and after it.
Vec2 tangentAt(std::span<const Vec2> points, std::size_t i, const Vec2& otherwise) {
  if (i == 0 || i + 1 == points.size()) return otherwise;
  const Vec2 before = points[i] - points[i - 1];
  const Vec2 after = points[i + 1] - points[i];
  const double lengthBefore = glm::length(before);
  const double lengthAfter = glm::length(after);
  if (!(lengthBefore > 0) || !(lengthAfter > 0)) return otherwise;
  const Vec2 sum = before / lengthBefore + after / lengthAfter;
  return glm::length(sum) > 1e-3 ? glm::normalize(sum) : otherwise;
}

/// Runs emit(segment, tangent at its start, tangent at its end) over the pieces of a curve between two distances from its start.
template <typename Emit>
void eachCurvePiece(std::span<const Vec2> points, double fromPx, double toPx, Emit emit) {
  double at = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 step = points[i] - points[i - 1];
    const double length = glm::length(step);
    const double low = std::max(fromPx, at);
    const double high = std::min(toPx, at + length);
    if (length > 0 && low < high) {
      const Segment2 piece{points[i - 1] + step * ((low - at) / length), points[i - 1] + step * ((high - at) / length)};
      const Vec2 own = step / length;
      emit(piece, low > at ? own : tangentAt(points, i - 1, own), high < at + length ? own : tangentAt(points, i, own));
    }
    at += length;
  }
}

double lengthOf(std::span<const Vec2> points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += glm::length(points[i] - points[i - 1]);
  return length;
}

class ShapeList {
 public:
  explicit ShapeList(std::vector<OverlayShape>& shapes) : shapes_(shapes) { shapes_.clear(); }

  /// From here on strokes are compared with each other by strokeOnce().
  void beginLayer() { layer_ = shapes_.size(); }
  /// A stroke, unless the layer has one there already: neighbours in a chain share an extension line, which must not get darker by that.
  void strokeOnce(const Segment2& segment, double widthPx, double softnessPx, std::uint32_t rgba, const Hiding& hiding) {
    const glm::vec2 start(segment.start);
    const glm::vec2 end(segment.end);
    for (std::size_t i = layer_; i < shapes_.size(); ++i) {
      OverlayShape& other = shapes_[i];
      if (near(other.startPx, start) && near(other.endPx, end)) {
        if ((other.rgba >> 24U) < (rgba >> 24U)) other.rgba = rgba;
        other.hiddenShare = std::max(other.hiddenShare, hiding.share);
        return;
      }
    }
    add(segment, widthPx * 0.5, softnessPx, 0.0, OverlayShape::Kind::kStroke, rgba);
    hide(hiding);
  }

  void stroke(const Segment2& segment, double widthPx, double dashPx, std::uint32_t rgba, const Hiding& hiding = {}) {
    add(segment, widthPx * 0.5, 0.0, dashPx, OverlayShape::Kind::kStroke, rgba);
    hide(hiding);
  }
  void strokeHalo(const Segment2& segment, double widthPx, std::uint32_t rgba, const Hiding& hiding = {}) {
    add(segment, widthPx * 0.5 + kHaloReachPx, kHaloSoftnessPx, 0.0, OverlayShape::Kind::kStroke, rgba);
    hide(haloOf(hiding));
  }
  void arrow(const Vec2& tip, const Vec2& towardsTip, const Arrow& arrow, std::uint32_t rgba) {
    add({tip, tip - towardsTip * arrow.lengthPx}, arrow.halfWidthPx, 0.0, 0.0, OverlayShape::Kind::kArrow, rgba);
  }
  void disc(const Vec2& center, double radiusPx, double softnessPx, std::uint32_t rgba) {
    add({center - Vec2(radiusPx, 0), center + Vec2(radiusPx, 0)}, radiusPx, softnessPx, 0.0, OverlayShape::Kind::kDisc, rgba);
  }
  /// A piece of a curve, cut at right angles to the tangents at its ends.
  void curve(const Segment2& piece, const Vec2& tangentAtStart, const Vec2& tangentAtEnd, double halfWidthPx, double softnessPx, std::uint32_t rgba) {
    const Vec2 along = glm::normalize(piece.end - piece.start);
    const Vec2 right(-along.y, along.x);
    const auto lean = [&](const Vec2& tangent) { return static_cast<float>(-glm::dot(tangent, right) / glm::dot(tangent, along)); };
    add(piece, halfWidthPx, softnessPx, 0.0, OverlayShape::Kind::kCurve, rgba);
    shapes_.back().lean = {lean(tangentAtStart), lean(tangentAtEnd)};
  }
  /// The same triangle moved outwards by the halo's reach on all three sides.
  void arrowHalo(const Vec2& tip, const Vec2& towardsTip, const Arrow& arrow, std::uint32_t rgba) {
    const double slope = arrow.halfWidthPx / arrow.lengthPx;
    const double tipReach = kHaloReachPx * std::sqrt(1.0 + slope * slope) / slope;
    const double length = arrow.lengthPx + tipReach + kHaloReachPx;
    const Vec2 start = tip + towardsTip * tipReach;
    add({start, start - towardsTip * length}, length * slope, kHaloSoftnessPx, 0.0, OverlayShape::Kind::kArrow, rgba);
  }

 private:
  void add(const Segment2& segment, double halfWidthPx, double softnessPx, double dashPx, OverlayShape::Kind kind, std::uint32_t rgba) {
    shapes_.push_back({glm::vec2(segment.start), glm::vec2(segment.end), static_cast<float>(halfWidthPx),
                       static_cast<float>(softnessPx), static_cast<float>(dashPx), 1.0F, glm::vec2(0.0F), EndDepths(0.0F), kind, rgba});
  }

  void hide(const Hiding& hiding) {
    shapes_.back().hiddenShare = hiding.share;
    shapes_.back().depths = hiding.depths;
  }

  static bool near(const glm::vec2& a, const glm::vec2& b) { return std::abs(a.x - b.x) < 0.5F && std::abs(a.y - b.y) < 0.5F; }

  std::vector<OverlayShape>& shapes_;
  std::size_t layer_ = 0;
};

bool drawable(const OverlayLine& line) {
  return line.opacity > 0.0F && isFinite(line.line.start) && isFinite(line.line.end) && line.line.length() > 1e-3;
}
bool drawable(const OverlayArc& arc) {
  return arc.opacity > 0.0F && arc.points.size() > 1 && isFinite(arc.center) && std::isfinite(lengthOf(arc.points));
}
bool drawable(const OverlayThread& thread) {
  return thread.opacity > 0.0F && isFinite(thread.anchor) && isFinite(thread.box.min) && isFinite(thread.box.max);
}

// --- What draws the layers, from the lowest to the highest ---

/// Runs emit(segment) over the two legs of an angle, which are its extension lines.
template <typename Emit>
void eachLeg(const OverlayArc& arc, Emit emit) {
  for (const Vec2& end : {arc.points.front(), arc.points.back()}) {
    eachExtensionPiece(std::array<Vec2, 2>{arc.center, end}, {}, [&](const Segment2& piece, const EndDepths&) { emit(piece); });
  }
}

/// From the anchor's dot to the box; nothing when the anchor lies in the box.
std::optional<Segment2> segmentOf(const OverlayThread& thread) {
  const Segment2 whole{thread.anchor, thread.box.center()};
  const auto within = stretchWithin(whole, thread.box);
  if (!within || within->enter <= 0.0 || within->enter == within->leave) return std::nullopt;
  return Segment2{whole.start, whole.at(within->enter)};
}

void addHair(const Segment2& piece, float opacity, const Hiding& hiding, bool halo, const Theme& theme, ShapeList& list) {
  if (halo) {
    list.strokeOnce(piece, kExtensionWidthPx + 2.0 * kExtensionHaloReachPx, kHaloSoftnessPx, pack(theme.halo, opacity * kExtensionHaloOpacity), haloOf(hiding));
  } else {
    list.strokeOnce(piece, kExtensionWidthPx, 0.0, pack(theme.extension, opacity), hiding);
  }
}

/// The extension lines of a line, or their halos.
void addExtensions(const OverlayLine& line, bool halos, const Theme& theme, ShapeList& list) {
  const ExtensionDepths depths = line.extensionDepths.value_or(ExtensionDepths{});
  const float share = line.extensionDepths && !line.hovered && !line.active ? kExtensionHiddenShare : 1.0F;
  const auto add = [&](const Segment2& piece, const EndDepths& ends) { addHair(piece, line.opacity, {ends, share}, halos, theme, list); };
  eachExtensionPiece(line.extensionStart, pointDepths(line.extensionStart, depths, 0), add);
  eachExtensionPiece(line.extensionEnd, pointDepths(line.extensionEnd, depths, 1), add);
}

/// The thin lines that tie what is outside to the model, or their halos.
void addHairs(const Overlay& overlay, bool halos, const Theme& theme, ShapeList& list) {
  for (const OverlayLine& line : overlay.lines) {
    if (drawable(line)) addExtensions(line, halos, theme, list);
  }
  for (const OverlayArc& arc : overlay.arcs) {
    if (drawable(arc)) eachLeg(arc, [&](const Segment2& piece) { addHair(piece, arc.opacity, {}, halos, theme, list); });
  }
  for (const OverlayThread& thread : overlay.threads) {
    const auto segment = drawable(thread) ? segmentOf(thread) : std::nullopt;
    if (!segment) continue;
    addHair(*segment, thread.opacity, {}, halos, theme, list);
    if (halos) {
      list.disc(thread.anchor, kAnchorRadiusPx + kHaloReachPx, kHaloSoftnessPx, pack(theme.halo, thread.opacity));
    } else {
      list.disc(thread.anchor, kAnchorRadiusPx, 0.0, pack(theme.line, thread.opacity));
    }
  }
}

/// How a piece of a line fares where the model hides it; nothing hides a line that the pointer is at.
Hiding hidingOf(const OverlayLine& line, const Segment2& piece) {
  if (!line.depths || line.hovered || line.active) return {};
  const Vec2 along = line.line.end - line.line.start;
  const auto depthAt = [&](const Vec2& p) {
    const double share = glm::dot(p - line.line.start, along) / glm::dot(along, along);
    return glm::mix(line.depths->x, line.depths->y, static_cast<float>(share));
  };
  return {{depthAt(piece.start), depthAt(piece.end)}, kLineHiddenShare};
}

void addHalo(const OverlayLine& line, const Theme& theme, ShapeList& list) {
  const Pieces pieces = piecesOf(line);
  const std::uint32_t halo = pack(theme.halo, line.opacity);
  for (std::size_t i = 0; i < pieces.strokeCount; ++i) list.strokeHalo(pieces.strokes[i], kLineWidthPx, halo, hidingOf(line, pieces.strokes[i]));
  if (line.sphereEnds) {
    list.disc(line.line.start, pieces.startArrow.lengthPx + kHaloReachPx, kHaloSoftnessPx, halo);
    list.disc(line.line.end, pieces.endArrow.lengthPx + kHaloReachPx, kHaloSoftnessPx, halo);
  } else {
    list.arrowHalo(line.line.start, -pieces.along, pieces.startArrow, halo);
    list.arrowHalo(line.line.end, pieces.along, pieces.endArrow, halo);
  }
}

/// A ball: a disc with a highlight where the light comes from, at the top left.
void addSphere(const Vec2& center, double radiusPx, std::uint32_t rgba, float opacity, ShapeList& list) {
  list.disc(center, radiusPx, 0.0, rgba);
  list.disc(center - Vec2(kHighlightOffset * radiusPx), kHighlightRadius * radiusPx, kHighlightRadius * radiusPx,
            pack(glm::vec4(1.0F), kHighlightOpacity * opacity));
}

void addInk(const OverlayLine& line, const Theme& theme, ShapeList& list) {
  const Pieces pieces = piecesOf(line);
  const bool lit = line.hovered || line.active;
  // What can be dragged has the same colour on every line.
  const std::uint32_t handle = pack(lit ? theme.handleHovered : theme.handle, line.opacity);
  const glm::vec4 plain = line.color ? glm::vec4(glm::vec3(*line.color) * (lit ? kLitShade : 1.0F), line.color->a) : lit ? theme.lineHovered : theme.line;
  const std::uint32_t ink = pack(plain, line.opacity);
  for (std::size_t i = 0; i < pieces.strokeCount; ++i) {
    list.stroke(pieces.strokes[i], lit ? kLineWidthHoveredPx : kLineWidthPx, line.indirect ? kDashPx : 0.0, ink, hidingOf(line, pieces.strokes[i]));
  }
  if (line.sphereEnds) {
    addSphere(line.line.start, pieces.startArrow.lengthPx, line.startDraggable ? handle : ink, line.opacity, list);
    addSphere(line.line.end, pieces.endArrow.lengthPx, line.endDraggable ? handle : ink, line.opacity, list);
  } else {
    list.arrow(line.line.start, -pieces.along, pieces.startArrow, line.startDraggable ? handle : ink);
    list.arrow(line.line.end, pieces.along, pieces.endArrow, line.endDraggable ? handle : ink);
  }
}

/// Where a curve's arrowhead points to: its axis is the chord that it covers.
Vec2 headDirection(std::span<const Vec2> points, bool atEnd, double headPx) {
  const Vec2 tip = atEnd ? points.back() : points.front();
  Vec2 back = tip;
  for (std::size_t n = 1; n < points.size() && glm::length(back - tip) < headPx; ++n) back = points[atEnd ? points.size() - 1 - n : n];
  const Vec2 chord = tip - back;
  return glm::length(chord) > 0 ? glm::normalize(chord) : Vec2(1, 0);
}

void addArc(const OverlayArc& arc, bool halo, const Theme& theme, ShapeList& list) {
  const double lengthPx = lengthOf(arc.points);
  if (!(lengthPx > 1e-3)) return;
  const bool lit = arc.hovered || arc.active;
  const Arrow fixed = arrowOf(false, false, lengthPx, 1.0F);
  const Arrow moving = arrowOf(false, arc.draggable, lengthPx, arc.handleScale);
  const std::uint32_t ink = pack(halo ? theme.halo : lit ? theme.lineHovered : theme.line, arc.opacity);
  const double reachPx = halo ? kHaloReachPx : 0.0;
  const double halfWidthPx = 0.5 * (lit ? kLineWidthHoveredPx : kLineWidthPx) + reachPx;
  eachCurvePiece(arc.points, fixed.lengthPx * kStrokeInset, lengthPx - moving.lengthPx * kStrokeInset,
                [&](const Segment2& piece, const Vec2& tangentAtStart, const Vec2& tangentAtEnd) {
                  list.curve(piece, tangentAtStart, tangentAtEnd, halfWidthPx, halo ? kHaloSoftnessPx : 0.0, ink);
                });
  const std::uint32_t handle = pack(lit ? theme.handleHovered : theme.handle, arc.opacity);
  const Vec2 atStart = headDirection(arc.points, false, fixed.lengthPx);
  const Vec2 atEnd = headDirection(arc.points, true, moving.lengthPx);
  if (halo) {
    list.arrowHalo(arc.points.front(), atStart, fixed, ink);
    list.arrowHalo(arc.points.back(), atEnd, moving, ink);
  } else {
    list.arrow(arc.points.front(), atStart, fixed, ink);
    list.arrow(arc.points.back(), atEnd, moving, arc.draggable ? handle : ink);
  }
}

bool drawable(const OverlayEdge& edge) {
  return edge.opacity > 0.0F && isFinite(edge.line.start) && isFinite(edge.line.end) && edge.line.length() > 0.5;
}

/// Edges have a soft border of white, so that they are seen on dark walls too.
void addEdge(const OverlayEdge& edge, const Theme& theme, ShapeList& list) {
  const float opacity = edge.opacity * kEdgeOpacity;
  const Hiding hiding{edge.depths, edge.shownHidden ? kEdgeHiddenShare : 0.0F};
  list.strokeHalo(edge.line, kEdgeWidthPx, pack(theme.halo, opacity * kExtensionHaloOpacity), hiding);
  list.stroke(edge.line, kEdgeWidthPx, 0.0, pack(theme.handleHovered, opacity), hiding);
}

void addMark(const DragMark& mark, const Theme& theme, ShapeList& list) {
  const auto strength = static_cast<float>(mark.strength);
  switch (mark.kind) {
    case DragMark::Kind::kTick:
    case DragMark::Kind::kLongTick:
      list.stroke(mark.line, kTickWidthPx, 0.0, pack(theme.line, kTickOpacity * strength));
      break;
    case DragMark::Kind::kLimit:
      list.stroke(mark.line, kLimitWidthPx, 0.0, pack(theme.line, kLimitOpacity * strength));
      break;
    case DragMark::Kind::kLimitReached:
      list.stroke(mark.line, kLimitReachedWidthPx, 0.0, pack(theme.handleHovered, strength));
      break;
    case DragMark::Kind::kGhost:
      list.stroke(mark.line, kLineWidthPx, 0.0, pack(theme.line, kGhostOpacity * strength));
      break;
  }
}

}  // namespace

void buildOverlay(const Overlay& overlay, const Theme& theme, std::vector<OverlayShape>& shapes) {
  ShapeList list(shapes);
  for (const OverlayEdge& edge : overlay.edges) {
    if (drawable(edge)) addEdge(edge, theme, list);
  }
  list.beginLayer();
  addHairs(overlay, true, theme, list);
  for (const OverlayLine& line : overlay.lines) {
    if (drawable(line)) addHalo(line, theme, list);
  }
  for (const OverlayArc& arc : overlay.arcs) {
    if (drawable(arc)) addArc(arc, true, theme, list);
  }
  list.beginLayer();
  addHairs(overlay, false, theme, list);
  for (const DragMark& mark : overlay.marks) {
    if (isFinite(mark.line.start) && isFinite(mark.line.end)) addMark(mark, theme, list);
  }
  for (const OverlayLine& line : overlay.lines) {
    if (drawable(line)) addInk(line, theme, list);
  }
  for (const OverlayArc& arc : overlay.arcs) {
    if (drawable(arc)) addArc(arc, false, theme, list);
  }
}

}  // namespace dimline
