#include "cases.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/tracer/whitted/whitted.h"

#include <fmt/format.h>

// Cases of what a model cannot show that uses only a point and the lights, and nothing else of the scene.

namespace raylab::lighting {

namespace {

using Shadows = WhittedOptions::Shadows;

// A floor, and a ball above it that may glow, under a light vertically above both.
Scene ball_above_floor(const Color& glow) {
    Scene scene;
    scene.background.ambient = {0.1, 0.1, 0.1};
    scene.materials = {{.name = "white", .ambient = {0.5, 0.5, 0.5}, .diffuse = Color{0.8, 0.8, 0.8}, .emission = glow},
                       {.name = "floor", .ambient = {0.5, 0.5, 0.5}, .diffuse = Color{0.8, 0.8, 0.8}}};
    scene.lights = {{.kind = PointLight{{0, 4, 0}}}};
    scene.objects = {{.shape = Sphere{{0, 1.5f, 0}, 1}}, {.shape = Plane{{0, 0, 0}, {0, 1, 0}}, .front = 1, .back = 1}};
    return scene;
}

// The brightness of the floor vertically below the ball, seen from the side.
double floor_below(const Scene& scene, Shadows shadows) {
    const auto list = make_accelerator("list", scene);
    Traversal traversal;
    const Ray ray{.origin = {4, 0.4f, 0}, .direction = {-4, -0.4f, 0}};
    return whitted_color(scene, *list, {.shadows = shadows}, ray, traversal).x;
}

StabilityCase no_shadow() {
    return {"NO-SHADOW", "The floor under a ball that stands between it and the only light.", [] {
                const Scene scene = ball_above_floor({0, 0, 0});
                const double local = floor_below(scene, Shadows::none), cast = floor_below(scene, Shadows::cast);
                return std::vector<CaseRow>{{"local model", "fails: as bright as if there were no ball, more than 0.8",
                                             fmt::format("{:.3g}", local), local > 0.8},
                                            {"with a shadow ray", "holds: the ambient term alone, 0.05",
                                             fmt::format("{:.3g}", cast), std::abs(cast - 0.05) < 1e-12}};
            }};
}

StabilityCase dark_light() {
    return {"DARK-EMITTER",
            "The floor under a ball that glows ten times as bright as white, and under one that does not.", [] {
                const double with = floor_below(ball_above_floor({10, 10, 10}), Shadows::none);
                const double without = floor_below(ball_above_floor({0, 0, 0}), Shadows::none);
                return std::vector<CaseRow>{{"local model", "fails: no brighter, emission lights nothing else",
                                             fmt::format("brighter by {:g}", with - without), with == without}};
            }};
}

}  // namespace

std::vector<StabilityCase> local_cases(const ChapterRun&) { return {no_shadow(), dark_light()}; }

}  // namespace raylab::lighting
