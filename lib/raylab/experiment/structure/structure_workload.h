#pragma once

#include "raylab/accelerator/trace_rays.h"
#include "raylab/scene/scene.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

// The queries for structures: scenes, and the four kinds of rays that a picture needs.

namespace raylab {

/// Rays through one scene.
struct StructureWorkload {
    std::string name;   // "bumpy sphere: camera"
    std::string about;  // one sentence that says what is special about the rays
    std::shared_ptr<const Scene> scene;
    RayQuestion question = RayQuestion::nearest;
    std::vector<Ray> rays = {};
};

/// A scene of a mesh, with a camera that sees all of it, and a light.
Scene mesh_scene(std::shared_ptr<const Mesh> mesh, const std::string& name);

/// Adds such a camera, a light, and materials where there are none, to a scene of any bounded objects.
void look_at_all(Scene& scene);

/// Rays of the scene's camera, row after row of a square picture.
StructureWorkload camera_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays);

/// Rays from the points that those hit, in random directions about the normal (as light leaves a diffuse surface).
StructureWorkload bounce_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays,
                              std::uint64_t seed);

/// Shadow rays from those points to the scene's lights.
StructureWorkload shadow_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays,
                              std::uint64_t seed);

/// Rays between random points of a box twice as wide as the scene.
StructureWorkload incoherent_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays,
                                  std::uint64_t seed);

/// Rays where rounding loses hits: at vertices, and along the axes exactly in the planes of boxes that end there. They
/// are not among the four below, because a picture has few of them.
StructureWorkload edge_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays,
                            std::uint64_t seed);

/// The first four kinds, with the given number of rays each. The scene must have a camera and a light.
std::vector<StructureWorkload> ray_workloads(const std::string& name, const std::shared_ptr<const Scene>& scene,
                                             std::size_t rays, std::uint64_t seed);

}  // namespace raylab
