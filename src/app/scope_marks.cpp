#include "app/scope_marks.h"

#include "render/overlay_line.h"

namespace dimline {

void addEdges(const Obb& box, const View& view, const ScopeMark& mark, std::vector<OverlayEdge>& edges) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box.size[axis] > 0)) continue;
    const int first = (axis + 1) % 3;
    const int second = (axis + 2) % 3;
    for (int corner = 0; corner < 4; ++corner) {
      Vec3 from(0.0);
      from[first] = corner & 1;
      from[second] = corner >> 1;
      // A box without thickness has each of its edges once.
      if ((from[first] > 0 && !(box.size[first] > 0)) || (from[second] > 0 && !(box.size[second] > 0))) continue;
      Vec3 to = from;
      to[axis] = 1;
      const Segment edge{box.at(from), box.at(to)};
      if (!view.inFrontOfNear(edge)) continue;
      edges.push_back({view.toScreen(edge), endDepths(edge, view, mark.skinM), mark.shownHidden, mark.opacity});
    }
  }
}

}  // namespace dimline
