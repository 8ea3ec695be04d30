#pragma once

#include "raylab/scene/needs.h"

#include <optional>
#include <vector>

// The facts about objects that needs_of() establishes first, before it determines what lights and materials need.

namespace raylab {

/// How rays can interact with one object.
struct ObjectFacts {
    bool front_seen, back_seen;  // a ray that descends from an eye ray can hit that side
    bool clear;  // no ray that leaves a visible side of it hits it again: it is planar, or convex and seen from outside
};

/// The facts of each object of the scene.
std::vector<ObjectFacts> object_facts(const Scene& scene);

/// The closed objects that surely have the light inside and the viewer outside, and that occlude shadow rays from
/// outside. There is one list for each light.
std::vector<std::vector<std::size_t>> walls_around_lights(const Scene& scene);

/// The meshes that have a winding number about the light and not about the viewer: they are probably closed, and then
/// walls too.
std::vector<std::size_t> meshes_around(const Scene& scene, const Light& light);

/// The reason why a light needs no shadow rays in a scene whose only object is `object`; absent if it needs them.
std::optional<std::string> never_blocked(const Scene& scene, const ObjectFacts& object, const Light& light);

/// The object's name in messages: "sphere 3".
std::string name_of(const Scene& scene, std::size_t object);

}  // namespace raylab
