#include "raylab/tracer/picture/only_needed.h"

#include "raylab/scene/needs.h"

#include <algorithm>

namespace raylab {

namespace {

// Shadow rays that start carelessly find shadows where there are none and none where there are, and who asked for those
// wants to see them.
bool shadows_are_true(const WhittedOptions& options) {
    return options.shadows == WhittedOptions::Shadows::cast &&
           options.start.offset == RayStart::Offset::error_bounded && options.start.leaving == RayStart::Leaving::known;
}

Needs needs_for(const Scene& scene, const WhittedOptions& options) {
    using Split = NeedsOptions::Split;
    const bool by_angle = options.reflectance == WhittedOptions::Reflectance::fresnel;
    return needs_of(scene, {.threshold = options.threshold,
                            .depth_limit = options.depth,
                            .split = by_angle ? Split::by_angle : Split::as_given});
}

}  // namespace

std::vector<std::size_t> seen_lights(const Scene& scene, const WhittedOptions& options) {
    const auto lights = needs_for(scene, options).lights;
    std::vector<std::size_t> seen;
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (lights[i].shines || !shadows_are_true(options)) seen.push_back(i);
    return seen;
}

Scene with_lights(Scene scene, const std::vector<std::size_t>& numbers) {
    std::vector<Light> lights;
    for (const std::size_t i : numbers) lights.push_back(scene.lights[i]);
    scene.lights = std::move(lights);
    return scene;
}

WhittedOptions only_needed(const Scene& scene, const WhittedOptions& options) {
    const Needs needs = needs_for(scene, options);
    WhittedOptions reduced = options;
    reduced.depth = needs.depth;
    // A light that does not shine may be one that shadow rays keep dark: those stay until the light is gone.
    const bool all_seen = std::ranges::all_of(needs.lights, &LightNeeds::shines);
    if (all_seen && !needs.shadows && shadows_are_true(options)) reduced.shadows = WhittedOptions::Shadows::none;
    return reduced;
}

}  // namespace raylab
