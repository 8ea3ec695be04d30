#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/tracer/eye_picture.h"

// Ray casting: each eye ray shows the first surface it meets, and no ray goes on from there. Lighting proper begins in
// chapter 05; until then a lamp over the viewer's left shoulder has to do.

namespace raylab {

enum class FirstHitLook {
    lamp,     // the diffuse colour, darker the more the surface turns away from the lamp
    normals,  // the unit normal as a colour: (x, y, z) from -1..1 to red, green, blue in 0..1
};

/// The colour of the first surface along a ray, or the background's; `to_lamp` points to the lamp, of any length.
Color first_hit_color(const Scene& scene, const Accelerator& accelerator, const Ray& ray, FirstHitLook look,
                      const Vec3d& to_lamp);

/// The direction to the lamp over the viewer's left shoulder.
Vec3d shoulder_lamp(const CameraFrame& frame);

/// The scene as this camera sees it.
Image first_hit_picture(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                        FirstHitLook look = FirstHitLook::lamp, const EyePictureOptions& options = {});

}  // namespace raylab
