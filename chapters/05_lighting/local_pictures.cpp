#include "local_pictures.h"

#include "raylab/geometry/affine.h"
#include "raylab/image/draw.h"
#include "raylab/report/chapter_picture.h"

namespace raylab::lighting {

namespace {

constexpr double caption_height = 17;  // in pictures that are shown at half their size

// A wide floor below an eye that looks down, or a wall in front of one that looks horizontally.
Scene plain_wall(const Material& material) {
    Scene scene;
    scene.image = {420, 286};
    scene.camera = {.position = {0, 0, 6}, .target = {0, 0, 0}, .projection = Perspective{40}};
    scene.materials = {material};
    scene.objects = {{.shape = Plane{{0, 0, 0}, {0, 0, 1}}}};
    return scene;
}

Image captioned(const Scene& scene, const ChapterRun& run, const std::string& words) {
    return with_caption(lit(scene, scene.image, run), words, caption_height);
}

}  // namespace

Image lit(const Scene& scene, ImageSize size, const ChapterRun& run) {
    return chapter_picture(scene, size, run, {.shadows = WhittedOptions::Shadows::none});
}

Image falloffs(const ChapterRun& run) {
    Scene scene = plain_wall({.name = "floor", .diffuse = Color{0.8, 0.8, 0.8}});
    scene.camera = {.position = {0, 3.5, 9}, .target = {0, 0, -1.5}, .projection = Perspective{34}};
    scene.objects = {{.shape = Plane{{0, 0, 0}, {0, 1, 0}}}};
    std::vector<Image> images;
    for (const auto& [name, attenuation] : {std::pair{"constant: 1", Vec3d{1, 0, 0}},
                                            {"linear: 1 / (d/2)", {0, 0.5, 0}},
                                            {"quadratic: 1 / (d/2)^2", {0, 0, 0.25}}}) {
        scene.lights = {{.kind = PointLight{{0, 1.2, 0}}, .color = Color{0.9, 0.9, 0.9}, .attenuation = attenuation}};
        images.push_back(captioned(scene, run, name));
    }
    return side_by_side(images);
}

Image spots(const ChapterRun& run) {
    Scene scene = plain_wall({.name = "wall", .ambient = {0.1, 0.1, 0.1}, .diffuse = Color{0.8, 0.8, 0.8}});
    scene.background.ambient = {0.6, 0.6, 0.6};
    std::vector<Image> images;
    for (const auto& [name, exponent] : {std::pair{"uniform", 0.0}, {"cos^10", 10.0}, {"cos^60", 60.0}}) {
        scene.lights = {
            {.kind = SpotLight{.position = {0, 0, 4}, .target = {0, 0, 0}, .cone = 20, .exponent = exponent}}};
        images.push_back(captioned(scene, run, name));
    }
    return side_by_side(images);
}

Image phong_terms(const ChapterRun& run) {
    const Material all{.name = "ball",
                       .ambient = {0.05, 0.28, 0.45},
                       .diffuse = Color{0.05, 0.28, 0.45},
                       .specular = {0.8, 0.8, 0.8},
                       .shininess = 40,
                       .emission = {0, 0.05, 0.02}};
    const Material none{.name = "ball", .diffuse = Color{0, 0, 0}};
    Material emission = none, ambient = none, diffuse = none, specular = none;
    emission.emission = all.emission;
    ambient.ambient = all.ambient;
    diffuse.diffuse = all.diffuse;
    specular.specular = all.specular;
    specular.shininess = all.shininess;

    Scene scene;
    scene.image = {250, 250};
    scene.camera = {.position = {0, 0, 5}, .target = {0, 0, 0}, .projection = Orthographic{2.3}};
    scene.background.ambient = {0.2, 0.2, 0.2};
    scene.lights = {{.kind = DistantLight{{1, -1, -1}}}};
    scene.objects = {{.shape = Sphere{{0, 0, 0}, 1}}};
    std::vector<Image> images;
    for (const auto& [name, material] : {std::pair{"emission", emission},
                                         {"+ ambient", ambient},
                                         {"+ diffuse", diffuse},
                                         {"+ specular", specular},
                                         {"= their sum", all}}) {
        scene.materials = {material};
        images.push_back(captioned(scene, run, name));
    }
    return side_by_side(images);
}

Image viewers(const ChapterRun& run) {
    Scene scene =
        plain_wall({.name = "floor", .diffuse = Color{0.05, 0.2, 0.3}, .specular = {0.7, 0.7, 0.7}, .shininess = 60});
    scene.image = {630, 420};
    scene.camera = {.position = {0, 2, 6}, .target = {0, 0, 0}, .projection = Perspective{45}};
    scene.objects = {{.shape = Plane{{0, 0, 0}, {0, 1, 0}}}};
    scene.lights = {{.kind = DistantLight{{0, -0.6, 1}}}};
    const WhittedOptions far{.viewer = WhittedOptions::Viewer::at_infinity,
                             .to_viewer = glm::normalize(scene.camera.position - scene.camera.target),
                             .shadows = WhittedOptions::Shadows::none};
    return side_by_side(
        {captioned(scene, run, "local viewer"),
         with_caption(chapter_picture(scene, scene.image, run, far), "viewer at infinity", caption_height)});
}

Image three_shadings(const std::shared_ptr<const Mesh>& mesh, const ChapterRun& run) {
    Scene scene;
    scene.image = {420, 420};
    scene.camera = {.position = {0, 0, 5}, .target = {0, 0, 0}, .projection = Orthographic{2.5}};
    scene.background = {.color = {1, 1, 1}, .ambient = {0.15, 0.15, 0.15}};
    scene.materials = {{.name = "clay",
                        .ambient = {0.8, 0.45, 0.3},
                        .diffuse = Color{0.7, 0.36, 0.2},
                        .specular = {0.5, 0.5, 0.5},
                        .shininess = 40}};
    scene.lights = {{.kind = DistantLight{{1, -1.2, -1.4}}}};
    std::vector<Image> images;
    for (const auto& [name, shading] :
         {std::pair{"flat", Shading::flat}, {"Gouraud", Shading::gouraud}, {"Phong", Shading::phong}}) {
        scene.objects = {{.shape = mesh, .shading = shading}};
        images.push_back(captioned(scene, run, name));
    }
    return side_by_side(images);
}

}  // namespace raylab::lighting
