#include "placement/base_lines.h"

namespace dimline {

namespace {

/// The line along `axis` at the given sides of the box (-1 and +1 its faces, 0 the middle), from the end that `sense` points away from.
BaseLine lineAlong(const Obb& scope, const AxisSense& along, std::array<int, 2> sides, int number, const Vec3& translate) {
  BaseLine line;
  line.number = number;
  line.otherAxes = {(along.axis + 1) % 3, (along.axis + 2) % 3};
  line.sides = sides;
  Vec3 from = translate;
  for (int i = 0; i < 2; ++i) from[line.otherAxes[static_cast<std::size_t>(i)]] += 0.5 + 0.5 * sides[static_cast<std::size_t>(i)];
  Vec3 to = from;
  (along.sense > 0 ? to : from)[along.axis] += 1.0;
  line.segment = {scope.at(from), scope.at(to)};
  return line;
}

}  // namespace

BaseLines baseLines(const Annotation& annotation, const Obb& scope) {
  BaseLines lines;
  const AxisSense along = axisOf(annotation.orient);
  if (along.axis < 0) return lines;
  if (annotation.type == HandleType::kLinearContour) {
    for (int i = 0; i < 4; ++i) {
      lines.push_back(lineAlong(scope, along, {(i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1}, i, annotation.translate));
    }
  } else if (annotation.type == HandleType::kLinearCenter) {
    lines.push_back(lineAlong(scope, along, {0, 0}, 0, annotation.translate));
  }
  return lines;
}

double meanLength(const BaseLines& lines) {
  if (lines.empty()) return 0.0;
  double sum = 0;
  for (const BaseLine& line : lines) sum += line.segment.length();
  return sum / static_cast<double>(lines.size());
}

}  // namespace dimline
