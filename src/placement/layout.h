#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/fixed_vector.h"
#include "math/camera.h"
#include "model/model.h"
#include "silhouette/distance_fields.h"

namespace dimline {

/// Where a final line lies: outside the silhouette, on another line's guide, or (the fallback) on its base line.
enum class PlacementKind : std::uint8_t { kOutside, kGuide, kInside };

/// Which sort of plane a line lies on, and how that plane is turned to the viewer (paper 4.2, term Plane).
enum class PlaneKind : std::uint8_t { kNone, kScope, kBillboard, kObject };
enum class Facing : std::uint8_t { kNone, kFront, kBack };

/// Why an annotated parameter shows no handle. Out of view, or occluded: what it measures is so as a whole, or in part, and its line would run across others.
enum class HiddenReason : std::uint8_t { kOccluded, kOutOfView, kTooShort, kForeshortened, kCrowded, kNoScope };

/// What makes a candidate the same one in two frames: for damping, animation and hysteresis. Of a handle that is no line, `plane` is the direction in which it
/// stands off its anchor, or in which an arc opens; `baseLine` and `direction` mean nothing.
struct Identity {
  std::int32_t parameter = -1;
  std::int32_t scopeIndex = -1;   ///< among the scopes of the annotation's name; -1 for a chain as a whole
  std::int32_t chain = -1;        ///< number of the chain's cluster; -1 for a line of its own
  std::int16_t baseLine = -1;     ///< which of the scope's base lines; of a chain, which side of its rectangle
  std::int16_t plane = -1;        ///< which of the base line's planes; -1 on the base line itself
  std::int8_t direction = 0;      ///< +1 or -1 along that plane's slide direction, 0 on the base line itself
  bool operator==(const Identity&) const = default;
};

/// What its author wants a line to look like.
struct LineLook {
  HandleSkin skin = HandleSkin::kArrow;
  std::optional<std::array<std::uint8_t, 3>> color;   ///< sRGB, in place of the theme's
};

/// Where the text of a line is: riding on the line, beyond one of its ends, or beside it, away from the model or towards it. It means
/// the same when the line has moved or has become longer.
struct LabelPlace {
  enum class Side : std::uint8_t { kOnLine, kBeyondEnd, kBeyondStart, kOutward, kInward };
  Side side = Side::kOnLine;
  std::int8_t eighth = 0;        ///< how far from the line's middle towards its end, of the way that there is
  bool overExtensions = false;   ///< extension lines may run under it: the same place all the same
  bool operator==(const LabelPlace& o) const { return side == o.side && eighth == o.eighth; }
};

/// One end of a line that can be dragged.
struct Handle {
  bool atEnd = true;   ///< the moving end, or else the start
  Vec2 screen{0.0};    ///< the arrowhead's tip, or a pill's middle (px)
  bool operator==(const Handle&) const = default;
};

/// A polyline, px, from an end of the base line by way of its foot on the plane, where there is another, and of a jog (jogs.h), where there is one, to that of the final line.
using ExtensionLine = FixedVector<Vec2, 4>;

/// One dimension line as it is to be shown.
struct PlacedLine {
  std::size_t parameter = 0;      ///< index into the model's parameters
  std::size_t scope = 0;          ///< index into Scene::scopes
  Identity identity;
  HandleType type = HandleType::kLinearContour;
  PlacementKind placement = PlacementKind::kInside;
  PlaneKind planeKind = PlaneKind::kNone;
  Facing facing = Facing::kNone;
  Plane plane;                    ///< meaningless when planeKind is kNone
  Segment base;                   ///< world, fixed end first
  Segment foot;                   ///< world, the base line on the plane, where extension lines bend; the base line itself where they don't
  Segment line;                   ///< world, parallel to base
  Segment2 baseScreen;
  Segment2 lineScreen;
  /// From the base line's ends to the final line's. Empty when inside.
  ExtensionLine extensionStart;
  ExtensionLine extensionEnd;
  std::int32_t chain = -1;        ///< equal for the members of one chain, different between chains; -1 for a line of its own
  bool indirect = false;          ///< drawn stippled
  LineLook look;
  double lengthM = 0;             ///< of the base line, in the world
  double value = 0;               ///< the parameter's value
  std::string text;               ///< what the label says
  std::optional<Box2> label;      ///< px; empty when there is no room
  LabelPlace labelPlace;          ///< meaningless without a label
  FixedVector<Handle, 2> handles;
};

/// The arc of an angular handle in the world: it begins at center + from * radiusM and turns about `axis` by angleRad, counter-clockwise seen against it.
struct Arc {
  Vec3 center{0.0};
  Vec3 from{1, 0, 0};    ///< unit length
  Vec3 axis{0, 0, 1};    ///< unit length, at right angles to `from`
  double radiusM = 0;
  double angleRad = 0;

  [[nodiscard]] Vec3 at(double rad) const;
  bool operator==(const Arc&) const = default;
};

/// One choice of a range handle, and where it is offered when the handle is open.
struct RangeOption {
  double value = 0;
  std::string text;
  Box2 box;              ///< px
  bool operator==(const RangeOption&) const = default;
};

/// A handle that is no line: an arc for an angle, a switch, the choices of a range (paper 5, figures 18 and 23).
struct PlacedHandle {
  std::size_t parameter = 0;
  std::size_t scope = 0;           ///< index into Scene::scopes
  Identity identity;
  HandleType type = HandleType::kBoolean;
  PlacementKind placement = PlacementKind::kInside;
  double value = 0;
  std::string text;
  Vec2 anchor{0.0};                ///< px, the point of the feature that the handle belongs to; a thread runs from there to the handle when it is outside
  Box2 box;                        ///< px, all that it covers; of an arc its label's box
  std::optional<Arc> arc;          ///< of an angular handle
  FixedVector<Handle, 1> handles;  ///< what can be taken hold of
  std::vector<RangeOption> options;
};

struct HiddenParameter {
  std::size_t parameter = 0;
  HiddenReason reason = HiddenReason::kNoScope;
};

/// The plain-data result of one frame. Every annotated parameter is in exactly one of lines, others and hidden; the
/// members of a chain are several lines of one parameter.
struct Layout {
  View view;
  std::vector<PlacedLine> lines;
  std::vector<PlacedHandle> others;
  std::vector<HiddenParameter> hidden;
  std::vector<std::size_t> visibleScopes;   ///< indices into Scene::scopes
};

/// As the JSON spells them.
std::string_view name(PlacementKind kind);
std::string_view name(PlaneKind kind);
std::string_view name(Facing facing);
std::string_view name(HiddenReason reason);

/// "WindowWidth/3/-/1/0/+": equal in two frames exactly when the identities are.
std::string identityText(const Identity& identity, std::span<const Parameter> parameters);

}  // namespace dimline
