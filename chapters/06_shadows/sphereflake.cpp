#include "pictures.h"

#include "raylab/report/chapter_picture.h"
#include "raylab/scene/nff/read_nff.h"

namespace raylab::shadows {

// A fourth generation, 7381 spheres, as polished metal over a floor that mirrors a little.
Image sphereflake(const ChapterRun& run) {
    Scene scene = read_nff(flake_nff(4), "sphereflake");
    scene.image = run.sized(ImageSize{1600, 1000}, ImageSize{320, 200});
    scene.camera = {
        .position = {2.6, 1.35, 1.15}, .target = {0, 0, 0.12}, .up = {0, 0, 1}, .projection = Perspective{35}};
    scene.background = {.color = {0.30, 0.42, 0.62}, .ambient = {0.30, 0.32, 0.38}};
    Material& floor = scene.materials[scene.objects.front().front];
    floor.ambient = {0.5, 0.48, 0.45};
    floor.diffuse = Color{0.55, 0.52, 0.48};
    floor.specular = {0, 0, 0};
    floor.kr = 0.12;
    Material& metal = scene.materials[scene.objects.back().front];
    metal.ambient = {0.24, 0.15, 0.06};
    metal.diffuse = Color{0.30, 0.18, 0.07};
    metal.specular = {0.8, 0.7, 0.5};
    metal.shininess = 60;
    metal.kr = 0.55;
    scene.lights = {{.kind = PointLight{{3, 4, 5}}, .color = {0.95, 0.88, 0.75}},
                    {.kind = PointLight{{4, -4, 3}}, .color = {0.25, 0.30, 0.40}}};
    return chapter_picture(scene, scene.image, run, {.depth = 6, .threshold = 0.05});
}

}  // namespace raylab::shadows
