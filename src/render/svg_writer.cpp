#include "render/svg_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/constants.h"
#include "core/text.h"
#include "editing/arc_projection.h"
#include "placement/barlow_advances.h"
#include "placement/text_metrics.h"
#include "render/drawing_lines.h"
#include "render/edge_lines.h"
#include "render/model_picture.h"
#include "render/overlay_line.h"
#include "render/tone_regions.h"

namespace dimline {

namespace {

/// Samples a pixel along each axis. At three, smoothed outlines of tones are within a third of a pixel, which the lines drawn over them
/// hide.
constexpr double kSamplesPerPx = 3.0;
/// Samples. A traced line's points are within half a sample of it, and so is the chord between two of them.
constexpr double kToneTolerance = 1.0;

/// Ink of the model's lines, from outline to detail: width (px) and colour.
struct Pen {
  double widthPx;
  const char* color;
};
constexpr std::array<Pen, 4> kPens{{{1.6, "#2b3138"}, {0.9, "#3c444d"}, {0.6, "#59626c"}, {0.4, "#7d8791"}}};

/// px. What hides a dimension line is looked for in steps of this length along it, at most so many.
constexpr double kHidingStepPx = 1.0;
constexpr double kMostHidingSteps = 4096;

/// The white plate behind a text on the model, as the page has it: how much of the model it covers, and how far it reaches beyond the text's box (px).
constexpr double kPlateOpacity = 0.65;
constexpr double kPlateMarginPx = 2.0;

/// Share of a halo's soft rim that is cut off.
constexpr float kHaloFade = 0.75F;

Theme drawingTheme() {
  Theme theme;
  theme.line = srgb(0x12181F);
  theme.handle = srgb(0x12181F);  // a drawing on paper has nothing to drag
  theme.extension = srgb(0x4A545F);
  theme.halo = srgb(0xFFFFFF, 0.7F);
  return theme;
}

/// Hundredths of a pixel, without trailing zeros: what a drawing resolves, in few bytes.
std::string number(double value) {
  std::string text = formatFixed(value, 2);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}
std::string point(const Vec2& p) { return number(p.x) + " " + number(p.y); }

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : readable(text)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string hexColor(std::uint32_t rgb) {
  char text[8];
  std::snprintf(text, sizeof text, "#%06x", static_cast<unsigned>(rgb & 0xFFFFFFU));
  return text;
}

void writeTones(const ModelPicture& picture, std::string& svg) {
  std::vector<std::uint32_t> labels(picture.seen.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    // One more than the colour, so that black is not nothing.
    labels[i] = picture.seen[i] == ModelPicture::kNothing ? 0 : picture.surfaces[picture.seen[i]].rgb + 1;
  }
  const ToneMap map = traceRegions(labels, picture.width, picture.height, kToneTolerance);
  // A stroke of each area's own colour closes the hairlines that anti-aliasing leaves between neighbours.
  svg += "<g stroke-width=\"0.7\" stroke-linejoin=\"round\" fill-rule=\"evenodd\">\n";
  for (const ToneRegion& region : map.regions) {
    const std::string color = hexColor(region.label - 1);
    svg += "<path fill=\"" + color + "\" stroke=\"" + color + "\" d=\"";
    for (const auto& ring : region.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) svg += (i == 0 ? "M" : "L") + point(ring[i] / picture.samplesPerPx);
      svg += "Z";
    }
    svg += "\"/>\n";
  }
  svg += "</g>\n";
}

void writeLines(const Scene& scene, const View& view, const ModelPicture& picture, std::string& svg) {
  std::vector<EdgeLine> edges;
  findEdgeLines(scene, edges);
  std::array<std::string, kPens.size()> paths;
  for (const DrawingLine& line : drawingLines(edges, view, picture)) {
    std::string& path = paths[static_cast<std::size_t>(line.weight)];
    path += "M" + point(line.segment.start) + "L" + point(line.segment.end);
  }
  svg += "<g fill=\"none\" stroke-linecap=\"round\">\n";
  for (std::size_t i = kPens.size(); i-- > 0;) {  // the heaviest on top
    if (paths[i].empty()) continue;
    svg += std::string("<path stroke=\"") + kPens[i].color + "\" stroke-width=\"" + number(kPens[i].widthPx) +
           "\" d=\"" + paths[i] + "\"/>\n";
  }
  svg += "</g>\n";
}

/// Switches and choices are for the hand, not for paper, and are left out.
std::vector<OverlayShape> overlayOf(const Scene& scene, const Layout& layout) {
  std::vector<OverlayLine> lines;
  for (const PlacedLine& placed : layout.lines) {
    OverlayLine line = overlayLine(placed, scene, layout.view);
    line.startDraggable = line.endDraggable = false;  // on paper
    lines.push_back(line);
  }
  std::vector<OverlayArc> arcs;
  std::vector<std::vector<Vec2>> points(layout.others.size());
  for (std::size_t i = 0; i < layout.others.size(); ++i) {
    const auto& arc = layout.others[i].arc;
    if (!arc || !arcOnScreen(*arc, layout.view, points[i])) continue;
    arcs.push_back({.points = points[i], .center = layout.view.toScreen(arc->center)});
  }
  std::vector<OverlayShape> shapes;
  buildOverlay({lines, arcs, {}}, drawingTheme(), shapes);
  return shapes;
}

/// Whether the model hides a stroke at that share of its length; shaders/overlay.frag judges the same.
bool hiddenAt(const OverlayShape& stroke, double share, const View& view, const ModelPicture& picture) {
  const double windowDepth = glm::mix(static_cast<double>(stroke.depths.x), static_cast<double>(stroke.depths.y), share);
  const double nearness = nearnessOf(view, view.depthFromWindow(windowDepth));
  const Vec2 at = glm::mix(Vec2(stroke.startPx), Vec2(stroke.endPx), share);
  const auto hides = [&](const Vec2& p) {
    const Vec2 sample = glm::floor(p * picture.samplesPerPx);
    const int x = static_cast<int>(std::clamp(sample.x, 0.0, picture.width - 1.0));
    const int y = static_cast<int>(std::clamp(sample.y, 0.0, picture.height - 1.0));
    const std::size_t i = picture.at(x, y);
    return picture.seen[i] != ModelPicture::kNothing && static_cast<double>(picture.nearness[i]) > nearness;
  };
  bool hidden = hides(at);
  for (int i = 0; i < 8 && hidden; ++i) {
    const double turnRad = i * 45.0 * kRadPerDeg;
    hidden = hides(at + Vec2(std::cos(turnRad), std::sin(turnRad)) * kHiderReachPx);
  }
  return hidden;
}

/// Cuts a stroke where the model begins or ends to hide it, and runs emit(piece) over what is left, each as opaque as it shows; over the whole shape when nothing can hide it.
template <typename Emit>
void eachShownPiece(const OverlayShape& stroke, const View& view, const ModelPicture& picture, Emit emit) {
  if (!(stroke.hiddenShare < 1.0F)) return emit(stroke);
  const double steps = std::clamp(std::ceil(glm::length(Vec2(stroke.endPx) - Vec2(stroke.startPx)) / kHidingStepPx), 1.0, kMostHidingSteps);
  const auto hiddenIn = [&](double step) { return hiddenAt(stroke, (step + 0.5) / steps, view, picture); };
  for (double from = 0; from < steps;) {
    const bool hidden = hiddenIn(from);
    double to = from + 1;
    while (to < steps && hiddenIn(to) == hidden) ++to;
    OverlayShape piece = stroke;
    piece.startPx = glm::mix(stroke.startPx, stroke.endPx, static_cast<float>(from / steps));
    piece.endPx = glm::mix(stroke.startPx, stroke.endPx, static_cast<float>(to / steps));
    if (hidden) {
      const auto opacity = static_cast<float>(stroke.rgba >> 24U) * stroke.hiddenShare;
      piece.rgba = (stroke.rgba & 0xFFFFFFU) | static_cast<std::uint32_t>(std::lround(opacity)) << 24U;
    }
    if (piece.rgba >> 24U > 0U) emit(piece);
    from = to;
  }
}

/// What shapes have in common that become one path.
struct Look {
  bool stroke = true;
  std::uint32_t rgba = 0;
  float widthPx = 0;  ///< of a stroke
  float dashPx = 0;
  bool operator==(const Look&) const = default;
};

struct LookPath {
  Look look;
  std::string d;
  Vec2 end{0.0};  ///< of its last stroke, where a curve's next piece goes on
};

/// `reachPx`: half the width of a stroke, the radius of a disc.
void appendShape(const OverlayShape& shape, double reachPx, LookPath& path) {
  const Vec2 start(shape.startPx), end(shape.endPx);
  switch (shape.kind) {
    case OverlayShape::Kind::kStroke:
      path.d += "M" + point(start) + "L" + point(end);
      break;
    case OverlayShape::Kind::kCurve:
      if (path.d.empty() || glm::length(path.end - start) > 0.01) path.d += "M" + point(start);
      path.d += "L" + point(end);
      break;
    case OverlayShape::Kind::kArrow: {
      if (start == end) break;   // so far off the paper that floats do not tell its ends apart
      const Vec2 along = glm::normalize(end - start);
      const Vec2 across = Vec2(-along.y, along.x) * static_cast<double>(shape.halfWidthPx);
      path.d += "M" + point(start) + "L" + point(end + across) + "L" + point(end - across) + "Z";
      break;
    }
    case OverlayShape::Kind::kDisc: {
      const Vec2 center = 0.5 * (start + end);
      const std::string radii = "a" + number(reachPx) + " " + number(reachPx) + " 0 1 0 ";
      path.d += "M" + point(center - Vec2(reachPx, 0)) + radii + number(2 * reachPx) + " 0" + radii + number(-2 * reachPx) + " 0Z";
      break;
    }
  }
  path.end = end;
}

/// Shapes of one look become one path, in the order in which the looks first appear: halos stay below ink.
void writeOverlay(const Scene& scene, const Layout& layout, const ModelPicture& picture, std::string& svg) {
  std::vector<LookPath> paths;
  const auto write = [&](const OverlayShape& shape) {
    const bool stroke = shape.kind == OverlayShape::Kind::kStroke || shape.kind == OverlayShape::Kind::kCurve;
    // Paper knows no soft rims: a halo ends where it has faded for the most part.
    const float reachPx = shape.halfWidthPx - kHaloFade * shape.softnessPx;
    const Look look{stroke, shape.rgba, stroke ? 2.0F * reachPx : 0.0F, shape.dashPx};
    auto found = std::ranges::find(paths, look, &LookPath::look);
    if (found == paths.end()) found = paths.insert(paths.end(), {look, {}, {}});
    appendShape(shape, static_cast<double>(reachPx), *found);
  };
  for (const OverlayShape& shape : overlayOf(scene, layout)) eachShownPiece(shape, layout.view, picture, write);
  for (const LookPath& path : paths) {
    const Look& look = path.look;
    const std::uint32_t rgb = (look.rgba & 0xFFU) << 16U | (look.rgba & 0xFF00U) | (look.rgba >> 16U & 0xFFU);
    const std::string paint = look.stroke ? "stroke" : "fill";
    svg += std::string("<path ") + (look.stroke ? "fill=\"none\" " : "") + paint + "=\"" + hexColor(rgb) + "\"";
    if (look.rgba >> 24U < 255U) svg += " " + paint + "-opacity=\"" + number((look.rgba >> 24U) / 255.0) + "\"";
    if (look.stroke) svg += " stroke-width=\"" + number(static_cast<double>(look.widthPx)) + "\" stroke-linejoin=\"round\"";
    if (look.dashPx > 0) svg += " stroke-dasharray=\"" + number(static_cast<double>(look.dashPx)) + "\"";
    svg += " d=\"" + path.d + "\"/>\n";
  }
}

void writeText(const std::string& text, const Box2& box, std::string& svg) {
  const double ascent = static_cast<double>(barlow::kAscender) / barlow::kUnitsPerEm * kLabelFontSizePx;
  const double widthPx = textWidthPx(text, kLabelFontSizePx);
  svg += "<text x=\"" + number(box.center().x - widthPx / 2) + "\" y=\"" + number(box.min.y + ascent) +
         "\" textLength=\"" + number(widthPx) + "\" lengthAdjust=\"spacingAndGlyphs\">" + escaped(text) + "</text>\n";
}

void writePlate(const Box2& box, std::string& svg) {
  const Vec2 size = box.max - box.min;
  svg += "<rect x=\"" + number(box.min.x) + "\" y=\"" + number(box.min.y) + "\" width=\"" + number(size.x) + "\" height=\"" + number(size.y) + "\"/>\n";
}

void writeLabels(const Layout& layout, std::string& svg) {
  const auto eachText = [&](auto write) {
    for (const PlacedLine& line : layout.lines) {
      if (line.label && !line.text.empty()) write(line.text, *line.label, line.placement);
    }
    for (const PlacedHandle& handle : layout.others) {
      if (handle.arc && !handle.text.empty()) write(handle.text, handle.box, handle.placement);
    }
  };
  // A white rim keeps a text readable where it has to stand on extension lines; on the model, among figures and tiles, it takes a plate as well.
  svg += "<g fill=\"#fff\" fill-opacity=\"" + number(kPlateOpacity) + "\">\n";
  eachText([&](const std::string&, const Box2& box, PlacementKind placement) {
    if (placement == PlacementKind::kInside) writePlate(box.grown(kPlateMarginPx), svg);
  });
  svg +=
      "</g>\n"
      "<g font-family=\"Barlow, 'Barlow Medium', 'Roboto Condensed', 'Arial Narrow', Arial, sans-serif\" "
      "font-weight=\"500\" "
      "font-size=\"" +
      number(kLabelFontSizePx) +
      "\" fill=\"#12181f\" stroke=\"#fff\" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\">\n";
  eachText([&](const std::string& text, const Box2& box, PlacementKind) { writeText(text, box, svg); });
  svg += "</g>\n";
}

}  // namespace

std::string writeSvg(const Scene& scene, const Layout& layout, const std::string& title) {
  const View& view = layout.view;
  const std::string size = number(view.widthPx()) + "\" height=\"" + number(view.heightPx()) + "\"";
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + size + " viewBox=\"0 0 " +
                    number(view.widthPx()) + " " + number(view.heightPx()) + "\" role=\"img\">\n<title>" +
                    escaped(title) + "</title>\n<rect width=\"" + size + " fill=\"#fff\"/>\n";
  const ModelPicture picture = drawModelPicture(scene, view, kSamplesPerPx);
  writeTones(picture, svg);
  writeLines(scene, view, picture, svg);
  writeOverlay(scene, layout, picture, svg);
  writeLabels(layout, svg);
  return svg + "</svg>\n";
}

}  // namespace dimline
