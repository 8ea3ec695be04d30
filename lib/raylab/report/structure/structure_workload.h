#pragma once

#include "raylab/accelerator/trace_rays.h"
#include "raylab/scene/scene.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

// What structures are asked: scenes, and the four kinds of rays that a picture casts.

namespace raylab {

/// Rays through one scene.
struct StructureWorkload {
    std::string name;   // "bumpy sphere: camera"
    std::string about;  // one sentence: what is special about the rays
    std::shared_ptr<const Scene> scene;
    RayQuestion question = RayQuestion::nearest;
    std::vector<Ray> rays = {};
};

/// A mesh to look at: a camera that sees all of it, and a lamp.
Scene mesh_scene(std::shared_ptr<const Mesh> mesh, const std::string& name);

/// The same for any objects with bounds, and materials where there are none.
void look_at_all(Scene& scene);

/// Rays of the scene's camera, row after row of a square picture.
StructureWorkload camera_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays);

/// What goes on from where those arrive, in random directions about the normal (as light leaves a diffuse surface).
StructureWorkload bounce_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays,
                              std::uint64_t seed);

/// From there to the scene's lights: whether anything is in the way.
StructureWorkload shadow_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays,
                              std::uint64_t seed);

/// Between random points of a box twice as wide as the scene.
StructureWorkload incoherent_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays,
                                  std::uint64_t seed);

/// Where rounding loses hits: at vertices, and along the axes in the very planes of boxes that end there. Not among the
/// four below: a picture has few of them.
StructureWorkload edge_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays,
                            std::uint64_t seed);

/// The first four, so many rays each. The scene has a camera and a light.
std::vector<StructureWorkload> ray_workloads(const std::string& name, const std::shared_ptr<const Scene>& scene,
                                             std::size_t rays, std::uint64_t seed);

}  // namespace raylab
