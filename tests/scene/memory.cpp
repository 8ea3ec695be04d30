#include "catch.h"

#include "raylab/base/error.h"
#include "raylab/scene/memory_need.h"
#include "raylab/scene/mesh/read_mesh.h"
#include "raylab/scene/read_scene.h"
#include "raylab/scene/toml/skim.h"

using namespace raylab;
using Catch::Contains;

namespace {

constexpr MemoryLimit few_mebibytes{8 << 20};

Scene toml(const std::string& text, const MemoryLimit& limit) { return read_scene_text(text, "a.toml", limit); }

std::string repeated(std::size_t times, const std::string& text) {
    std::string all;
    for (std::size_t i = 0; i < times; ++i) all += text;
    return all;
}

const std::string sphere = "[[shape]]\ntype = \"sphere\"\ncenter = [1.5, 2, 3]\nradius = 1\n";

}  // namespace

TEST_CASE("a TOML file that takes more than the limit while it is parsed is refused before") {
    const std::string head = "raylab = 1\n";
    for (const std::string& bomb : {repeated(10'000, "[a.a.a.a.a.a.a.a]\n"), "a = [" + repeated(100'000, "0,") + "]",
                                    "a = [" + repeated(50'000, "{},") + "]", repeated(10'000, "{a.a.a.a = 0},"),
                                    repeated(30'000, "[[a]]\n"), repeated(10'000, sphere)})
        CHECK_THROWS_WITH(toml(head + bomb, few_mebibytes),
                          Contains("a.toml: expected at most 8.0 MiB (--memory), found a scene that needs ") &&
                              Contains("bytes of TOML, parsed"));
    CHECK(toml(head + repeated(1'000, sphere), few_mebibytes).objects.size() == 1'000);
}

TEST_CASE("the forecast for TOML counts keys and values, not the dots of numbers, comments or strings") {
    const auto bytes = [](const std::string& text) { return toml_file::parsed_bytes(text, "a.toml"); };
    CHECK(bytes("[a.b.c]\n") - bytes("[a]\n") == Approx(2 * 352 + 4));
    CHECK(bytes("a.b.c = 1\n") - bytes("a = 1\n") == Approx(2 * 352 + 4));
    CHECK(bytes("a = 1.5\n") - bytes("a = 1\n") == 2);
    CHECK(bytes("a = \"[[,,..\" # [[,,..\n") < 450);
}

TEST_CASE("instances are counted against the limit before they are made") {
    std::string text = "raylab = 1\n[group.a]\nshapes = [";
    text += repeated(300, "{ type = \"sphere\", center = [0, 0, 0], radius = 1 },") + "]\n";
    text += repeated(200, "[[instance]]\nof = \"a\"\n");
    CHECK_THROWS_WITH(toml(text, few_mebibytes),
                      Contains("found a scene that needs ") && Contains("shapes and instances in all"));
    CHECK(toml(text, {64 << 20}).objects.size() == 60'000);
}

TEST_CASE("a mesh is refused where its lists would outgrow the limit") {
    const std::string points =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    const std::string ply =
        points + "element face 1\nproperty list uint uchar vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
    CHECK_THROWS_WITH(
        read_mesh_bytes(ply + "1000000 " + repeated(1'000'000, "0 ") + "\n", MeshFormat::ply, "a.ply", few_mebibytes),
        Contains("a.ply:13: expected at most 8.0 MiB (--memory), found a mesh that needs ") &&
            Contains("3 vertices and "));
    CHECK_THROWS_WITH(read_mesh_bytes(std::string(8 << 20, '\0'), MeshFormat::stl, "a.stl", few_mebibytes),
                      Contains("8388608 bytes of STL"));
}

TEST_CASE("a mesh's triangles count once for all the places where it stands at rest, and every pixel for the picture") {
    auto mesh = std::make_shared<Mesh>();
    mesh->faces.resize(1000);
    Scene scene;
    for (int i = 0; i < 5; ++i) scene.objects.push_back({.shape = mesh});
    CHECK(accelerator_need(scene).bytes == 5 * accelerator_need(*mesh).bytes);
    CHECK(picture_need(scene, {100, 10}).bytes == accelerator_need(scene).bytes + 24 * 1000);
    const double of_mesh = accelerator_need(*mesh).bytes;
    scene.objects.push_back({.shape = Sphere{}});
    const double of_sphere = accelerator_need(scene).bytes - 5 * of_mesh;
    scene.objects.pop_back();
    for (Object& object : scene.objects) object.placement.translation = {1, 0, 0};
    CHECK(accelerator_need(scene).bytes == of_mesh + 5 * of_sphere);
    scene.camera.shutter = {0, 1};
    scene.objects[0].motion = Motion{.translation = {1, 0, 0}};
    CHECK(accelerator_need(scene).bytes == of_mesh + 4 * of_sphere + 1000 * of_sphere);
}

TEST_CASE("the forecast for a structure is what was measured while it was built, or up to a fifth more") {
    const auto is_forecast = [](double measured, const MemoryNeed& need) {
        INFO("measured " << measured << ", forecast " << need.bytes);
        CHECK(need.bytes >= measured);
        CHECK(need.bytes <= 1.2 * measured);
    };
    const auto mesh = [](std::size_t triangles, std::size_t vertices) {
        Mesh made;
        made.faces.resize(triangles);
        made.vertices.resize(vertices);
        return made;
    };
    // Bytes a triangle of the largest resident set of `raylab trace --threads 2`, with bvh8_splits and bvh8.
    is_forecast(108.6 * 2'000'000, accelerator_need(mesh(2'000'000, 1'002'001)));  // a sheet
    is_forecast(187.6 * 1'000'000, accelerator_need(mesh(1'000'000, 3'000'000)));  // each triangle by itself
    Scene spheres;
    spheres.objects.assign(1000, {.shape = Sphere{}});
    is_forecast(551 * 1000, accelerator_need(spheres));
}

TEST_CASE("OBJ: normals, and which of them each vertex has, count as the mesh does") {
    const auto read = [](const std::string& text, const MemoryLimit& limit) {
        return read_mesh_bytes(text, MeshFormat::obj, "a.obj", limit).faces.size();
    };
    const std::string face = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -3\n";
    CHECK_THROWS_WITH(read(repeated(200'000, "vn 0 0 1\n") + face, {1 << 20}), Contains("found a mesh that needs "));
    CHECK(read(repeated(20'000, "vn 0 0 1\n") + face, {1 << 20}) == 1);
    CHECK_THROWS_WITH(read(repeated(60'000, "v 0 0 0\n") + face, {3 << 19}), Contains("found a mesh that needs "));
    const std::string both = repeated(100'000, "vn 0 0 1\n") + repeated(60'000, "v 0 0 0\n") + face;
    CHECK_THROWS_WITH(read(both, {3 << 20}), Contains("found a mesh that needs "));
    CHECK(read(both, {4 << 20}) == 1);
}
