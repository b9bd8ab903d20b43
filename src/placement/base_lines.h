#pragma once

#include "core/fixed_vector.h"
#include "math/camera.h"
#include "model/annotation.h"

namespace dimline {

/// Where a dimension would be on the object itself (paper 3.2 and figure 5), fixed end first.
struct BaseLine {
  Segment segment;
  /// Which of the scope's base lines this is; the same line of the same scope keeps its number over frames and rebuilds.
  int number = 0;
  /// The box's two other axes (0 to 2), and on which side of the box's middle the line lies along each: -1, 0 (in the middle) or +1.
  std::array<int, 2> otherAxes{1, 2};
  std::array<int, 2> sides{0, 0};
};

/// At most four a scope.
using BaseLines = FixedVector<BaseLine, 4>;

/// The base lines of a scope. Plain geometry: whether a line is in view is for the caller to find out.
///
/// linear-contour: the four edges along the axis, numbered 0 to 3 by the two other axes' sides. linear-center: one through the middle.
/// Other types have none yet and give an empty result. `annotation.translate` moves them, in sizes of the scope.
BaseLines baseLines(const Annotation& annotation, const Obb& scope);

/// Mean world length (m) of a scope's base lines; 0 without any. By it parameters are ordered (paper 4.5).
double meanLength(const BaseLines& lines);

}  // namespace dimline
