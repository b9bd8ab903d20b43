#include <array>
#include <cmath>

#include "models/models.h"
#include "models/tree_parts.h"

// Three sets of a tree's parameters, and five trees: one of each set, and between neighbours a graft, which has the stem of the one and the crown
// of the other. They stand on a shallow arc, each turned to its middle, so that hardly two of their dimensions run the same way.
//
//      A     A|B     B     B|C     C

namespace dimline {

namespace {

constexpr std::array<const char*, 3> kSets = {"A", "B", "C"};
constexpr double kGap = 0.8;    // between two crowns (m)
constexpr double kBend = 0.04;  // rad: how much the row turns for a metre along it

tree::Tree graft(const tree::Tree& stock, const tree::Tree& scion, std::uint32_t seed) {
  tree::Tree grafted{stock.stem, scion.crown, seed, scion.names};
  grafted.names.stem = stock.names.stem;
  grafted.names.trunk = stock.names.trunk;
  return grafted;
}

Scene buildOmniTree(const Values& values) {
  const auto set = [&](std::size_t i, std::uint32_t seed) { return tree::treeFrom(values, i * tree::kTreeParameterCount, kSets[i], seed); };
  const tree::Tree a = set(0, 7), b = set(1, 21), c = set(2, 4);
  const tree::Tree row[] = {a, graft(a, b, 12), b, graft(b, c, 30), c};

  double length = -kGap;
  for (const tree::Tree& t : row) length += t.crown.width + kGap;
  Builder builder;
  double at = -0.5 * length;
  for (const tree::Tree& t : row) {
    // Along a circle that touches the x axis in the middle of the row and comes to the front at both ends.
    const double angle = (at + 0.5 * t.crown.width) * kBend;
    builder.push([&] {
      builder.translate({std::sin(angle) / kBend, 0, (1 - std::cos(angle)) / kBend});
      builder.rotate(Axis::kY, -angle);
      tree::drawTree(builder, t);
    });
    at += t.crown.width + kGap;
  }
  return builder.finish();
}

}  // namespace

ModelDefinition defineOmniTree() {
  std::array<tree::TreeDefaults, 3> sets;
  sets[0] = {"A", "Tree A", tree::Kind::kOak, 2.2, 0.55, 5.0, 5.6};
  sets[1] = {"B", "Tree B", tree::Kind::kSpruce, 1.6, 0.4, 7.6, 4.4};
  sets[2] = {"C", "Tree C", tree::Kind::kBirch, 2.8, 0.35, 5.8, 4.2};
  ModelDefinition definition{"omni-tree", "Omni tree", {}, buildOmniTree};
  for (const tree::TreeDefaults& d : sets) {
    for (Parameter& p : tree::treeParameters(d)) definition.parameters.push_back(std::move(p));
  }
  return definition;
}

}  // namespace dimline
