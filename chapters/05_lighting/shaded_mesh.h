#pragma once

#include "raylab/experiment/measure/method.h"
#include "raylab/geometry/shapes.h"

#include <cstdint>
#include <functional>
#include <vector>

// How bright is a point of a mesh that approximates a smooth surface? Light and viewer are infinitely far away, so
// brightness depends on the normal alone, and all its errors come from the choice of the normal.

namespace raylab::lighting {

/// The constants of README (5), for one channel.
struct Lighting {
    Vec3d to_light, to_viewer;  // of length 1
    double ambient = 0.1, diffuse = 0.6, specular = 0.5, shininess = 20;
};

/// The brightness of a surface with this unit normal.
double brightness(const Lighting& lighting, const Vec3d& normal);

/// The same with the highlight by true_highlight(): a truth that does not depend on the slot.
double true_brightness(const Lighting& lighting, const Vec3d& normal);

struct ShadedMesh {
    Mesh mesh;  // with vertex normals
    Lighting lighting;
};

/// A point of a mesh: its triangle, and the weights of the second and third vertex.
struct MeshPoint {
    std::size_t face;
    double u, v;
};

using ShadingMethod = Method<ShadedMesh, MeshPoint, double>;
using ShadingWorkload = Workload<ShadedMesh, MeshPoint>;  // of one mesh

/// Flat: lighting is computed once for each triangle. Gouraud: once for each vertex. Phong: at every point, with the
/// normal normalised or, a frequent mistake, not. What is computed once is part of the answer and not of the
/// preparation, because it has to be repeated for every light and view.
std::vector<ShadingMethod> shading_methods();

/// Phong's, as gouraud_and_phong() does it at one hit alone.
ShadingMethod shading_at_a_hit(const std::string& name);

/// A smooth surface that meshes approximate, seen along -z.
struct SmoothSurface {
    std::string name, about;
    std::function<Mesh(int level)> mesh;              // level 1 is the coarsest
    std::function<Vec3d(double x, double y)> normal;  // the exact unit normal where the surface is visible at (x, y)
    double reach;                                     // the largest |x| and |y|
    Lighting lighting;
};

/// A matte sphere, a shiny sphere, a shiny torus.
std::vector<SmoothSurface> smooth_surfaces();

struct SeenAt {
    double x, y;
};

/// This many places where a surface is visible, except near its rim, which meshes do not reach.
std::vector<SeenAt> seen_places(const SmoothSurface& surface, std::size_t count, std::uint64_t seed);

/// The surface's mesh of one level, and its points that are visible at these places.
ShadingWorkload workload(const SmoothSurface& surface, int level, const std::vector<SeenAt>& places);

/// The exact surface's brightness at these places.
std::vector<double> truth(const SmoothSurface& surface, const std::vector<SeenAt>& places);

}  // namespace raylab::lighting
