// The properties of the sea surface by which it changes light. Code that follows light asks for
// these, and not which surface it is.
#pragma once

namespace photic::medium {

/// Made once for a scene.
struct SurfaceTraits {
  /// From a direction light goes on in one direction on each side: points have mirror images, and
  /// straight ways lead through the surface. Else it scatters light.
  bool one_direction_each = true;
  /// A point of it leads light from anywhere to anywhere: it scatters in two dimensions. A surface
  /// that does neither scatters in a plane.
  bool leads_anywhere = false;
  bool isotropic = true;                 ///< alike to all sides, also in environments
  bool emits = false;                    ///< light at wavelengths of its own that a channel counts
  bool absorbs = false;                  ///< a part of the light that comes to it
  bool differs_in_environments = false;  ///< so that meetings with it are to be known
  bool denser_outside = false;           ///< the medium beyond it is the denser one
};

}  // namespace photic::medium
