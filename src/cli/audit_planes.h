#pragma once

#include <vector>

#include "math/camera.h"
#include "model/model.h"

// Where the audit has base lines slip: worked out anew, by nothing of src/placement.
namespace dimline {

/// "Plainly" so turned to the viewer: by so much more than the least that nobody could disagree.
inline constexpr double kPlainlyMoreRad = 0.03;

/// A way out for a base line.
struct SlipWay {
  Segment from;               ///< the base line, moved onto the plane where that is an object plane
  Vec3 direction{0.0};        ///< unit length
  std::vector<Plane> within;  ///< a line on that way lies behind all of these, or has left what the plane has room for
};

/// A side or an end of the prism around a model's base lines (paper 4.4).
struct ObjectFace {
  Plane plane;
  Vec3 middle{0.0};
  double widthM = 0;  ///< on the ground, of a side; infinite for the ends
};

/// The convex hull, on the ground, of all base lines of the linear types, as high as the model. Empty when they lie in
/// one upright plane.
std::vector<ObjectFace> objectFaces(const Model& model, const Scene& scene);

/// The ways on which a base line may slip as its annotation says, both along each plane that is plainly not seen
/// edge-on. scope: along the scope's two other axes; of a diameter or a radius along the axis, and at right angles to
/// that; of a sphere's as billboard. billboard: at right angles to the view. object: along the faces to which the line
/// is parallel and that are wider than two planes taken for one are apart, as far as the faces turned the same way, to
/// the viewer or away, leave room. none: no way.
std::vector<SlipWay> slipWays(const Annotation& annotation, const Obb& scope, const Segment& base, const View& view,
                              const std::vector<ObjectFace>& object, double modelSizeM);

/// Whether a line has stayed where its way has room for it; rounding counts for nothing.
bool staysWithin(const SlipWay& way, const Segment& line, double modelSizeM);

/// A scope's base lines of the linear types: four edges along the axis, or the middle. None for other types.
std::vector<Segment> linearBaseLines(const Annotation& annotation, const Obb& scope);

}  // namespace dimline
