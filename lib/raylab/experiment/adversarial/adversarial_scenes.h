#pragma once

#include "raylab/experiment/adversarial/adversarial.h"
#include "raylab/scene/scene.h"

#include <functional>
#include <string>
#include <vector>

// Scenes that are hard for accelerators. The tests and the differential tester draw from them.

namespace raylab::adversarial {

Object object(Shape shape, const Affine& placement = {});

/// A scene of one mesh, in which each triangle has corners of its own.
Scene scene_of(const std::vector<Triangle>& triangles);

/// Any transform that is not singular: with shear, with a scale that differs per axis, with a mirror.
Affine any_placement(Draw& draw);

/// Any velocity; of one in two the linear part changes, too. Whether that becomes singular is not asked.
Motion any_motion(Draw& draw);

/// From 0 to 1: the ends, shares that binary fractions cannot hold, and tiny ones.
float any_time(Draw& draw);
float any_time(Draw& draw, const Interval<float>& times);  // ... of this range

/// Whether the exact placement of that moment is singular.
bool is_singular_at(const Affine& placement, const Motion& motion, float time);

/// One that a scene file may hold: check_shape() has nothing against it. Not an annulus: what is counted of
/// any_shape()'s scenes was published before there was one.
Shape any_shape(Draw& draw);
Annulus any_annulus(Draw& draw);
Vec3f any_point(Draw& draw);
float any_radius(Draw& draw);
Sides any_sides(Draw& draw);
Object any_object(Draw& draw);
Scene any_scene(Draw& draw, int objects);

/// A flat floor of right triangles on integer coordinates, two for each cell.
std::vector<Triangle> floor_of(int cells);

std::vector<Triangle> soup(Draw& draw, std::size_t count, float half, const Vec3f& center = Vec3f(0));

/// A kind of scene. Each draw gives another scene.
struct SceneKind {
    std::string name;
    std::function<Scene(Draw&)> make;
};

/// Empty, single, flat, duplicate, degenerate, nested, far, tiny, huge, placed, unbounded and mixed scenes. Most are
/// small, so that many can be tested; one in ten has some hundred primitives.
const std::vector<SceneKind>& scene_kinds();

/// Scenes of sizes from 2^-126 to 2^100, mixed in one scene or all alike, and with transforms whose entries reach from
/// 2^-40 to 2^40.
const std::vector<SceneKind>& exponent_scene_kinds();

/// Scenes with a shutter in which things move.
const std::vector<SceneKind>& moving_scene_kinds();

/// scene_kinds() followed by exponent_scene_kinds() and moving_scene_kinds().
std::vector<SceneKind> every_scene_kind();

}  // namespace raylab::adversarial
