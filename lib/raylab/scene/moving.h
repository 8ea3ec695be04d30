#pragma once

#include "raylab/geometry/containment.h"
#include "raylab/geometry/ray.h"
#include "raylab/scene/scene.h"

namespace raylab {

/// The times that rays of this scene may have: from the shutter's opening to its closing, and 0, at which Whitted's
/// rays see the scene as it is written.
Interval<float> ray_times(const std::optional<Shutter>& shutter);
inline Interval<float> ray_times(const Scene& scene) { return ray_times(scene.camera.shutter); }

/// How the object moves while rays pass; null: it rests, as everything does where the camera has no shutter.
inline const Motion* motion_of(const Scene& scene, const Object& object) {
    if (!object.motion) [[likely]]
        return nullptr;
    return scene.camera.shutter && *object.motion != Motion{} ? &*object.motion : nullptr;
}

/// Whether anything moves while rays pass.
bool anything_moves(const Scene& scene);

/// Where a region of space lies to the object, at all times of the rays alike: otherwise undecided.
Containment containment_always(const Scene& scene, const Object& object, const Region& region);

}  // namespace raylab
