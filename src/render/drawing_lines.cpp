#include "render/drawing_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "render/tone_regions.h"

namespace dimline {

namespace {

/// px. Gaps up to the first are bridged: samples that chance decided. A stretch shorter than the second is a speck, unless it is most of
/// its edge.
constexpr double kLongestGapPx = 2.5;
constexpr double kSpeckPx = 6.0;
constexpr double kMostOfEdge = 0.6;

/// px. No line is shorter.
constexpr double kShortestPx = 0.75;

/// px. Edges shorter than the first, or beside a face narrower than that, are details; beside one narrower than the second they run together with
/// what is next to them.
constexpr double kDetailWidthPx = 6.0;
constexpr double kNarrowestPx = 1.8;

/// px. What is narrower than the first, seen against the background, is a rope or a leaf, or the gap between two: an outline on either side
/// would leave nothing but ink of it. Narrower than the second, its border is a detail.
constexpr double kBodyPx = 8.0;
constexpr double kThinPx = 4.0;

/// Share of the depth by which an edge may lie behind what is seen beside it: it lies on that surface.
constexpr double kDepthTolerance = 3e-4;
/// The same in parallel projection, where how far the eye is means nothing: a share of the depths that the model takes up.
constexpr double kParallelDepthTolerance = 8e-4;

/// Cosine. Parts that meet at less of an angle run on into each other, as the boards of a wall do: no line between them.
constexpr float kMeetingCosine = 0.98F;

/// px. A border with an edge's line this near to it is drawn already.
constexpr double kCoveredPx = 1.6;

/// Samples. How far a traced border may be from the samples' own stairs.
constexpr double kBorderTolerance = 1.0;

/// The part of a segment with depth of at least the near plane's, or nothing.
std::optional<Segment> beforeNear(const Vec3& a, const Vec3& b, const View& view) {
  const double beyondA = view.depth(a) - view.nearM(), beyondB = view.depth(b) - view.nearM();
  if (beyondA < 0 && beyondB < 0) return std::nullopt;
  Segment s{a, b};
  const Vec3 cut = a + (b - a) * (beyondA / (beyondA - beyondB));
  if (beyondA < 0) s.start = cut;
  if (beyondB < 0) s.end = cut;
  return s;
}

/// The share [first, last] of a segment that lies in a box, or nothing.
std::optional<std::pair<double, double>> shareInside(const Segment2& s, const Box2& box) {
  double first = 0, last = 1;
  const Vec2 d = s.end - s.start;
  for (int axis = 0; axis < 2; ++axis) {
    if (d[axis] == 0) {
      if (s.start[axis] < box.min[axis] || s.start[axis] > box.max[axis]) return std::nullopt;
      continue;
    }
    const double t0 = (box.min[axis] - s.start[axis]) / d[axis], t1 = (box.max[axis] - s.start[axis]) / d[axis];
    first = std::max(first, std::min(t0, t1));
    last = std::min(last, std::max(t0, t1));
  }
  if (!(first < last)) return std::nullopt;
  return std::pair{first, last};
}

class LineFinder {
public:
  LineFinder(const View& view, const ModelPicture& picture) : view_(view), picture_(picture) {}

  void add(const EdgeLine& edge) {
    const Vec3 a = edge.a, b = edge.b;
    const bool frontA = glm::dot(Vec3(edge.normalA), view_.directionTo(a)) < 0;
    const bool frontB = glm::dot(Vec3(edge.normalB), view_.directionTo(a)) < 0;
    const bool contour = frontA != frontB;
    const bool crease = edge.widthM >= 0;
    if (!contour && !(crease && frontA)) return;
    const auto world = beforeNear(a, b, view_);
    if (!world) return;
    const Segment2 screen = view_.toScreen(*world);
    const auto share = shareInside(screen, view_.viewport());
    if (!share) return;

    const double widthPx = crease ? edge.widthM / view_.metresPerPixelAt(world->middle()) : kDetailWidthPx;
    if (!contour && widthPx < kNarrowestPx) return;
    LineWeight weight = contour ? LineWeight::kContour : LineWeight::kEdge;
    if (widthPx < kDetailWidthPx || screen.length() < kDetailWidthPx) weight = LineWeight::kDetail;
    trace(*world, screen, share->first, share->second, weight);
  }

  std::vector<DrawingLine> take() { return std::move(lines_); }

private:
  enum class Sample : std::uint8_t { kHidden, kSeen, kAtBackground };

