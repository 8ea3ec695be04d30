#pragma once

#include "raylab/scene/needs.h"

#include <optional>
#include <vector>

// What needs_of() finds out first, about objects, before it asks what lights and materials need.

namespace raylab {

/// What rays can have to do with one object.
struct ObjectFacts {
    bool front_seen, back_seen;  // a ray that follows from an eye ray can meet that side
    bool clear;  // no ray that leaves a seen side of it meets it again: planar, or convex and from outside
};

/// Of each object of the scene.
std::vector<ObjectFacts> object_facts(const Scene& scene);

/// The closed objects that surely have the light inside and the viewer outside, and that stop shadow rays from outside.
/// One list for each light.
std::vector<std::vector<std::size_t>> walls_around_lights(const Scene& scene);

/// The meshes that wind about the light and not about the viewer: probably closed ones, and then walls too.
std::vector<std::size_t> meshes_around(const Scene& scene, const Light& light);

/// Why a light needs no shadow rays in a scene whose only object is `object`; absent: it needs them.
std::optional<std::string> never_blocked(const Scene& scene, const ObjectFacts& object, const Light& light);

/// "sphere 3", as people know the object.
std::string name_of(const Scene& scene, std::size_t object);

}  // namespace raylab
