#pragma once

#include "math/camera.h"
#include "placement/placer.h"
#include "silhouette/distance_fields.h"

namespace dimline {

/// All that a layout and the model under it cover on screen (px): silhouette, lines with extension lines and labels, other handles. `fields`: the model's
/// own, of the layout's view. Empty when nothing is to be seen.
Box2 coveredBox(const Layout& layout, const DistanceFields& fields);

/// The layout's camera, but with as much room on the left of all that is covered as on its right, and as much above as below, within reason. A camera that is fitted to a
/// model knows nothing of the lines, and these do not stand around it evenly. The eye stays where it is and turns, so that the same is seen from the same side
/// (an orthographic one is moved, which comes to the same). One that looks along an axis of the world stays as it is: a front view is one from right in front;
/// so does one from right above, which could not turn without turning the picture round.
Camera centred(const Layout& layout, const DistanceFields& fields);

/// centred() for a model that opens in `view`: its lines are placed once, as if they were the first, and are forgotten, so that the picture is the same whoever sets the camera.
Camera composed(const View& view, const DistanceFields& fields, const Scene& scene, const Values& values, Placer& placer);

/// The view's camera, but looking along a direction that is given in its own right, up and forward, as before centred(); as it looks when that one lies beyond the zenith, where left and right change places.
Camera lookingAlong(const Vec3& direction, const View& view);

/// For a camera of which nothing else is known: takes back what centred() may have done to a camera that looked at the middle of `bounds`, so that fitting it again leads to the same view. Cameras that
/// look elsewhere stay as they are.
Camera uncentred(const View& view, const Bounds& bounds);

}  // namespace dimline