  /// Walks along the edge in steps of about a sample and keeps the stretches that are seen.
  void trace(const Segment& world, const Segment2& screen, double first, double last, LineWeight weight) {
    const double lengthPx = screen.length() * (last - first);
    const int steps = std::max(1, static_cast<int>(std::ceil(lengthPx * picture_.samplesPerPx)));
    const double nearStart = nearnessOf(view_, view_.depth(world.start)),
                 nearEnd = nearnessOf(view_, view_.depth(world.end));
    samples_.clear();
    for (int i = 0; i <= steps; ++i) {
      // Nearness is linear on screen, so a share of the line on screen is a share of it.
      const double t = first + (last - first) * i / steps;
      samples_.push_back(look(screen.at(t), nearStart + (nearEnd - nearStart) * t));
    }
    bridgeGaps(lengthPx / steps);
    const auto at = [&](int i) {
      return screen.at(first + (last - first) * i / steps);
    };
    for (int i = 0; i <= steps; ++i) {
      if (samples_[static_cast<std::size_t>(i)] == Sample::kHidden) continue;
      int end = i, background = 0;
      while (end <= steps && samples_[static_cast<std::size_t>(end)] != Sample::kHidden) {
        if (samples_[static_cast<std::size_t>(end)] == Sample::kAtBackground) ++background;
        ++end;
      }
      const Segment2 seen{at(i), at(end - 1)};
      const bool outline = 2 * background > end - i && weight != LineWeight::kEdge;
      const bool speck = seen.length() < kSpeckPx && seen.length() < kMostOfEdge * lengthPx;
      if (outline ? seen.length() > 0 : seen.length() >= kShortestPx && !speck) {
        lines_.push_back({seen, outline ? outlineWeight(seen) : weight});
      }
      i = end - 1;
    }
  }

  /// Whether an edge's point is seen: beside it, or at it, lies something that is no nearer than the edge itself.
  [[nodiscard]] Sample look(const Vec2& pointPx, double nearness) const {
    const double depthM = depthOf(view_, nearness);
    const double toleranceM = view_.orthographic() ? kParallelDepthTolerance * (view_.farM() - view_.nearM()) : kDepthTolerance * depthM;
    const double farthest = nearnessOf(view_, depthM - toleranceM);
    const int x = static_cast<int>(std::floor(pointPx.x * picture_.samplesPerPx));
    const int y = static_cast<int>(std::floor(pointPx.y * picture_.samplesPerPx));
    Sample result = Sample::kHidden;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int sx = x + dx, sy = y + dy;
        if (sx < 0 || sy < 0 || sx >= picture_.width || sy >= picture_.height) continue;
        const std::size_t i = picture_.at(sx, sy);
        if (picture_.seen[i] == ModelPicture::kNothing) return Sample::kAtBackground;
        if (picture_.nearness[i] <= farthest) result = Sample::kSeen;
      }
    }
    return result;
  }

  /// The pen for a border between the model and the background: as heavy as the narrower of the two beside it is wide.
  [[nodiscard]] LineWeight outlineWeight(const Segment2& border) const {
    const Vec2 along = border.end - border.start;
    const Vec2 across = Vec2(-along.y, along.x) / std::max(glm::length(along), 1e-9);
    double widthPx = 0;
    constexpr int kLooks = 3;
    for (int i = 0; i < kLooks; ++i) {
      const Vec2 p = border.start + along * ((i + 0.5) / kLooks);
      const auto widest = [&](bool model) { return std::max(widthFrom(p, across, model), widthFrom(p, -across, model)); };
      widthPx += std::min(widest(true), widest(false)) / kLooks;
    }
    return widthPx >= kBodyPx ? LineWeight::kOutline : widthPx >= kThinPx ? LineWeight::kEdge : LineWeight::kDetail;
  }

  /// How far the model, or the background, reaches from a point of their border, in px; kBodyPx where it is farther.
  [[nodiscard]] double widthFrom(const Vec2& pointPx, const Vec2& direction, bool model) const {
    const double step = 1 / picture_.samplesPerPx;
    for (double px = 2 * step; px < kBodyPx; px += step) {  // the border itself may miss it by a sample
      const Vec2 p = (pointPx + direction * px) * picture_.samplesPerPx;
      const int x = static_cast<int>(std::floor(p.x)), y = static_cast<int>(std::floor(p.y));
      if (x < 0 || y < 0 || x >= picture_.width || y >= picture_.height) return kBodyPx;
      if ((picture_.seen[picture_.at(x, y)] != ModelPicture::kNothing) != model) return px - step;
    }
    return kBodyPx;
  }

  void bridgeGaps(double stepPx) {
    const auto longest = static_cast<std::size_t>(kLongestGapPx / std::max(stepPx, 1e-6));
    for (std::size_t i = 1; i < samples_.size(); ++i) {
      if (samples_[i] != Sample::kHidden || samples_[i - 1] == Sample::kHidden) continue;
      std::size_t end = i;
      while (end < samples_.size() && samples_[end] == Sample::kHidden) ++end;
      if (end < samples_.size() && end - i <= longest)
        std::fill(samples_.begin() + static_cast<std::ptrdiff_t>(i),
                  samples_.begin() + static_cast<std::ptrdiff_t>(end), Sample::kSeen);
      i = end;
    }
  }

