#pragma once

#include "raylab/geometry/vector.h"

#include <span>

namespace raylab {

/// A point of a surface as the local model sees it.
struct LocalSurface {
    Vec3d normal, to_viewer;  // unit
    Vec3d unlit;              // the colour that it has without any light: its emission, and the ambient light's share
    Vec3d diffuse, specular;  // colours
    double shininess = 1;     // at least 0
};

/// A light that nothing hides from the point.
struct IncidentLight {
    Vec3d way;          // from the point to the light, as long as the light is far
    Vec3d color;        // beside the light
    Vec3d attenuation;  // c, l, q: at a distance d the colour is divided by c + l d + q d^2
};

/// The light that a point sends to the viewer by itself, and by what comes straight from these lights: for each the
/// diffuse and the specular term of Phong's model; nothing of a light that is not before the surface.
Vec3d local_color(const LocalSurface& surface, std::span<const IncidentLight> lights);

}  // namespace raylab
