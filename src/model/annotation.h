#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "math/types.h"

namespace dimline {

/// How a parameter's base lines lie in a scope (paper 3.2 and figure 5), or which other handle it has (paper 5).
enum class HandleType {
  kLinearContour,
  kLinearCenter,
  kDiametric,
  kRadial,
  kSphericalDiametric,
  kSphericalRadial,
  kAngular,
  kBoolean,
  kRange
};

/// Direction of a base line: for linear types along a scope's axis (+y -y -x +x +z -z); for diametric, radial and angular the
/// sign is dropped and the axis counts (an arc turns about it, round the scope's origin, from the axis after it towards the one after that: about z
/// from x to y); for the spherical types, horizontal or vertical on screen.
enum class Orient { kUp, kDown, kLeft, kRight, kFront, kBack, kHorizontal, kVertical };

/// The plane on which a base line may slip out of the silhouette (paper 3.2 and 4).
enum class Slip { kScope, kObject, kBillboard, kNone };

/// Preferred place on screen, seen from the feature.
enum class Align { kNone, kTop, kBottom, kLeft, kRight, kTopLeft, kTopRight, kBottomLeft, kBottomRight };

enum class HandleEnds { kEnd, kBoth };
enum class HandleSkin { kArrow, kSphere };

/// What an author says about a parameter's handle; what is not said is as it stands here. It is written beside the parameter, as
///
///     @Handle(scope=Window, type=linear-contour, orient=up, slip=object, align=left, chained)
///
/// | property | values, the default first |
/// | --- | --- |
/// | scope | a name, as the model spells it; in double quotes where it has a comma or a bracket. Always to be given |
/// | type | linear-contour, linear-center, diametric, radial, spherical-diametric, spherical-radial, angular, boolean, range |
/// | orient | up, down, left, right, front, back; the spherical types: horizontal, vertical |
/// | slip | scope, object, billboard, none |
/// | align | none, top, bottom, left, right, top-left, top-right, bottom-left, bottom-right |
/// | chained, indirect | flags: off unless they are named |
/// | ends | end, both |
/// | min-length | pixels, a number |
/// | occlusion | true, false |
/// | skin | arrow, sphere |
/// | color | #rrggbb |
/// | translate | {x,y,z}, in scope sizes |
///
/// The case of words does not matter, that of names does. Other spellings that authors may know are read too (annotation.cpp lists them). The base lines of a round thing's edges are
/// those of its box, beside what is seen of it: its thickness is better measured by linear-center.
struct Annotation {
  std::string scope;                     ///< name of the scopes it measures; never empty after parsing
  HandleType type = HandleType::kLinearContour;
  Orient orient = Orient::kUp;
  Slip slip = Slip::kScope;
  Align align = Align::kNone;
  bool chained = false;
  bool indirect = false;                 ///< value and length differ: the length comes from the rebuilt scope (paper 5)
  HandleEnds ends = HandleEnds::kEnd;
  double minLengthPx = 0;                ///< hidden when shorter on screen
  bool occlusion = true;                 ///< hidden when the scope is hidden
  HandleSkin skin = HandleSkin::kArrow;
  std::optional<std::array<std::uint8_t, 3>> color;
  Vec3 translate{0.0};                   ///< moves the base lines, or an arc's centre, in scope sizes
};

struct ParsedAnnotation {
  Annotation annotation;
  std::vector<std::string> warnings;     ///< unknown property or value, each left out: what, where (line:column), what is allowed
};

/// Reads `@Handle(scope=Window, type=linear-contour, …)`. A syntax error, or no scope, is an Error that names line and column;
/// anything unknown is a warning and is left out.
Result<ParsedAnnotation> parseAnnotation(std::string_view text);

std::string_view name(HandleType type);   ///< as the annotation spells it: "linear-contour"
std::string_view name(Orient orient);
std::string_view name(Slip slip);
std::string_view name(Align align);

/// Whether the handle is a dimension line (the six types of paper figure 5) rather than an arc, a switch or a range.
bool isLine(HandleType type);
/// Whether it is a dimension line along an axis of its scope rather than across a circle or a ball.
bool isLinear(HandleType type);
/// Whether it is a dimension line across a ball.
bool isSpherical(HandleType type);

/// The scope axis (0 x, 1 y, 2 z) an orientation names and the sense along it; horizontal and vertical give no axis (-1).
struct AxisSense {
  int axis;
  double sense;
};
AxisSense axisOf(Orient orient);

}  // namespace dimline