  const View& view_;
  const ModelPicture& picture_;
  std::vector<Sample> samples_;
  std::vector<DrawingLine> lines_;
};

/// Finds where parts run into each other, from the borders between them in the picture.
class MeetingFinder {
public:
  MeetingFinder(const ModelPicture& picture, const std::vector<DrawingLine>& drawn)
      : picture_(picture), covered_(picture.seen.size(), 0) {
    for (const DrawingLine& line : drawn) cover(line.segment);
  }

  void find(std::vector<DrawingLine>& lines) const {
    std::vector<std::uint32_t> parts(picture_.seen.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      parts[i] = picture_.seen[i] == ModelPicture::kNothing ? 0 : picture_.surfaces[picture_.seen[i]].part + 1;
    }
    const ToneMap map = traceRegions(parts, picture_.width, picture_.height, kBorderTolerance);
    for (const ToneBorder& border : map.borders) {
      if (border.leftLabel == 0 || border.rightLabel == 0) continue;
      for (std::size_t i = 1; i < border.points.size(); ++i) walk(border.points[i - 1], border.points[i], lines);
    }
  }

private:
  void cover(const Segment2& segmentPx) {
    const double reach = kCoveredPx * picture_.samplesPerPx;
    const Vec2 a = segmentPx.start * picture_.samplesPerPx, b = segmentPx.end * picture_.samplesPerPx;
    const int steps = static_cast<int>(std::ceil(glm::length(b - a) / reach)) + 1;
    for (int i = 0; i <= steps; ++i) {
      const Vec2 p = a + (b - a) * (static_cast<double>(i) / steps);
      for (int y = clampY(p.y - reach); y <= clampY(p.y + reach); ++y) {
        for (int x = clampX(p.x - reach); x <= clampX(p.x + reach); ++x) covered_[picture_.at(x, y)] = 1;
      }
    }
  }

  /// The stretches of a border, in samples, that are worth a line.
  void walk(const Vec2& a, const Vec2& b, std::vector<DrawingLine>& lines) const {
    const double length = glm::length(b - a);
    const int steps = std::max(1, static_cast<int>(std::ceil(length)));
    const Vec2 across = Vec2(a.y - b.y, b.x - a.x) / std::max(length, 1e-9);
    const auto at = [&](int i) { return a + (b - a) * ((i + 0.5) / steps); };
    for (int i = 0; i < steps; ++i) {
      int end = i;
      while (end < steps && meets(at(end), across)) ++end;
      if (end == i) continue;
      // It ran out near a line that it meets: up to there.
      const double reach = kCoveredPx * picture_.samplesPerPx;
      const double from = std::max(0.0, i - reach) / steps, to = std::min<double>(steps, end + reach) / steps;
      const Segment2 stretch{(a + (b - a) * from) / picture_.samplesPerPx, (a + (b - a) * to) / picture_.samplesPerPx};
      if (stretch.length() >= kShortestPx) lines.push_back({stretch, LineWeight::kEdge});
      i = end;
    }
  }

  [[nodiscard]] bool meets(const Vec2& p, const Vec2& across) const {
    if (covered_[picture_.at(clampX(p.x), clampY(p.y))] != 0) return false;
    const std::uint32_t left = seenAt(p - across * 1.5), right = seenAt(p + across * 1.5);
    if (left == ModelPicture::kNothing || right == ModelPicture::kNothing) return false;
    return glm::dot(picture_.surfaces[left].normal, picture_.surfaces[right].normal) < kMeetingCosine;
  }
  [[nodiscard]] std::uint32_t seenAt(const Vec2& p) const {
    return picture_.seen[picture_.at(clampX(p.x), clampY(p.y))];
  }
  [[nodiscard]] int clampX(double x) const {
    return std::clamp(static_cast<int>(std::floor(x)), 0, picture_.width - 1);
  }
  [[nodiscard]] int clampY(double y) const {
    return std::clamp(static_cast<int>(std::floor(y)), 0, picture_.height - 1);
  }

  const ModelPicture& picture_;
  std::vector<std::uint8_t> covered_;
};

}  // namespace

std::vector<DrawingLine> drawingLines(const std::vector<EdgeLine>& edges, const View& view,
                                      const ModelPicture& picture) {
  LineFinder finder(view, picture);
  for (const EdgeLine& edge : edges) finder.add(edge);
  std::vector<DrawingLine> lines = finder.take();
  MeetingFinder(picture, lines).find(lines);
  return lines;
}

}  // namespace dimline
