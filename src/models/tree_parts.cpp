#include "models/tree_parts.h"

#include <algorithm>
#include <cmath>

#include "core/power.h"
#include "models/tree_growth.h"
#include "models/vocabulary.h"

// Stems, crowns for show and the order of a tree's parts; tree_growth grows the realistic crowns.

namespace dimline::tree {

namespace {

/// What a stem looks like.
struct Bark {
  std::uint32_t srgb;
  Material::Pattern pattern;
  int ridges;        ///< around the stem
  double furrow;     ///< depth of the furrows between them, as a share of the radius
  double flare;      ///< width at the ground, as a share of the stem's
  double ringEvery;  ///< distance of rings along it (m), or 0
};

Bark barkOf(Kind kind) {
  switch (kind) {
    case Kind::kOak: return {0x6B5644, Material::Pattern::kPlain, 7, 0.11, 1.6, 0};
    case Kind::kBirch: return {0xE9E5DA, Material::Pattern::kPlain, 0, 0, 1.25, 0};
    case Kind::kSpruce: return {0x6E4A38, Material::Pattern::kPlain, 6, 0.06, 1.35, 0};
    case Kind::kPalm: return {0x9C8468, Material::Pattern::kPlain, 0, 0, 1.3, 0.24};
  }
  return {};
}

/// The section of a stem of diameter 1: round, or with ridges and furrows.
Ring stemSection(const Bark& bark) {
  if (bark.ridges == 0) return ellipseRing({0, 0}, Vec2(0.5), 10);
  Ring ring;
  for (int i = 0; i < 2 * bark.ridges; ++i) {
    const double a = 3.141592653589793 * i / bark.ridges, r = i % 2 == 0 ? 0.5 : 0.5 * (1 - bark.furrow);
    ring.emplace_back(r * std::cos(a), r * std::sin(a));
  }
  return ring;
}

/// A path up the stem and on along the leader, and how wide it is at each point, as a share of the diameter.
struct StemLine {
  std::vector<Vec3> path;
  std::vector<double> widths;
  void add(const Vec3& p, double width) {
    path.push_back(p);
    widths.push_back(width);
  }
};

/// Heights of the stem's box: from here on it is as wide as its diameter.
double flareHeight(const Stem& stem) { return std::min(0.22 * stem.height, 0.6); }

StemLine stemLine(const Stem& stem, const Bark& bark) {
  StemLine line;
  const double flare = flareHeight(stem);
  line.add({0, 0, 0}, bark.flare);
  line.add({0, flare * 0.35, 0}, 0.4 + 0.6 * (0.5 * (1 + bark.flare)));
  line.add({0, flare, 0}, 1);
  if (bark.ringEvery > 0) {
    const int rings = repeatCount(stem.height - flare, bark.ringEvery);
    for (int i = 0; i < rings; ++i) {
      const double y = flare + (stem.height - flare) * (i + 0.86) / rings;
      line.add({0, y, 0}, 0.86);
      line.add({0, flare + (stem.height - flare) * (i + 1) / rings, 0}, i + 1 < rings ? 1 : 0.98);
    }
  } else {
    line.add({0, stem.height, 0}, 0.98);
  }
  return line;
}

/// The dark patches of a birch: flat lenses on its bark.
void drawBirchMarks(Builder& b, const Stem& stem, std::uint32_t seed) {
  Random random(seed + 5);
  Builder::Surface marks;
  const double from = flareHeight(stem), radius = 0.5 * stem.diameter * std::cos(3.141592653589793 / 10);
  constexpr int kMarks = 26;
  for (int i = 0; i < kMarks; ++i) {
    // Each on one of the stem's ten flat sides, so that it lies on the bark.
    const double side = std::floor(random.real(0, 10)) + 0.5, a = side * 2 * 3.141592653589793 / 10;
    const double y = from + (stem.height - from) * (i + random.real(0.1, 0.7)) / kMarks;
    const double half = 0.5 * stem.diameter * std::sin(3.141592653589793 / 10) * random.real(0.55, 1.0), high = half * random.real(0.2, 0.45);
    const Vec3 out(std::cos(a), 0, -std::sin(a)), across(-std::sin(a), 0, -std::cos(a));
    const Vec3 middle = out * (radius + 0.004) + Vec3(0, y, 0);
    const auto first = static_cast<std::uint32_t>(marks.points.size());
    for (const Vec3& p : {middle - across * half, middle - Vec3(0, high, 0), middle + across * half, middle + Vec3(0, high, 0)}) {
      marks.points.push_back(p);
      marks.normals.push_back(out);
    }
    marks.triangles.push_back({first, first + 1, first + 2});
    marks.triangles.push_back({first, first + 2, first + 3});
  }
  Material m;
  m.color = linearFromSrgb(0x3A3430);
  m.twoSided = true;
  b.material(m);
  b.surface(marks);
}

void drawStem(Builder& b, const Tree& tree, const Growth& growth) {
  const Bark bark = barkOf(tree.stem.kind);
  StemLine line = stemLine(tree.stem, bark);
  for (std::size_t i = 0; i < growth.leader.size(); ++i) {
    const double t = static_cast<double>(i + 1) / static_cast<double>(growth.leader.size());
    line.add(growth.leader[i] + Vec3(0, tree.stem.height, 0), 0.98 + (growth.leaderEnd - 0.98) * power(t, 0.8));
  }
  Ring section = stemSection(bark);
  for (Vec2& p : section) p *= tree.stem.diameter;
  Builder::SweepOptions options;
  options.up = {0, 0, 1};
  options.creaseRad = 1.2;
  options.bendRad = bark.ringEvery > 0 ? 0 : 1.0;
  options.widths = line.widths;
  b.material(paint(b, bark.srgb, 0.95F, bark.pattern));
  b.sweep(section, line.path, options);
  if (tree.stem.kind == Kind::kBirch) drawBirchMarks(b, tree.stem, tree.seed);
}

/// Scope: a frame in which the limbs' places are.
void drawLimbs(Builder& b, const std::vector<Limb>& limbs, Kind kind) {
  b.material(paint(b, barkOf(kind).srgb, 0.95F));
  std::vector<double> widths;
  for (const Limb& limb : limbs) {
    const Vec3 way = limb.path[1] - limb.path[0];
    widths.clear();
    for (std::size_t i = 0; i < limb.path.size(); ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(limb.path.size() - 1);
      widths.push_back(limb.startRadius + (limb.endRadius - limb.startRadius) * t);
    }
    Builder::SweepOptions options;
    options.up = std::abs(way.y) > 0.8 * glm::length(way) ? Vec3(0, 0, 1) : Vec3(0, 1, 0);
    options.creaseRad = 2.2;
    options.bendRad = 0.6;
    options.widths = widths;
    b.sweep(ellipseRing({0, 0}, Vec2(1.0), limb.sides), limb.path, options);
  }
}

void drawLeaves(Builder& b, const Sprig& sprig, Kind kind) {
  for (std::size_t tone = 0; tone < kTones; ++tone) {
    Builder::Surface surface;
    for (const Leaf& leaf : sprig.leaves) {
      if (leaf.tone == tone) addLeaf(leaf, sprig.middle, surface);
    }
    Material m;
    m.color = linearFromSrgb(leafColor(kind, tone));
    m.roughness = 0.9F;
    m.pattern = Material::Pattern::kLeaves;
    m.twoSided = true;
    b.material(m);
    b.surface(surface);
  }
}

/// Scope: its origin in the middle of the crown's floor.
void drawCrown(Builder& b, Kind kind, const Growth& growth) {
  drawLimbs(b, growth.limbs, kind);
  std::vector<PartId> parts;
  for (const Sprig& sprig : growth.sprigs) {
    parts.push_back(b.part(Vec3(0.0), [&] {
      drawLimbs(b, sprig.limbs, kind);
      drawLeaves(b, sprig, kind);
    }));
  }
  const Obb crown = b.scope();
  const auto turned = [&](const Vec3& v) { return crown.axes[0] * v.x + crown.axes[1] * v.y + crown.axes[2] * v.z; };
  for (const SprigPlace& place : growth.places) {
    b.setScope({crown.origin + turned(place.at), {turned(place.axes[0]), turned(place.axes[1]), turned(place.axes[2])}, Vec3(0.0)});
    b.place(parts[place.sprig]);
  }
}

/// A dowel, and on it discs cut out of card.
void drawSchematic(Builder& b, const Tree& tree) {
  constexpr int kDiscs = 9;
  const double height = tree.crown.height, thick = height * 0.045;
  b.material(paint(b, 0xC9A87C, 0.8F));
  b.push([&] {
    b.translate({-0.5 * tree.stem.diameter, 0, -0.5 * tree.stem.diameter});
    b.scale({tree.stem.diameter, tree.stem.height, tree.stem.diameter});
    b.cylinder({20, 0.7});
    const double pin = std::min(0.3 * tree.stem.diameter, 0.3 * tree.crown.width);
    b.translate({0.5 * (tree.stem.diameter - pin), tree.stem.height, 0.5 * (tree.stem.diameter - pin)});
    b.scale({pin, height - 0.5 * thick, pin});
    b.cylinder({10, 0.7});
  });
  b.material(paint(b, 0xA9BF93, 0.85F));
  for (int i = 0; i < kDiscs; ++i) {
    // The lowest disc lies on the dowel, the uppermost one ends the crown.
    const double share = static_cast<double>(i) / (kDiscs - 1), y = tree.stem.height + share * (height - thick);
    const double around = std::cos((share - 0.375) * 2.25), radius = 0.5 * tree.crown.width * std::max(around, 0.12);
    b.push([&] {
      b.translate({0, y, 0});
      b.scale({0, thick, 0});
      b.extrudePolygon(ellipseRing({0, 0}, Vec2(radius), 40), Axis::kY, 0.5);
    });
  }
}

}  // namespace

void drawTree(Builder& b, const Tree& tree) {
  const double half = 0.5 * tree.crown.width, stem = tree.stem.height, top = stem + tree.crown.height, radius = 0.5 * tree.stem.diameter;
  nameBox(b, tree.names.tree, {-half, 0, -half}, {half, top, half});
  nameBox(b, tree.names.stem, {-radius, 0, -radius}, {radius, stem, radius});
  const double low = flareHeight(tree.stem);
  for (int i = 0; i < 3; ++i) nameBox(b, tree.names.trunk, {-radius, low + (stem - low) * i / 3, -radius}, {radius, low + (stem - low) * (i + 1) / 3, radius});
  nameBox(b, tree.names.crown, {-half, stem, -half}, {half, top, half});
  if (!tree.crown.realistic) {
    drawSchematic(b, tree);
    return;
  }
  nameBox(b, tree.names.foliage, {-half, stem, -half}, {half, top, half});
  const Growth growth = grow(tree.crown, tree.stem.diameter, tree.seed);
  drawStem(b, tree, growth);
  b.push([&] {
    b.translate({0, stem, 0});
    drawCrown(b, tree.crown.kind, growth);
  });
}

std::vector<Parameter> treeParameters(const TreeDefaults& d) {
  const auto group = [&](const char* own) { return d.group.empty() ? std::string(own) : d.group; };
  const auto title = [&](const char* own) { return d.suffix.empty() ? std::string(own) : own + (" " + d.suffix); };
  const auto handle = [&](const char* scope, const std::string& rest) { return "@Handle(scope=" + (scope + d.suffix) + ", " + rest + ")"; };
  // A tree has no sides: its heights turn with the viewer (paper 3.1, principle 3). In a row such lines would lead straight across the other trees: there they keep to
  // the planes along the row and across it.
  const std::string slip = d.suffix.empty() ? "billboard" : "scope";
  std::vector<Parameter> p(kTreeParameterCount);
  p[kRealistic] = switchParameter("Realistic" + d.suffix, title("Realistic"), true,
      {group("Tree"), "A grown tree with bark and leaves, or the stack of discs that stands for one on an architect's model.",
       handle("Tree", "type=boolean, orient=up")});
  // At the crown's middle: a side of its box is in the air beside a spruce, and behind the crown from elsewhere.
  p[kKind] = choiceParameter("Kind" + d.suffix, title("Kind"), static_cast<int>(d.kind), {"oak", "birch", "spruce", "palm"},
      {group("Tree"), "What kind of tree it is: this decides how it branches and what its leaves are like.",
       handle("Foliage", "type=range, orient=up, translate={0, -0.5, 0}")});
  p[kStemHeight] = lengthParameter("StemHeight" + d.suffix, title("Stem height"), {d.stemHeight, 1.5, 6, 0.1},
      {group("Stem"), "How high the stem is clear of branches, from the ground to the crown.",
       handle("Stem", "type=linear-contour, orient=up, slip=" + slip)});
  p[kTrunkDiameter] = lengthParameter("TrunkDiameter" + d.suffix, title("Trunk diameter"), {d.trunkDiameter, 0.2, 0.9, 0.05},
      {group("Stem"), "How thick the stem is above its roots.",
       handle("Trunk", "type=diametric, orient=up, slip=billboard")});
  p[kCrownHeight] = lengthParameter("CrownHeight" + d.suffix, title("Crown height"), {d.crownHeight, 3, 10, 0.1},
      {group("Crown"), "How high the crown is, from its lowest to its uppermost leaf.",
       handle("Crown", "type=linear-center, orient=up, slip=" + slip)});
  p[kCrownWidth] = lengthParameter("CrownWidth" + d.suffix, title("Crown width"), {d.crownWidth, 2.5, 10, 0.1},
      {group("Crown"), "How wide the crown is where it is widest.",
       handle("Crown", "type=diametric, orient=up, slip=scope")});
  return p;
}

Tree treeFrom(const Values& values, std::size_t first, const std::string& suffix, std::uint32_t seed) {
  const auto at = [&](TreeParameter p) { return values.at(first + p); };
  const auto kind = static_cast<Kind>(at(kKind));
  return {{kind, at(kStemHeight), at(kTrunkDiameter)},
          {kind, at(kRealistic) != 0, at(kCrownHeight), at(kCrownWidth)},
          seed,
          {"Tree" + suffix, "Foliage" + suffix, "Stem" + suffix, "Trunk" + suffix, "Crown" + suffix}};
}

}  // namespace dimline::tree
