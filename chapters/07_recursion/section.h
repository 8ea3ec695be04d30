#pragma once

#include "raylab/report/plane/plane_sketch.h"
#include "raylab/scene/scene.h"
#include "raylab/tracer/whitted/whitted.h"

#include <string>
#include <vector>

// Rays in a section through a scene: x to the right, y up, in the plane z = 0, in which all of them stay.

namespace raylab::recursion {

/// The tree of the ray through the middle of the picture, to depth 4 and down to a throughput of 0.05.
RayTree section_tree(const Scene& scene);
/// The same if the camera looked at `target`.
RayTree section_tree_towards(Scene scene, const Vec3d& target);

/// How rays of a kind are drawn, in the section and in the tree: the colours and dashes of `raylab tree`.
PlaneStyle style_of(RayKind kind);

/// Adds what the plane z = 0 cuts of the scene: its shapes, lights and eye, each with its name.
void add_section(PlaneSketch& sketch, const Scene& scene);

/// Adds the rays of these nodes to their hits, each with its number, the first of which is 1. A shadow ray that is
/// blocked ends in a cross at its obstacle, and a ray that hits nothing after `reach` metres.
void add_rays(PlaneSketch& sketch, const Scene& scene, const RayTree& tree, const std::vector<std::size_t>& nodes,
              double reach);

/// The section with the rays of these nodes.
PlaneDrawing section_with_rays(const Scene& scene, const RayTree& tree, const std::vector<std::size_t>& nodes);

/// All rays of a pixel in the section, and beside it its ray tree: the same numbers and colours.
PlaneDrawing rays_beside_tree(const Scene& scene, const RayTree& tree);

/// What a node's ray found, in a word: the material's name, "sky", "lit", "blocked", or why it was not followed.
std::string word_for(const Scene& scene, const RayNode& node);

}  // namespace raylab::recursion
