#pragma once

#include "raylab/geometry/method.h"
#include "raylab/geometry/shapes.h"

#include <cstdint>
#include <functional>
#include <vector>

// How bright is a point of a mesh that stands for a smooth surface? Light and viewer are infinitely far, so brightness
// depends on the normal alone, and all that is wrong with it comes from where normals are taken.

namespace raylab::lighting {

/// README (5), in one channel.
struct Lighting {
    Vec3d to_light, to_viewer;  // unit
    double ambient = 0.1, diffuse = 0.6, specular = 0.5, shininess = 20;
};

/// The brightness of a surface with this unit normal.
double brightness(const Lighting& lighting, const Vec3d& normal);

/// The same, with the highlight by true_highlight(): a truth that the slot has no part in.
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

/// Flat: light reckoned once a triangle. Gouraud: once a vertex. Phong: at every point, with the normal made unit again
/// or, a frequent mistake, not. What is reckoned once is part of the answer: it is done anew for every light and view.
std::vector<ShadingMethod> shading_methods();

/// A smooth surface that meshes stand for, seen along -z.
struct SmoothSurface {
    std::string name, about;
    std::function<Mesh(int level)> mesh;              // level 1 is the coarsest
    std::function<Vec3d(double x, double y)> normal;  // exact, unit, where the surface is seen at (x, y)
    double reach;                                     // |x| and |y| at most
    Lighting lighting;
};

/// A matte sphere, a shiny sphere, a shiny torus.
std::vector<SmoothSurface> smooth_surfaces();

struct SeenAt {
    double x, y;
};

/// Places where a surface is seen, as many as wanted, but for its rim, which meshes do not reach.
std::vector<SeenAt> seen_places(const SmoothSurface& surface, std::size_t count, std::uint64_t seed);

/// The surface's mesh of one level, and its points that are seen at these places.
ShadingWorkload workload(const SmoothSurface& surface, int level, const std::vector<SeenAt>& places);

/// The exact surface's brightness at these places.
std::vector<double> truth(const SmoothSurface& surface, const std::vector<SeenAt>& places);

}  // namespace raylab::lighting
