#include "raylab/scene/needs/facts.h"

#include "raylab/base/printable.h"
#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/mesh/winding_number.h"
#include "raylab/geometry/shape_parts.h"
#include "raylab/scene/camera.h"
#include "raylab/scene/moving.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace raylab {

namespace {

// Ray origins and ends are rounded to floats: that is half an ulp, and it is taken twice.
Vec3d float_rounding(const Vec3d& v) {
    constexpr double relative = std::numeric_limits<float>::epsilon(),
                     smallest = std::numeric_limits<float>::denorm_min();
    return {relative * std::abs(v.x) + smallest, relative * std::abs(v.y) + smallest,
            relative * std::abs(v.z) + smallest};
}

// How the object can contain the origins of the eye rays.
Containment viewer(const Scene& scene, const Object& object) {
    const Camera& camera = scene.camera;
    double spread = camera.lens ? camera.lens->radius : 0;
    if (std::holds_alternative<Orthographic>(camera.projection)) {
        const auto frame = camera_frame(camera, scene.image, scene.source);
        spread += frame.half_width + frame.half_height;
    }
    const Vec3d reach = float_rounding(camera.position) + Vec3d(spread);
    return containment_always(scene, object, region_about(camera.position, reach));
}

std::optional<Vec3d> position_of(const Light& light) {
    if (const auto* point = std::get_if<PointLight>(&light.kind)) return point->position;
    if (const auto* spot = std::get_if<SpotLight>(&light.kind)) return spot->position;
    return std::nullopt;
}

// A distant light is outside of every object.
Containment where_is(const Light& light, const Scene& scene, const Object& object) {
    const auto position = position_of(light);
    if (!position) return Containment::outside;
    return containment_always(scene, object, region_about(*position, float_rounding(*position)));
}

ObjectFacts facts_of(const Scene& scene, const Object& object) {
    const auto opaque = [&](std::size_t side) { return scene.materials[side].kt == 0; };
    bool front = object.sides != Sides::back, back = object.sides != Sides::front;
    // A ray from outside gets inside only through the surface, and the reverse.
    if (front && back && is_closed(object.shape)) {
        const auto eye = viewer(scene, object);
        if (eye == Containment::outside && opaque(object.front)) back = false;
        if (eye == Containment::inside && opaque(object.back)) front = false;
    }
    return {front, back, is_planar(object.shape) || (is_convex(object.shape) && !back)};
}

}  // namespace

std::vector<ObjectFacts> object_facts(const Scene& scene) {
    std::vector<ObjectFacts> facts;
    facts.reserve(scene.objects.size());
    for (const auto& object : scene.objects) facts.push_back(facts_of(scene, object));
    return facts;
}

std::vector<std::vector<std::size_t>> walls_around_lights(const Scene& scene) {
    std::vector<std::size_t> closed;
    for (std::size_t i = 0; i < scene.objects.size();
         ++i)  // an object that is seen only from its back is open to rays from outside
        if (is_closed(scene.objects[i].shape) && scene.objects[i].sides != Sides::back) closed.push_back(i);
    std::vector<std::vector<std::size_t>> walls;
    for (const auto& light : scene.lights) {
        const auto is_wall = [&](std::size_t i) {
            const Object& object = scene.objects[i];
            return where_is(light, scene, object) == Containment::inside &&
                   viewer(scene, object) == Containment::outside;
        };
        walls.emplace_back();
        std::ranges::copy_if(closed, std::back_inserter(walls.back()), is_wall);
    }
    return walls;
}

std::vector<std::size_t> meshes_around(const Scene& scene, const Light& light) {
    const auto position = position_of(light);
    std::vector<std::size_t> found;
    std::map<const Mesh*, Box> boxes;  // made once for all places of a mesh
    const auto is_outside = [&](const Object& object, const Mesh* mesh) {
        if (motion_of(scene, object)) return where_is(light, scene, object) == Containment::outside;
        auto [box, is_new] = boxes.try_emplace(mesh);
        if (is_new) box->second = *bounds(object.shape);
        const Region region = region_about(*position, float_rounding(*position));
        return containment_in_bounds(region, box->second, object.placement) == Containment::outside;
    };
    for (std::size_t i = 0; position && i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        const Mesh* mesh = as_mesh(object.shape);
        if (!mesh || is_outside(object, mesh)) continue;
        const auto winds_about = [&](const Vec3d& point) {
            return std::abs(winding_number(point, *mesh, object.placement)) > 0.5;
        };
        if (winds_about(*position) && !winds_about(scene.camera.position)) found.push_back(i);
    }
    return found;
}

std::optional<std::string> never_blocked(const Scene& scene, const ObjectFacts& object, const Light& light) {
    const Object& only = scene.objects.front();
    const auto name = name_of(scene, 0);
    if (is_planar(only.shape)) return name + " is alone and flat: it shades the side that is turned away, no other";
    if (!is_convex(only.shape)) return std::nullopt;
    const auto where = where_is(light, scene, only);
    if (!object.back_seen && where != Containment::undecided)
        return name + " is alone and convex: what it could shade is turned away from the light anyway";
    if (!object.front_seen && where == Containment::inside)
        return name + " is alone and convex, and the light is inside: every point in there sees it";
    return std::nullopt;
}

std::string name_of(const Scene& scene, std::size_t object) {
    const auto& path = scene.objects[object].path;
    return path.empty() ? fmt::format("object {}", object) : printable(path);
}

}  // namespace raylab
