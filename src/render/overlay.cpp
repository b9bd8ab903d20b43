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
/// Dash and gap of an indirect line (px).
constexpr double kDashPx = 4.0;
/// A line's arrowheads never take more than this share of it, so that something of the line is left between them.
constexpr double kArrowsShare = 0.7;

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

bool finite(const Vec2& v) { return std::isfinite(v.x) && std::isfinite(v.y); }

std::uint32_t pack(const glm::vec4& color, float opacity) {
  const auto byte = [](float v) { return static_cast<std::uint32_t>(std::lround(std::clamp(v, 0.0F, 1.0F) * 255.0F)); };
  return byte(color.r) | (byte(color.g) << 8U) | (byte(color.b) << 16U) | (byte(color.a * opacity) << 24U);
}

/// The stretch of a segment inside a box as parameters along it; empty (first > second) when it passes by.
std::pair<double, double> stretchInside(const Segment2& s, const Box2& box) {
  double enter = 0.0;
  double leave = 1.0;
  const Vec2 d = s.end - s.start;
  for (int axis = 0; axis < 2; ++axis) {
    if (d[axis] == 0.0) {
      if (s.start[axis] < box.min[axis] || s.start[axis] > box.max[axis]) return {1.0, 0.0};
      continue;
    }
    const double t0 = (box.min[axis] - s.start[axis]) / d[axis];
    const double t1 = (box.max[axis] - s.start[axis]) / d[axis];
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  return {enter, leave};
}

Arrow arrowOf(bool draggable, double lengthPx, float handleScale) {
  const double wanted = kArrowLengthPx * (draggable ? static_cast<double>(handleScale) : 1.0);
  const double length = std::min(wanted, lengthPx * kArrowsShare * 0.5);
  return {length, kArrowHalfWidthPx * length / kArrowLengthPx};
}

Pieces piecesOf(const OverlayLine& line) {
  Pieces pieces;
  pieces.lengthPx = line.line.length();
  pieces.along = (line.line.end - line.line.start) / pieces.lengthPx;
  pieces.startArrow = arrowOf(line.startDraggable, pieces.lengthPx, line.handleScale);
  pieces.endArrow = arrowOf(line.endDraggable, pieces.lengthPx, line.handleScale);
  // The stroke ends inside the arrowheads, where they are wide enough to hide it, so that their tips stay sharp.
  const Segment2 stroke{line.line.start + pieces.along * (pieces.startArrow.lengthPx * 0.7),
                        line.line.end - pieces.along * (pieces.endArrow.lengthPx * 0.7)};
  pieces.strokes[0] = stroke;
  pieces.strokeCount = 1;
  if (!line.label) return pieces;
  const auto [enter, leave] = stretchInside(stroke, line.label->grown(kLabelPaddingPx));
  if (enter >= leave) return pieces;
  const Vec2 d = stroke.end - stroke.start;
  pieces.strokeCount = 0;
  if (enter > 0.0) pieces.strokes[pieces.strokeCount++] = {stroke.start, stroke.start + d * enter};
  if (leave < 1.0) pieces.strokes[pieces.strokeCount++] = {stroke.end, stroke.start + d * leave};
  return pieces;
}

/// Runs emit(segment) over an extension line: it stands off the base line's end and runs on past the final line.
template <typename Emit>
void eachExtensionPiece(std::span<const Vec2> polyline, Emit emit) {
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
    skip = 0;
    if (i + 1 == polyline.size()) piece.end += direction * kExtensionOvershootPx;
    emit(piece);
  }
}

class ShapeList {
 public:
  explicit ShapeList(std::vector<OverlayShape>& shapes) : shapes_(shapes) { shapes_.clear(); }

  /// From here on strokes are compared with each other by strokeOnce().
  void beginLayer() { layer_ = shapes_.size(); }
  /// A stroke, unless the layer has one there already: neighbours in a chain share an extension line, which must not get darker by that.
  void strokeOnce(const Segment2& segment, double widthPx, double softnessPx, std::uint32_t rgba) {
    const glm::vec2 start(segment.start);
    const glm::vec2 end(segment.end);
    for (std::size_t i = layer_; i < shapes_.size(); ++i) {
      OverlayShape& other = shapes_[i];
      if (near(other.startPx, start) && near(other.endPx, end)) {
        if ((other.rgba >> 24U) < (rgba >> 24U)) other.rgba = rgba;
        return;
      }
    }
    add(segment, widthPx * 0.5, softnessPx, 0.0, OverlayShape::Kind::kStroke, rgba);
  }

