#include "catch.h"

#include "raylab/image/finite.h"
#include "raylab/scene/read_scene.h"
#include "raylab/tracer/picture/whitted_picture.h"

// Scenes that are legal and ill: every pixel is a number all the same.

using namespace raylab;

namespace {

const std::string head =
    "raylab = 1\n[image]\nwidth = 48\nheight = 36\n[background]\ncolor = [0.2, 0.3, 0.5]\nambient = [0.1, 0.1, 0.1]\n"
    "[material.red]\nambient = [1, 0, 0]\nspecular = [0.4, 0.4, 0.4]\nshininess = 20\n"
    "[material.mirror]\nkr = 1\n"
    "[material.glass]\nkr = 0.1\nkt = 0.9\nior = 1.5\n";

std::string light_at(const std::string& position) {
    return "[[light]]\ntype = \"point\"\nposition = " + position + "\nattenuation = [0, 0, 1]\n";
}

const std::string ground = "[[shape]]\ntype = \"plane\"\npoint = [0, -1, 0]\nnormal = [0, 1, 0]\nmaterial = \"red\"\n";

std::string shape(const std::string& keys, const std::string& material) {
    return "[[shape]]\n" + keys + "\nmaterial = \"" + material + "\"\n";
}

const std::vector<std::string> closed{
    "type = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1",
    "type = \"cylinder\"\nbase = [0, -1, 0]\ntop = [0, 1, 0]\nradius = 1\nends = \"capped\"",
    "type = \"cone\"\nbase = [0, -1, 0]\ntop = [0, 1, 0]\nbase_radius = 1\nends = \"capped\"",
};

void check_finite(const Scene& scene) {
    const auto accelerator = make_accelerator("auto", scene);
    const auto found = first_non_finite(whitted_picture(scene, *accelerator, camera_frame(scene.camera, scene.image)));
    CHECK_FALSE(found);
}

}  // namespace

TEST_CASE("lights and viewers inside shapes and on their surfaces leave every pixel a number") {
    for (const auto& keys : closed)
        for (const auto* material : {"red", "mirror", "glass"})
            for (const auto* position : {"[0, 0, 0]", "[0, 0.5, 0]", "[0, 1, 0]", "[0, -1, 0]", "[0, 0, 5]"})
                for (const auto* eye : {"[0, 0, 5]", "[0, 0, 0.5]", "[0, 0, 1]"}) {
                    INFO(keys << "\n" << material << " light " << position << " eye " << eye);
                    const auto camera = std::string("[camera]\nposition = ") + eye + "\ntarget = [0, 0.1, -3]\n";
                    check_finite(read_scene_text(head + camera + light_at(position) + shape(keys, material) + ground,
                                                 "ill.toml"));
                }
}

TEST_CASE("normals of a mesh that are zero or cancel leave every pixel a number") {
    const auto mesh_with = [](const Vec3f& a, const Vec3f& b, const Vec3f& c) {
        Scene scene = read_scene_text(head + light_at("[1, 2, 4]") + ground, "ill.toml");
        scene.objects.push_back({.shape = std::make_shared<const Mesh>(
                                     Mesh{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{0, 1, 2}}, {a, b, c}})});
        return scene;
    };
    check_finite(mesh_with({0, 0, 0}, {0, 0, 0}, {0, 0, 0}));
    check_finite(mesh_with({0, 0, 1}, {0, 0, -1}, {0, 0, 0}));
    check_finite(mesh_with({0, 0, 0}, {0, 0, 3e38f}, {0, 0, 1e-38f}));
}

TEST_CASE("triangles without area are never hit, whatever stands beside them") {
    Scene scene = read_scene_text(head + light_at("[1, 2, 4]") + ground, "ill.toml");
    scene.objects.push_back({.shape = std::make_shared<const Mesh>(
                                 Mesh{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{0, 0, 0}, {0, 1, 1}, {0, 1, 2}}})});
    check_finite(scene);
}
