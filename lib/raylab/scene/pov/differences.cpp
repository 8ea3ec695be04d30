#include "raylab/geometry/containment.h"
#include "raylab/geometry/shape_parts.h"
#include "raylab/scene/pov/area_light.h"
#include "raylab/scene/pov/light.h"
#include "raylab/scene/pov/object.h"
#include "raylab/scene/pov/texture.h"
#include "raylab/scene/pov/write_pov.h"

#include <algorithm>

namespace raylab {

namespace {

struct Difference {
    bool (*applies)(const Scene& scene);
    const char* sentence;
};

bool is_colored(const Color& color) { return color.x != color.y || color.y != color.z; }

template <class Test>
bool any_object(const Scene& scene, const Test& test) {
    return std::ranges::any_of(scene.objects, test);
}

bool has_checker(const Scene& scene, std::size_t material) {
    return std::holds_alternative<Checker>(scene.materials[material].diffuse);
}

bool is_smooth(const Shape& shape) {
    const Mesh* mesh = as_mesh(shape);
    return mesh && !mesh->normals.empty();
}

// The comparison leaves room for rounding, because 0.1 + 0.9 is meant to be 1.
bool reflects_less(const Material& material) { return material.kr + material.kt < 1 - 1e-9; }

const Difference differences[] = {
    {[](const Scene& scene) { return any_object(scene, [](const Object& o) { return o.motion.has_value(); }); },
     "No motion: all objects are where they are at time 0."},
    {[](const Scene& scene) {
         return std::ranges::any_of(scene.materials, [](const Material& m) {
             return (m.kr > 0 || m.kt > 0) && !std::holds_alternative<Sharp>(m.polish);
         });
     },
     "Mirrors and glass are sharp: no gloss and no roughness."},
    {[](const Scene& scene) {
         return any_object(scene, [&](const Object& o) { return pov::is_light(o, scene) && pov::says_area_light(o); });
     },
     "Area lights are grids of points, moved at random; what emits throws no shadow."},
    {[](const Scene& scene) {
         return any_object(scene, [&](const Object& o) { return pov::is_light(o, scene) && !pov::says_area_light(o); });
     },
     "What emits and is no rectangle, disk or sphere is seen, and lights nothing."},
    {[](const Scene& scene) { return scene.model == RenderModel::path; },
     "No light goes from one diffuse surface to another."},
    {[](const Scene& scene) {
         return std::ranges::any_of(scene.materials, [](const Material& m) { return is_colored(m.specular); });
     },
     "Highlights have the light's colour: POV-Ray's phong is a number, so coloured `specular` became its mean."},
    {[](const Scene& scene) {
         return any_object(scene, [&](const Object& o) {
             return !pov::says_checker_on(o.shape) && (has_checker(scene, o.front) || has_checker(scene, o.back));
         });
     },
     "Checkers on meshes, cylinders, cones, paraboloids and hyperboloids have cells in space, not across the normal."},
    {[](const Scene& scene) {
         return std::ranges::any_of(scene.lights, [](const Light& l) {
             return !std::holds_alternative<DistantLight>(l.kind) && !pov::says_attenuation(l.attenuation);
         });
     },
     "A light with linear and quadratic attenuation is right at the camera's target only: POV-Ray has one power."},
    {[](const Scene& scene) {
         return any_object(scene, [](const Object& o) { return o.sides != Sides::both && !is_closed(o.shape); });
     },
     "One-sided shapes are clear from the other side: a ray through one is one more of `depth`."},
    {[](const Scene& scene) {
         return any_object(scene, [&](const Object& o) {
             return pov::is_translucent(o, scene) && !is_closed(o.shape) && scene.materials[o.front].ior != 1;
         });
     },
     "POV-Ray enters where it first hits a surface and leaves where it hits it again, whatever side: what refracts "
     "should be closed."},
    {[](const Scene& scene) {
         return std::ranges::any_of(scene.materials, [](const Material& m) { return m.kt > 0 && m.ior == 1; });
     },
     "A ray that goes straight on (ior 1) does not count for POV-Ray's max_trace_level."},
    {[](const Scene& scene) {
         return std::ranges::any_of(scene.materials, [](const Material& m) { return m.kt > 0 && reflects_less(m); });
     },
     "Where all light is reflected inside, POV-Ray shows all of it, not kr + kt of it."},
    {[](const Scene& scene) {
         return std::ranges::any_of(scene.materials, [](const Material& m) { return m.kt > 0 && m.priority != 0; });
     },
     "POV-Ray knows no priority: where transparent objects overlap, what was entered last counts."},
    {[](const Scene& scene) { return any_object(scene, [](const Object& o) { return is_smooth(o.shape); }); },
     "A smooth mesh turns its back where its smooth normals do, not its triangles."},
    {[](const Scene& scene) {
         return any_object(scene, [](const Object& o) { return is_smooth(o.shape) && o.shading != Shading::phong; });
     },
     "POV-Ray mixes normals wherever vertices have some: meshes with flat or Gouraud shading are smooth by Phong's."},
};

}  // namespace

std::vector<std::string> pov_differences(const Scene& scene) {
    std::vector<std::string> sentences;
    for (const auto& [applies, sentence] : differences)
        if (applies(scene)) sentences.push_back(sentence);
    return sentences;
}

}  // namespace raylab
