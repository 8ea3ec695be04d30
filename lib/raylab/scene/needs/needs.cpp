#include "raylab/scene/needs.h"

#include "raylab/geometry/shape_parts.h"
#include "raylab/scene/moving.h"
#include "raylab/scene/needs/parts.h"
#include "raylab/scene/needs/spread.h"
#include "raylab/scene/render_model.h"

#include <algorithm>

namespace raylab {

namespace {

bool needs_time(const Scene& scene) {
    const auto& shutter = scene.camera.shutter;
    return shutter && shutter->open != shutter->close && anything_moves(scene);
}

// Of a picture whose rays are spread, what is said in words is about that picture.
void set_spread(Needs& needs, const NeedsQuestion& question) {
    const Scene& scene = question.scene;
    const SpreadFacts facts = spread_facts(question, needs.model);
    needs.dimensions = sample_dimensions(question, needs, facts);
    needs.unreached = unreached_light(facts);
    needs.paths = spread_paths(scene, facts);
    needs.asked = asked_of_spread(scene, needs, facts);
    needs.left_out = left_out_of_spread(scene, needs, facts);
}

}  // namespace

std::size_t primitive_count(const Scene& scene) {
    std::size_t count = 0;
    for (const auto& object : scene.objects) count += part_count(object.shape);
    return count;
}

Needs needs_of(const Scene& scene, const NeedsOptions& options) {
    const auto objects = object_facts(scene);
    const NeedsQuestion question{scene, options, objects, walls_around_lights(scene), bends_light(scene, objects)};
    const auto seen = seen_materials(question);
    Needs needs;
    needs.eye_rays = !scene.objects.empty();
    needs.lens = needs.eye_rays && scene.camera.lens && scene.camera.lens->radius > 0;
    needs.time = needs_time(scene);
    needs.lights = light_needs(question, seen);
    needs.shadows = std::ranges::any_of(needs.lights, &LightNeeds::shadow_rays);
    const auto recursion = recursion_needs(question, seen);
    needs.depth = recursion.depth;
    needs.recursion = recursion.depth > 1;
    needs.passed_on = recursion.passed_on;
    needs.materials = material_needs(question, seen, needs.lights, recursion);
    needs.primitives = primitive_count(scene);
    needs.accelerator = suited_accelerator(scene);
    needs.model = chosen_model(scene);
    needs.renderer = cheapest_renderer(scene, {.shadow_rays = needs.shadows, .depth = needs.depth});
    needs.paths = modelled_paths(question, needs);
    needs.missed_paths = missed_paths(question, needs);
    needs.asked = asked_for(question, needs);
    needs.left_out = left_out(question, needs);
    if (needs.eye_rays && needs.model != RenderModel::whitted) set_spread(needs, question);
    needs.missed = missed_effects(question, needs);
    needs.warnings = warnings_of(question);
    return needs;
}

}  // namespace raylab
