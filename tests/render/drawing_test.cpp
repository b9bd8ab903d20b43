#include <algorithm>
#include <cmath>
#include <cstdio>

#include <catch2/catch.hpp>

#include "placement/placer.h"
#include "render/drawing_lines.h"
#include "render/edge_lines.h"
#include "render/model_picture.h"
#include "render/svg_writer.h"
#include "silhouette/coverage_mask.h"
#include "silhouette/cpu_fields.h"
#include "support/scenes.h"

namespace dimline {
namespace {

Scene cubeScene() {
  Scene scene;
  test::addBox(scene, test::boxAt({-1, -1, -1}, {2, 2, 2}));
  finish(scene);
  return scene;
}

std::vector<DrawingLine> linesOf(const Scene& scene, const View& view) {
  std::vector<EdgeLine> edges;
  findEdgeLines(scene, edges);
  return drawingLines(edges, view, drawModelPicture(scene, view, 3.0));
}

std::size_t count(const std::vector<DrawingLine>& lines, LineWeight weight) {
  return static_cast<std::size_t>(
      std::count_if(lines.begin(), lines.end(), [&](const DrawingLine& line) { return line.weight == weight; }));
}

/// Whether some line runs from one point to the other, either way.
bool hasLine(const std::vector<DrawingLine>& lines, const Vec2& a, const Vec2& b, double tolerancePx = 1.5) {
  return std::any_of(lines.begin(), lines.end(), [&](const DrawingLine& line) {
    const auto near = [&](const Vec2& p, const Vec2& q) { return glm::length(p - q) < tolerancePx; };
    const Segment2& s = line.segment;
    return (near(s.start, a) && near(s.end, b)) || (near(s.start, b) && near(s.end, a));
  });
}

TEST_CASE("the picture sees what the coverage mask covers, the nearest first") {
  Scene scene = cubeScene();
  test::addBox(scene, test::boxAt({-3, -0.5, 2}, {4, 1, 0.5}));  // in front of the cube, to its left
  finish(scene);
  for (const bool orthographic : {false, true}) {
    Camera camera = test::orbitCamera({0, 0, 0}, 12, 25, 20);
    if (orthographic) camera.orthoHeightM = 8;
    const View view(camera, 300, 240, scene.bounds);
    const ModelPicture picture = drawModelPicture(scene, view, 1.0);
    const CoverageMask mask = coverageMask(scene, view);
    REQUIRE(picture.width == 300);
    REQUIRE(picture.height == 240);
    int differ = 0, first = 0, second = 0;
    for (int y = 0; y < 240; ++y) {
      for (int x = 0; x < 300; ++x) {
        const std::uint32_t seen = picture.seen[picture.at(x, y)];
        if ((seen != ModelPicture::kNothing) != mask.covered(x, y)) ++differ;
        if (seen == ModelPicture::kNothing) continue;
        (seen < 12 ? first : second) += 1;
        // The depth is where the pixel's ray meets the box: the two differ in the box that is hit, so compare with both.
        const double depthM = depthOf(view, static_cast<double>(picture.nearness[picture.at(x, y)]));
        CHECK(depthM > view.nearM());
        CHECK(depthM < view.farM());
      }
    }
    CHECK(differ <= 2);
    CHECK(first > 500);
    CHECK(second > 500);
    // The middle of the front box hides the cube behind it.
    const Vec2 middle = view.toScreen(Vec3(-0.5, 0, 2.5));
    CHECK(picture.seen[picture.at(static_cast<int>(middle.x), static_cast<int>(middle.y))] >= 12);
  }
}

TEST_CASE("what is a few pixels wide is not lost in its own outline") {
  const Scene scene = cubeScene();
  const auto seenFrom = [&](double distanceM) {
    return linesOf(scene, View(test::orbitCamera({0, 0, 0}, distanceM, 35, 25), 500, 500, scene.bounds));
  };
  CHECK(count(seenFrom(60), LineWeight::kOutline) == 6);  // 20 px wide
  const auto small = seenFrom(300);                       // 4 px wide
  CHECK(count(small, LineWeight::kOutline) == 0);
  CHECK(small.size() >= 6);
}

TEST_CASE("a cube seen at a corner has six lines of outline and three within; three more are hidden") {
  const Scene scene = cubeScene();
  const View view(test::orbitCamera({0, 0, 0}, 9, 35, 25), 500, 500, scene.bounds);
  const auto lines = linesOf(scene, view);
  CHECK(lines.size() == 9);
  CHECK(count(lines, LineWeight::kOutline) == 6);
  CHECK(count(lines, LineWeight::kEdge) == 3);
  // The nearest corner is +x +y +z; the farthest, whose edges are hidden, is the opposite one.
  const auto at = [&](double x, double y, double z) { return view.toScreen(Vec3(x, y, z)); };
  CHECK(hasLine(lines, at(1, 1, 1), at(-1, 1, 1)));
  CHECK(hasLine(lines, at(1, 1, 1), at(1, -1, 1)));
  CHECK(hasLine(lines, at(1, 1, 1), at(1, 1, -1)));
  CHECK_FALSE(hasLine(lines, at(-1, -1, -1), at(1, -1, -1)));
  CHECK_FALSE(hasLine(lines, at(-1, -1, -1), at(-1, 1, -1)));
  CHECK_FALSE(hasLine(lines, at(-1, -1, -1), at(-1, -1, 1)));
}

TEST_CASE("what stands behind a wall has no lines") {
  Scene scene;
  test::addBox(scene, test::boxAt({-5, -5, 2}, {10, 10, 0.1}));
  finish(scene);
  const View view(test::orbitCamera({0, 0, 0}, 20, 5, 5), 400, 400, scene.bounds);
  const std::size_t alone = linesOf(scene, view).size();
  test::addBox(scene, test::boxAt({-1, -1, -1}, {2, 2, 2}));
  finish(scene);
  CHECK(linesOf(scene, view).size() == alone);
}

TEST_CASE("in parallel projection a drawing is the same however far the eye is") {
  // A step of a thousandth of the model's size hides the edge behind it.
  Scene scene = cubeScene();
  test::addBox(scene, test::boxAt({-0.5, -0.5, 0.9}, {1, 1, 0.105}));
  finish(scene);
  const auto seenFrom = [&](double distanceM) {
    Camera camera = test::orbitCamera({0, 0, 0}, distanceM, 25, 20);
    camera.orthoHeightM = 4;
    return linesOf(scene, View(camera, 600, 600, scene.bounds));
  };
  const std::vector<DrawingLine> near = seenFrom(0.5);
  REQUIRE(near.size() >= 9);
  for (const double distanceM : {6.0, 60.0, 2000.0}) {
    const std::vector<DrawingLine> far = seenFrom(distanceM);
    INFO(distanceM << " m");
    CHECK(far.size() == near.size());
    for (const DrawingLine& line : far) CHECK(hasLine(near, line.segment.start, line.segment.end));
  }
}

TEST_CASE("half hidden lines end where they go behind") {
  Scene scene = cubeScene();
  test::addBox(scene, test::boxAt({-4, -4, 3}, {4, 8, 0.1}));  // hides the left half
  finish(scene);
  Camera camera;
  camera.eye = {0, 0, 30};
  camera.target = {0, 0, 0};
  camera.orthoHeightM = 10;
  const View view(camera, 500, 500, scene.bounds);
  const auto lines = linesOf(scene, view);
  const auto at = [&](double x, double y) { return view.toScreen(Vec3(x, y, 1)); };
  CHECK(hasLine(lines, at(0, 1), at(1, 1)));
  CHECK(hasLine(lines, at(0, -1), at(1, -1)));
  CHECK_FALSE(hasLine(lines, at(-1, 1), at(1, 1)));
}

TEST_CASE("where one part runs into another there is a line, though neither has an edge there") {
  Scene scene;
  test::addBox(scene, test::boxAt({-4, -1, -4}, {8, 1, 8}));      // a slab, its top at height 0
  test::addBox(scene, test::boxAt({-1, -0.5, -1}, {2, 2.5, 2}));  // a block sunk into it
  finish(scene);
  const View view(test::orbitCamera({0, 0, 0}, 16, 30, 35), 600, 600, scene.bounds);
  const auto lines = linesOf(scene, view);
  const auto at = [&](double x, double z) { return view.toScreen(Vec3(x, 0, z)); };
  // Found in the picture, so its ends are not exact.
  CHECK(hasLine(lines, at(-1, 1), at(1, 1), 2.5));
  CHECK(hasLine(lines, at(1, 1), at(1, -1), 2.5));
}

TEST_CASE("parts in one plane run on into each other") {
  Scene scene;
  for (int i = 0; i < 3; ++i) test::addBox(scene, test::boxAt({i * 2.0, 0, 0}, {2, 3, 1}));
  finish(scene);
  Camera camera;
  camera.eye = {3, 1.5, 30};
  camera.target = {3, 1.5, 0};
  camera.orthoHeightM = 6;
  const View view(camera, 400, 300, scene.bounds);
  const ModelPicture picture = drawModelPicture(scene, view, 3.0);
  // Without the boxes' own edges nothing is left to draw.
  CHECK(drawingLines({}, view, picture).empty());
}

// --- The document --------------------------------------------------------------------------------------------------------

struct Drawing {
  Scene scene;
  Layout layout;
  std::string svg;
};

Drawing drawingOf(const Camera& camera, const std::string& title) {
  const auto model = makeModel(test::boxWithDoor());
  REQUIRE(model.ok());
  const Values values(model->parameters());
  Drawing drawing;
  drawing.scene = model->definition.build(values);
  const View view(camera, 700, 500, drawing.scene.bounds);
  CpuFields producer;
  producer.setScene(drawing.scene);
  DistanceFields fields;
  producer.produce(view, fields);
  Placer placer;
  placer.setScene(*model, drawing.scene);
  placer.place(view, fields, values, drawing.layout);
  drawing.svg = writeSvg(drawing.scene, drawing.layout, title);
  return drawing;
}

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

/// Checks that tags are closed in the order in which they were opened, and that no bare & or < stands in between.
bool wellFormed(const std::string& xml) {
  std::vector<std::string> open;
  std::size_t i = 0;
  while (i < xml.size()) {
    if (xml[i] == '&') {
      const std::size_t end = xml.find(';', i);
      if (end == std::string::npos || end - i > 6) return false;
    }
    if (xml[i] != '<') {
      ++i;
      continue;
    }
    const std::size_t end = xml.find('>', i);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(i + 1, end - i - 1);
    if (occurrences(tag, "\"") % 2 != 0 || tag.find('<') != std::string::npos) return false;
    if (tag.starts_with("/")) {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else if (!tag.ends_with("/")) {
      open.push_back(tag.substr(0, tag.find(' ')));
    }
    i = end + 1;
  }
  return open.empty();
}

TEST_CASE("the document is whole, and shows each label once") {
  const Drawing drawing = drawingOf(test::orbitCamera({0, 2.5, 0}, 24, 35, 20), "Tom & Jerry's <box>");
  const std::string& svg = drawing.svg;
  CHECK(svg.starts_with(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"700\" height=\"500\" viewBox=\"0 0 700 500\""));
  CHECK(wellFormed(svg));
  CHECK(svg.find("<title>Tom &amp; Jerry's &lt;box&gt;</title>") != std::string::npos);
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(svg.find("inf") == std::string::npos);
  std::size_t labels = 0;
  for (const PlacedLine& line : drawing.layout.lines) {
    if (!line.label) continue;
    ++labels;
    CHECK(svg.find(">" + line.text + "</text>") != std::string::npos);
  }
  CHECK(labels >= 3);
  CHECK(occurrences(svg, "<text ") == labels);
  CHECK(occurrences(svg, "textLength=") == labels);
}

TEST_CASE("an angle is drawn as an arc with its legs and its text, a switch is not") {
  Drawing drawing = drawingOf(test::orbitCamera({0, 2.5, 0}, 24, 35, 20), "Box");
  PlacedHandle angle;
  angle.type = HandleType::kAngular;
  angle.text = "35 degrees";
  angle.box = {{100, 100}, {140, 117}};
  angle.arc = Arc{{0, 2, 3}, {1, 0, 0}, {0, 0, 1}, 2.0, 0.6};
  PlacedHandle flag;
  flag.text = "switched on";
  drawing.layout.others = {angle, flag};
  const std::string svg = writeSvg(drawing.scene, drawing.layout, "Box");
  CHECK(wellFormed(svg));
  CHECK(occurrences(svg, ">35 degrees</text>") == 1);
  CHECK(svg.find("switched on") == std::string::npos);
  // The arc and its halo are one stroke each, with a point every few pixels.
  CHECK(occurrences(svg, "L") > occurrences(drawing.svg, "L") + 70);
  CHECK(occurrences(svg, "M") < occurrences(drawing.svg, "M") + 12);

  // Behind the viewer it has no place in the picture.
  drawing.layout.others[0].arc->center = {0, 2, 200};
  const std::string behind = writeSvg(drawing.scene, drawing.layout, "Box");
  CHECK(occurrences(behind, "M") == occurrences(drawing.svg, "M"));
}

TEST_CASE("balls and an author's colour are drawn as such") {
  Drawing drawing = drawingOf(test::orbitCamera({0, 2.5, 0}, 24, 35, 20), "Box");
  CHECK(occurrences(drawing.svg, " 0 1 0 ") == 0);
  drawing.layout.lines[0].look = {HandleSkin::kSphere, std::array<std::uint8_t, 3>{18, 96, 171}};
  const std::string svg = writeSvg(drawing.scene, drawing.layout, "Box");
  CHECK(wellFormed(svg));
  // Two half circles a disc: two halos, two balls with their highlights.
  CHECK(occurrences(svg, " 0 1 0 ") == 12);
  CHECK(occurrences(svg, "=\"#1260ab\"") == 2);
}

TEST_CASE("where the model hides it, a line inside it is faint on paper too") {
  Drawing drawing = drawingOf(test::orbitCamera({0, 2.5, 0}, 24, 0, 5), "Box");
  Layout& layout = drawing.layout;
  PlacedLine line;
  line.placement = PlacementKind::kInside;
  // Along the ground behind the box and out of it on both sides.
  line.base = line.line = {{-8, 0.2, -3}, {8, 0.2, -3}};
  line.baseScreen = line.lineScreen = layout.view.toScreen(line.line);
  layout.lines = {line};
  const std::string crossing = writeSvg(drawing.scene, layout, "Box");
  CHECK(wellFormed(crossing));
  const auto faint = [](const std::string& svg) { return occurrences(svg, "stroke-opacity=\"0.35\""); };
  REQUIRE(faint(crossing) == 1);
  double fromX = 0, fromY = 0, toX = 0, toY = 0;
  const std::string path = crossing.substr(crossing.find("d=\"", crossing.find("stroke-opacity=\"0.35\"")));
  REQUIRE(std::sscanf(path.c_str(), "d=\"M%lf %lfL%lf %lf\"", &fromX, &fromY, &toX, &toY) == 4);
  CHECK(fromX == Approx(layout.view.toScreen(Vec3(-4, 0.2, 3)).x).margin(4));
  CHECK(toX == Approx(layout.view.toScreen(Vec3(4, 0.2, 3)).x).margin(4));

  layout.lines[0].line.start.z = layout.lines[0].line.end.z = 3.5;   // before the box
  layout.lines[0].lineScreen = layout.view.toScreen(layout.lines[0].line);
  CHECK(faint(writeSvg(drawing.scene, layout, "Box")) == 0);
}

TEST_CASE("a text on the model stands on a plate, below all texts; one outside does not") {
  Drawing drawing = drawingOf(test::orbitCamera({0, 2.5, 0}, 24, 35, 20), "Box");
  const auto plates = [](const std::string& svg) { return occurrences(svg, "<rect x="); };
  REQUIRE(drawing.layout.lines[0].placement != PlacementKind::kInside);
  REQUIRE(plates(drawing.svg) == 0);
  drawing.layout.lines[0].placement = PlacementKind::kInside;
  drawing.layout.lines[0].label = Box2{{100, 50}, {140, 67}};
  PlacedHandle angle;
  angle.type = HandleType::kAngular;
  angle.placement = PlacementKind::kInside;
  angle.text = "35 degrees";
  angle.box = {{200, 100}, {240, 117}};
  angle.arc = Arc{{0, 2, 3}, {1, 0, 0}, {0, 0, 1}, 2.0, 0.6};
  drawing.layout.others = {angle};
  const std::string svg = writeSvg(drawing.scene, drawing.layout, "Box");
  CHECK(wellFormed(svg));
  CHECK(plates(svg) == 2);
  CHECK(svg.find("<rect x=\"98\" y=\"48\" width=\"44\" height=\"21\"/>") != std::string::npos);
  CHECK(svg.rfind("<rect x=") < svg.find("<text "));
  drawing.layout.lines[0].label.reset();
  CHECK(plates(writeSvg(drawing.scene, drawing.layout, "Box")) == 1);
}

TEST_CASE("the same frame gives the same document") {
  const Camera camera = test::orbitCamera({0, 2.5, 0}, 24, 35, 20);
  CHECK(drawingOf(camera, "Box").svg == drawingOf(camera, "Box").svg);
}

TEST_CASE("a camera within the model, or turned away from it, still gives a document") {
  Camera inside;
  inside.eye = {0, 2, 0};
  inside.target = {1, 2, 1};
  CHECK(wellFormed(drawingOf(inside, "Inside").svg));
  Camera away;
  away.eye = {0, 2, 20};
  away.target = {0, 2, 40};
  const Drawing drawing = drawingOf(away, "Away");
  CHECK(wellFormed(drawing.svg));
  CHECK(occurrences(drawing.svg, "<text ") == 0);
}

}  // namespace
}  // namespace dimline
