#pragma once

#include <cstdint>
#include <vector>

#include "math/camera.h"
#include "render/edge_lines.h"
#include "render/model_picture.h"

namespace dimline {

/// How heavy a line of a drawing is: the outline of the whole, the outline of a part in front of another, an edge within a part, a fine detail.
enum class LineWeight : std::uint8_t { kOutline, kContour, kEdge, kDetail };

struct DrawingLine {
  Segment2 segment;  ///< px
  LineWeight weight = LineWeight::kEdge;
};

/// The lines of a drawing: the stretches of the edges that can be seen, hidden lines removed by the picture's depths; and where one part runs
/// into another without an edge of its own, the border between the two. What is shorter than a pixel or two, or would run together with
/// its neighbours, is left out.
std::vector<DrawingLine> drawingLines(const std::vector<EdgeLine>& edges, const View& view,
                                      const ModelPicture& picture);

}  // namespace dimline
