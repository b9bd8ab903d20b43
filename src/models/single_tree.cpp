#include "models/models.h"
#include "models/tree_parts.h"

// One tree, as a landscape architect draws it (a stack of discs) or as it grows. The kind can be chosen only where the realistic one is
// shown: the schematic one makes no scope for it.

namespace dimline {

namespace {

Scene buildSingleTree(const Values& values) {
  Builder b;
  tree::drawTree(b, tree::treeFrom(values, 0, "", 7));
  return b.finish();
}

}  // namespace

ModelDefinition defineSingleTree() {
  tree::TreeDefaults oak;
  oak.stemHeight = 2.4;
  oak.trunkDiameter = 0.55;
  oak.crownHeight = 6.2;
  oak.crownWidth = 7.6;
  return {"single-tree", "Single tree", tree::treeParameters(oak), buildSingleTree};
}

}  // namespace dimline
