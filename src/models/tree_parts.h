#pragma once

#include <string>
#include <vector>

#include "model/builder.h"
#include "model/parameter.h"

// What the models with trees are made of: one tree, out of a stem and a crown that need not be of one kind. Inner header of the tree models.
//
//        .-----.   ^
//      (  crown  ) | crown height          The stem is clear of branches; what goes on in the crown is the
//       `--. .--'  v                       leader. The crown touches its box on all six sides.
//          |s|     ^
//          |t|     | stem height
//         _|e|_    v
//
namespace dimline::tree {

enum class Kind { kOak, kBirch, kSpruce, kPalm };

struct Stem {
  Kind kind = Kind::kOak;  ///< what bark it has
  double height = 0, diameter = 0;
};

struct Crown {
  Kind kind = Kind::kOak;
  bool realistic = true;  ///< else a stack of discs on a dowel, as on an architect's model
  double height = 0, width = 0;
};

/// Names of the scopes that a tree makes for its parameters.
struct ScopeNames {
  std::string tree;     ///< all of it
  std::string foliage;  ///< the crown, where it is a realistic one
  std::string stem;
  std::string trunk;    ///< three stretches of the stem where it is as thick as its diameter says
  std::string crown;
};

struct Tree {
  Stem stem;
  Crown crown;
  std::uint32_t seed = 1;  ///< trees of one seed, kind and size are alike
  ScopeNames names;
};

/// Stands on the scope's origin.
void drawTree(Builder& b, const Tree& tree);

// --- Parameters ---------------------------------------------------------------------------------------------------------

/// The parameters of one tree, in the order of their definition.
enum TreeParameter : std::size_t { kRealistic, kKind, kStemHeight, kTrunkDiameter, kCrownHeight, kCrownWidth, kTreeParameterCount };

/// Where several trees have parameters of their own, `suffix` tells their names and scopes apart, and `group` keeps them together; else
/// both are empty.
struct TreeDefaults {
  std::string suffix, group;
  Kind kind = Kind::kOak;
  double stemHeight = 0, trunkDiameter = 0, crownHeight = 0, crownWidth = 0;
};
std::vector<Parameter> treeParameters(const TreeDefaults& defaults);

/// The tree whose parameters begin at `first`, with its scopes.
Tree treeFrom(const Values& values, std::size_t first, const std::string& suffix, std::uint32_t seed);

}  // namespace dimline::tree
