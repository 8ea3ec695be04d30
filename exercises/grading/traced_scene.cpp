#include "traced_scene.h"

#include "raylab/experiment/textbook/textbook.h"

#include <array>

namespace raylab::grading {

namespace {

enum Matter : std::size_t { floor_tiles, glass, mirror, plastic };

std::vector<Material> materials() {
    return {
        {.name = "floor", .ambient = {0.4, 0.4, 0.4}, .diffuse = Checker{{0.85, 0.8, 0.65}, {0.25, 0.1, 0.1}, 1}},
        {.name = "glass",
         .diffuse = Color{0.02, 0.03, 0.03},
         .specular = {0.6, 0.6, 0.6},
         .shininess = 80,
         .kr = 0.15,
         .kt = 0.8,
         .ior = 1.5},
        {.name = "mirror", .diffuse = Color{0.1, 0.1, 0.12}, .specular = {0.5, 0.5, 0.5}, .shininess = 60, .kr = 0.7},
        {.name = "plastic",
         .ambient = {0.3, 0.1, 0.05},
         .diffuse = Color{0.8, 0.25, 0.1},
         .specular = {0.5, 0.5, 0.5},
         .shininess = 15}};
}

// An upright prism over a triangle that runs counter-clockwise as seen from above; its normals point outward.
std::vector<Triangle> prism(const std::array<Vec3f, 3>& base, float height) {
    const Vec3f up{0, height, 0};
    const auto& [a, b, c] = base;
    std::vector<Triangle> faces{{a, c, b}, {a + up, b + up, c + up}};
    for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}}) {
        faces.push_back({from, to, to + up});
        faces.push_back({from, to + up, from + up});
    }
    return faces;
}

Object object(const Shape& shape, Matter matter, const std::string& path) {
    return {.shape = shape, .placement = {}, .front = matter, .back = matter, .path = path};
}

std::vector<Object> objects() {
    std::vector<Object> all{object(Plane{{0, 0, 0}, {0, 1, 0}}, floor_tiles, "floor"),
                            object(Sphere{{-0.9f, 0.8f, 0.2f}, 0.8f}, glass, "glass sphere"),
                            object(Sphere{{0.9f, 0.75f, -1.0f}, 0.75f}, mirror, "mirror sphere"),
                            object(Sphere{{0.3f, 0.3f, 1.3f}, 0.3f}, plastic, "red sphere"),
                            // It is beyond the first light as seen from most of the scene, so it must cast no shadow
                            // there.
                            object(Sphere{{4, 8, 6.4f}, 2}, plastic, "balloon")};
    // Its sides are so steep that rays which enter through one have total internal reflection at another.
    for (const auto& face : prism({Vec3f{1.0f, 0.02f, 0.6f}, {1.5f, 0.02f, 1.25f}, {1.95f, 0.02f, 0.45f}}, 1.0f))
        all.push_back(object(face, glass, "prism"));
    return all;
}

}  // namespace

RayTree TracedScene::tree(int x, int y) const {
    return textbook_tree(scene, picture_ray(frame, x + 0.5, y + 0.5), limit);
}

TracedScene traced_scene(ImageSize size) {
    Scene scene{.source = "the traced scene",
                .image = size,
                .camera = {.position = {0, 1.7, 5.2}, .target = {0.2, 0.65, 0}, .projection = Perspective{38}},
                .background = {{0.35, 0.5, 0.7}, {0.25, 0.25, 0.25}},
                .materials = materials(),
                .lights = {{PointLight{{2.5, 5, 4}}, {0.8, 0.8, 0.75}}, {PointLight{{-4, 4, 1}}, {0.4, 0.4, 0.5}}},
                .objects = objects()};
    const auto frame = camera_frame(scene.camera, size, scene.source);
    return {std::move(scene), frame, 5};
}

}  // namespace raylab::grading
