#include "rooms.h"

#include <cassert>
#include <cmath>

namespace raylab::recursion {

namespace {

const Color black{0, 0, 0}, white{1, 1, 1};
constexpr float wide = 1000;
constexpr double chamber_glow = 0.1;

Material clear(double ior) { return {.name = "clear", .diffuse = black, .kt = 1, .ior = ior}; }

Object object(Shape shape, std::size_t material) {
    return {.shape = std::move(shape), .placement = {}, .front = material, .back = material};
}

Room room(Scene scene, const Vec3f& eye, const Vec3f& direction) {
    Room result{std::make_unique<const Scene>(std::move(scene)), nullptr, {eye, direction}};
    result.accelerator = make_accelerator("list", *result.scene);
    return result;
}

}  // namespace

Room hall_of_mirrors(double reflects) {
    Scene scene;
    scene.materials = {{.name = "mirror", .diffuse = black, .kr = reflects, .emission = white}};
    scene.objects = {object(Plane{{0, 0, -1}, {0, 0, 1}}, 0), object(Plane{{0, 0, 1}, {0, 0, -1}}, 0)};
    return room(std::move(scene), {0, 0, 0}, {0, 0, -1});
}

double hall_of_mirrors_truth(double reflects) { return 1 / (1 - reflects); }
double hall_of_mirrors_truth(double reflects, int depth) { return (1 - std::pow(reflects, depth)) / (1 - reflects); }

Room panes(int count) {
    Scene scene;
    scene.background.color = white;
    scene.materials = {clear(1.5), {.name = "dark", .diffuse = black}};
    scene.objects = {object(Plane{{0, 2, 0}, {0, 1, 0}}, 1)};  // behind the eye
    for (int i = 0; i < count; ++i) {
        const float top = static_cast<float>(-2 * i);
        scene.objects.push_back(object(Cylinder{{0, top - 1, 0}, {0, top, 0}, wide, Ends::capped}, 0));
    }
    return room(std::move(scene), {0, 1, 0}, {0, -1, 0});
}

double panes_truth(int count) {
    const double r = std::pow(0.5 / 2.5, 2);
    return (1 - r) / (1 + (2 * count - 1) * r);
}

Room glass_chamber(int surfaces) {
    assert(surfaces % 2 == 1);
    Scene scene;
    scene.background.color = white;
    scene.materials = {clear(1.5), clear(1)};
    for (auto& material : scene.materials) material.emission = chamber_glow * white;
    for (int i = 0; i < surfaces; ++i)  // the innermost is glass
        scene.objects.push_back(object(Sphere{{0, 0, 0}, static_cast<float>(1 + i)}, static_cast<std::size_t>(i % 2)));
    return room(std::move(scene), {0.1f, 0, 0}, {0, 0.6f, 0.8f});
}

// The coefficients at every hit sum to 1, and a ray that gets out sees a background of 1.
double glass_chamber_brightest(int depth) { return 1 + chamber_glow * depth; }

}  // namespace raylab::recursion
