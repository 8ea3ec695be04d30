#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/tracer/picture/eye_picture.h"

// Ray casting: each eye ray shows the first surface it hits, and no ray goes on from there. Lighting proper begins in
// chapter 05; until then a light over the viewer's left shoulder has to do.

namespace raylab {

enum class FirstHitShading {
    light,    // the diffuse colour, darker the more the surface turns away from the light
    normals,  // the unit normal as a colour: (x, y, z) from -1..1 to red, green, blue in 0..1
};

/// The colour of the first surface along a ray, or the background's; `to_light` points to the light, of any length.
Color first_hit_color(const Scene& scene, const Accelerator& accelerator, const Ray& ray, FirstHitShading look,
                      const Vec3d& to_light);

/// The direction to the light over the viewer's left shoulder.
Vec3d shoulder_light(const CameraFrame& frame);

/// The scene as this camera sees it.
Image first_hit_picture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                        FirstHitShading look = FirstHitShading::light, const EyePictureOptions& options = {});

}  // namespace raylab
