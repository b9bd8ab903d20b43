#include "render/svg_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <tuple>
#include <vector>

#include "core/constants.h"
#include "core/text.h"
#include "placement/barlow_advances.h"
#include "placement/text_metrics.h"
#include "render/drawing_lines.h"
#include "render/edge_lines.h"
#include "render/model_picture.h"
#include "render/overlay.h"
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
  for (const char c : text) {
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

std::uint32_t packed(const glm::vec4& color) {
  const auto byte = [](float v) { return static_cast<std::uint32_t>(std::lround(v * 255.0F)); };
  return byte(color.r) << 16U | byte(color.g) << 8U | byte(color.b);
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

std::vector<OverlayShape> overlayOf(const Layout& layout) {
  std::vector<OverlayLine> lines;
  for (const PlacedLine& placed : layout.lines) {
    OverlayLine line;
    line.line = placed.lineScreen;
    line.extensionStart = placed.extensionStart;
    line.extensionEnd = placed.extensionEnd;
    line.label = placed.label;
    line.indirect = placed.indirect;
    lines.push_back(line);
  }
  std::vector<OverlayShape> shapes;
  buildOverlay(lines, drawingTheme(), shapes);
  return shapes;
}

/// Shapes of one look become one path, in the order in which the looks first appear: halos stay below ink.
void writeOverlay(const Layout& layout, std::string& svg) {
  using Look = std::tuple<OverlayShape::Kind, std::uint32_t, float, float>;
  std::vector<std::pair<Look, std::string>> paths;
  for (const OverlayShape& shape : overlayOf(layout)) {
    const bool stroke = shape.kind == OverlayShape::Kind::kStroke;
    // Paper knows no soft rims: a halo ends where it has faded for the most part.
    const float reachPx = shape.halfWidthPx - kHaloFade * shape.softnessPx;
    const Look look{shape.kind, shape.rgba, stroke ? reachPx : 0.0F, shape.dashPx};
    auto found = paths.begin();
    while (found != paths.end() && found->first != look) ++found;
    if (found == paths.end()) found = paths.insert(paths.end(), {look, {}});
    const Vec2 start(shape.startPx), end(shape.endPx);
    if (stroke) {
      found->second += "M" + point(start) + "L" + point(end);
    } else {
      const Vec2 along = glm::normalize(end - start);
      const Vec2 across = Vec2(-along.y, along.x) * static_cast<double>(shape.halfWidthPx);
      found->second += "M" + point(start) + "L" + point(end + across) + "L" + point(end - across) + "Z";
    }
  }
  for (const auto& [look, path] : paths) {
    const auto& [kind, rgba, halfWidthPx, dashPx] = look;
    const bool stroke = kind == OverlayShape::Kind::kStroke;
    const std::uint32_t rgb = (rgba & 0xFFU) << 16U | (rgba & 0xFF00U) | (rgba >> 16U & 0xFFU);
    const std::string paint = stroke ? "stroke" : "fill";
    svg += std::string("<path ") + (stroke ? "fill=\"none\" " : "") + paint + "=\"" + hexColor(rgb) + "\"";
    if (rgba >> 24U < 255U) svg += " " + paint + "-opacity=\"" + number((rgba >> 24U) / 255.0) + "\"";
    if (stroke) svg += " stroke-width=\"" + number(2.0 * static_cast<double>(halfWidthPx)) + "\"";
    if (dashPx > 0) svg += " stroke-dasharray=\"" + number(static_cast<double>(dashPx)) + "\"";
    svg += " d=\"" + path + "\"/>\n";
  }
}

/// The angle's arc with an arrowhead at either end, and its two legs. Switches and choices are for the hand, not for paper, and are left out.
void writeArc(const Arc& arc, const View& view, std::string& svg) {
  constexpr int kPieces = 48;
  std::vector<Vec2> points;
  double lengthPx = 0;
  for (int i = 0; i <= kPieces; ++i) {
    const Vec3 world = arc.at(arc.angleRad * i / kPieces);
    if (!view.inFrontOfNear(world)) return;
    points.push_back(view.toScreen(world));
    if (i > 0) lengthPx += glm::length(points[static_cast<std::size_t>(i)] - points[static_cast<std::size_t>(i) - 1]);
  }
  if (!view.inFrontOfNear(arc.center)) return;
  const Vec2 center = view.toScreen(arc.center);
  std::string legs;
  for (const Vec2& end : {points.front(), points.back()}) {
    const double legPx = glm::length(end - center);
    if (legPx <= kExtensionGapPx) continue;
    const Vec2 along = (end - center) / legPx;
    legs += "M" + point(center + along * kExtensionGapPx) + "L" + point(end + along * kExtensionOvershootPx);
  }
  // The stroke ends inside the arrowheads, so that their tips stay sharp.
  const double headPx = std::min(kArrowLengthPx, 0.3 * lengthPx);
  std::string path;
  for (const Vec2& p : points) {
    const double fromEndPx = std::min(glm::length(p - points.front()), glm::length(p - points.back()));
    if (fromEndPx >= 0.5 * headPx) path += (path.empty() ? "M" : "L") + point(p);
  }
  const Theme theme = drawingTheme();
  const auto stroke = [&](const glm::vec4& color, double widthPx, const std::string& d) {
    svg += "<path fill=\"none\" stroke=\"" + hexColor(packed(color)) + "\" stroke-opacity=\"" +
           number(static_cast<double>(color.a)) + "\" stroke-width=\"" + number(widthPx) + "\" d=\"" + d + "\"/>\n";
  };
  stroke(theme.halo, 3.5, legs + path);
  if (!legs.empty()) stroke(theme.extension, 1, legs);
  stroke(theme.line, 1.25, path);
  svg += "<path fill=\"" + hexColor(packed(theme.line)) + "\" d=\"";
  // An arrowhead's axis is the chord that it covers.
  for (const bool atEnd : {false, true}) {
    const auto at = [&](std::size_t i) { return points[atEnd ? points.size() - 1 - i : i]; };
    std::size_t back = 1;
    while (back + 1 < points.size() && glm::length(at(back) - at(0)) < headPx) ++back;
    const Vec2 chord = at(back) - at(0);
    if (!(glm::length(chord) > 0)) continue;
    const Vec2 along = chord / glm::length(chord) * headPx;
    const Vec2 across = Vec2(-along.y, along.x) * (kArrowHalfWidthPx / kArrowLengthPx);
    svg += "M" + point(at(0)) + "L" + point(at(0) + along + across) + "L" + point(at(0) + along - across) + "Z";
  }
  svg += "\"/>\n";
}

void writeText(const std::string& text, const Box2& box, std::string& svg) {
  const double ascent = static_cast<double>(barlow::kAscender) / barlow::kUnitsPerEm * kLabelFontSizePx;
  const double widthPx = textWidthPx(text, kLabelFontSizePx);
  svg += "<text x=\"" + number(box.center().x - widthPx / 2) + "\" y=\"" + number(box.min.y + ascent) +
         "\" textLength=\"" + number(widthPx) + "\" lengthAdjust=\"spacingAndGlyphs\">" + escaped(text) + "</text>\n";
}

void writeLabels(const Layout& layout, std::string& svg) {
  // A white rim keeps a text readable where it has to stand on the model.
  svg +=
      "<g font-family=\"Barlow, 'Barlow Medium', 'Roboto Condensed', 'Arial Narrow', Arial, sans-serif\" "
      "font-weight=\"500\" "
      "font-size=\"" +
      number(kLabelFontSizePx) +
      "\" fill=\"#12181f\" stroke=\"#fff\" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\">\n";
  for (const PlacedLine& line : layout.lines) {
    if (line.label && !line.text.empty()) writeText(line.text, *line.label, svg);
  }
  for (const PlacedHandle& handle : layout.others) {
    if (handle.arc && !handle.text.empty()) writeText(handle.text, handle.box, svg);
  }
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
  writeOverlay(layout, svg);
  for (const PlacedHandle& handle : layout.others) {
    if (handle.arc) writeArc(*handle.arc, view, svg);
  }
  writeLabels(layout, svg);
  return svg + "</svg>\n";
}

}  // namespace dimline
