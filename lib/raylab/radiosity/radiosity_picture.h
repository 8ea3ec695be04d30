#pragma once

#include "raylab/image/image.h"
#include "raylab/radiosity/radiosity_view.h"
#include "raylab/tracer/picture/eye_picture.h"

namespace raylab {

/// How the radiosity of a seen point is made of those of the patches.
enum class RadiosityShading {
    patches,   // that of its patch
    vertices,  // interpolated between the vertices of its patch (Gouraud)
    gather,    // computed at the point: what all patches send there, each behind one shadow ray
};

/// A solved scene from a camera: the radiance B / pi of the surface that each eye ray meets first. The solution does
/// not depend on the camera, so only this is done again when the camera moves.
Image radiosity_picture(const RadiosityView& view, const CameraFrame& frame, RadiosityShading shading,
                        const EyePictureOptions& options);

}  // namespace raylab