  void stroke(const Segment2& segment, double widthPx, double dashPx, std::uint32_t rgba) {
    add(segment, widthPx * 0.5, 0.0, dashPx, OverlayShape::Kind::kStroke, rgba);
  }
  void strokeHalo(const Segment2& segment, double widthPx, std::uint32_t rgba) {
    add(segment, widthPx * 0.5 + kHaloReachPx, kHaloSoftnessPx, 0.0, OverlayShape::Kind::kStroke, rgba);
  }
  void arrow(const Vec2& tip, const Vec2& towardsTip, const Arrow& arrow, std::uint32_t rgba) {
    add({tip, tip - towardsTip * arrow.lengthPx}, arrow.halfWidthPx, 0.0, 0.0, OverlayShape::Kind::kArrow, rgba);
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
                       static_cast<float>(softnessPx), static_cast<float>(dashPx), kind, rgba});
  }

  static bool near(const glm::vec2& a, const glm::vec2& b) { return std::abs(a.x - b.x) < 0.5F && std::abs(a.y - b.y) < 0.5F; }

  std::vector<OverlayShape>& shapes_;
  std::size_t layer_ = 0;
};

bool drawable(const OverlayLine& line) {
  return line.opacity > 0.0F && finite(line.line.start) && finite(line.line.end) && line.line.length() > 1e-3;
}

/// What draws the layers of one line, from the lowest to the highest.
void addExtensionHalos(const OverlayLine& line, const Theme& theme, ShapeList& list) {
  const std::uint32_t halo = pack(theme.halo, line.opacity * kExtensionHaloOpacity);
  for (const std::span<const Vec2> extension : {line.extensionStart, line.extensionEnd}) {
    eachExtensionPiece(extension, [&](const Segment2& piece) {
      list.strokeOnce(piece, kExtensionWidthPx + 2.0 * kExtensionHaloReachPx, kHaloSoftnessPx, halo);
    });
  }
}

void addHalos(const OverlayLine& line, const Theme& theme, ShapeList& list) {
  const Pieces pieces = piecesOf(line);
  const std::uint32_t halo = pack(theme.halo, line.opacity);
  for (std::size_t i = 0; i < pieces.strokeCount; ++i) list.strokeHalo(pieces.strokes[i], kLineWidthPx, halo);
  list.arrowHalo(line.line.start, -pieces.along, pieces.startArrow, halo);
  list.arrowHalo(line.line.end, pieces.along, pieces.endArrow, halo);
}

void addExtensions(const OverlayLine& line, const Theme& theme, ShapeList& list) {
  const std::uint32_t ink = pack(theme.extension, line.opacity);
  for (const std::span<const Vec2> extension : {line.extensionStart, line.extensionEnd}) {
    eachExtensionPiece(extension, [&](const Segment2& piece) { list.strokeOnce(piece, kExtensionWidthPx, 0.0, ink); });
  }
}

void addInk(const OverlayLine& line, const Theme& theme, ShapeList& list) {
  const Pieces pieces = piecesOf(line);
  const bool lit = line.hovered || line.active;
  const std::uint32_t ink = pack(lit ? theme.lineHovered : theme.line, line.opacity);
  const std::uint32_t handle = pack(lit ? theme.handleHovered : theme.handle, line.opacity);
  for (std::size_t i = 0; i < pieces.strokeCount; ++i) {
    list.stroke(pieces.strokes[i], lit ? kLineWidthHoveredPx : kLineWidthPx, line.indirect ? kDashPx : 0.0, ink);
  }
  list.arrow(line.line.start, -pieces.along, pieces.startArrow, line.startDraggable ? handle : ink);
  list.arrow(line.line.end, pieces.along, pieces.endArrow, line.endDraggable ? handle : ink);
}

}  // namespace

void buildOverlay(std::span<const OverlayLine> lines, const Theme& theme, std::vector<OverlayShape>& shapes) {
  ShapeList list(shapes);
  for (const auto addLayer : {addExtensionHalos, addHalos, addExtensions, addInk}) {
    list.beginLayer();
    for (const OverlayLine& line : lines) {
      if (drawable(line)) addLayer(line, theme, list);
    }
  }
}

}  // namespace dimline
