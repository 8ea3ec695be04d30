#include "alike.h"
#include "catch.h"

#include "raylab/scene/pov/light.h"
#include "raylab/scene/read_scene.h"

// Compares the whole of Whitted's equation in two renderers that have no code in common.

using namespace raylab;

namespace {

Scene whitted_scene() { return read_scene(RAYLAB_SOURCE "/tests/render_peer/whitted.toml"); }

// For POV-Ray the invisible side of a one-sided surface is a clear surface, which counts as a level.
Scene without_one_sided(Scene scene) {
    std::erase_if(scene.objects, [](const Object& object) { return object.sides != Sides::both; });
    return scene;
}

// Attenuations that POV-Ray cannot express, without their linear term.
Scene with_sayable_lights(Scene scene) {
    for (Light& light : scene.lights)
        if (!pov::says_attenuation(light.attenuation)) light.attenuation.y = 0;
    return scene;
}

// A highlight in POV-Ray has the light's colour: the export uses the mean of a coloured one, and so does this scene.
Scene with_sayable_highlights(Scene scene) {
    for (Material& material : scene.materials) {
        const auto& c = material.specular;
        material.specular = Color((c.r + c.g + c.b) / 3);
    }
    return scene;
}

}  // namespace

TEST_CASE("POV-Ray renders Whitted's equation as we do") { check_alike(whitted_scene(), 5); }

TEST_CASE("POV-Ray counts depth as we do") {
    for (const int depth : {1, 2, 3}) check_alike(without_one_sided(whitted_scene()), depth);
}

TEST_CASE("POV-Ray renders the chapters' scenes as we do") {
    for (const auto& entry : std::filesystem::directory_iterator(RAYLAB_SOURCE "/chapters")) {
        const auto file = entry.path() / "scene.toml";
        if (!std::filesystem::is_regular_file(file)) continue;
        INFO(file);
        Scene scene = with_sayable_highlights(with_sayable_lights(read_scene(file)));
        scene.image = {.width = 320, .height = 240};
        check_alike(scene, 5);
    }
}
