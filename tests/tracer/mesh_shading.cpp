#include "catch.h"

#include "raylab/experiment/generate/generate.h"
#include "raylab/geometry/mesh/vertex_normals.h"
#include "raylab/tracer/picture/whitted_picture.h"
#include "raylab/tracer/shading/reflected_light.h"

#include <cmath>

using namespace raylab;

namespace {

// One triangle in the plane z = 0, its vertex normals leaning outward, under a light from the front; seen along -z.
Scene one_triangle(Shading shading) {
    Mesh mesh{.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}},
              .faces = {{0, 1, 2}},
              .normals = {{0, 0, 3}, {0.6f, 0, 0.8f}, {0, 0.06f, 0.08f}}};  // of any length, as in files
    Scene scene;
    scene.camera.position = {0, 0, 5};
    scene.camera.projection = Orthographic{6};
    scene.materials = {{.name = "white", .diffuse = Color{1, 1, 1}}};
    scene.lights = {{.kind = DistantLight{{0, 0, -1}}}};
    scene.objects = {{.shape = std::make_shared<const Mesh>(std::move(mesh)), .shading = shading}};
    return scene;
}

double brightness(const Scene& scene, const Vec3f& above, const WhittedOptions& options = {}) {
    const auto list = make_accelerator("list", scene);
    Traversal traversal;
    return whitted_color(scene, *list, options, {.origin = above, .direction = {0, 0, -1}}, traversal).x;
}

}  // namespace

TEST_CASE("flat shading lights a triangle by its own normal") {
    CHECK_THAT(brightness(one_triangle(Shading::flat), {0.5f, 0.5f, 1}), WithinAbs(1, 1e-12));
    CHECK_THAT(brightness(one_triangle(Shading::flat), {1.75f, 0.125f, 1}), WithinAbs(1, 1e-12));
}

TEST_CASE("Gouraud shading mixes the colours of the vertices") {
    const auto scene = one_triangle(Shading::gouraud);
    CHECK_THAT(brightness(scene, {0.5f, 0.5f, 1}), WithinAbs(0.5 * 1 + 0.25 * 0.8 + 0.25 * 0.8, 1e-7));
    CHECK_THAT(brightness(scene, {1, 0.5f, 1}), WithinAbs(0.25 * 1 + 0.5 * 0.8 + 0.25 * 0.8, 1e-7));
}

TEST_CASE("Gouraud shading shows the light of the corners where the mixed normal looks away from it") {
    auto scene = one_triangle(Shading::gouraud);
    Mesh mesh = *std::get<std::shared_ptr<const Mesh>>(scene.objects[0].shape);
    mesh.normals = {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}};  // with the weights 1/2, 1/4, 1/4: away from the light
    scene.objects[0].shape = std::make_shared<const Mesh>(mesh);
    scene.lights = {{.kind = DistantLight{{-0.8, 0, -0.6}}}};
    CHECK_THAT(brightness(scene, {0.5f, 0.5f, 1}), WithinAbs(0.25 * 0.8, 1e-7));
    scene.objects[0].shading = Shading::phong;
    CHECK(brightness(scene, {0.5f, 0.5f, 1}) == 0);
}

TEST_CASE("Phong shading mixes the unit normals of the vertices and makes them unit again") {
    const auto scene = one_triangle(Shading::phong);
    const Vec3d mixed = 0.5 * Vec3d{0, 0, 1} + 0.25 * Vec3d{0.6, 0, 0.8} + 0.25 * Vec3d{0, 0.6, 0.8};
    CHECK_THAT(brightness(scene, {0.5f, 0.5f, 1}), WithinAbs(mixed.z / glm::length(mixed), 1e-7));
}

TEST_CASE("the corners are lit where they stand, and seen from there") {
    auto scene = one_triangle(Shading::gouraud);
    scene.materials[0].specular = {1, 1, 1};
    scene.materials[0].shininess = 4;
    scene.lights = {{.kind = PointLight{{1, 1, 4}}, .attenuation = {0, 0, 1}}};
    scene.camera.projection = Perspective{};
    scene.objects[0].placement = AffineSteps::translate({0.5, 0, 0}).rounded();
    const auto& mesh = *std::get<std::shared_ptr<const Mesh>>(scene.objects[0].shape);
    const Vec3f eye{1, 0.5f, 3};
    for (const bool parallel : {false, true}) {
        if (parallel) scene.camera.projection = Orthographic{};
        double mean = 0;  // with the weights 1/2, 1/4, 1/4 of the point that is seen
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3d corner = convert<double>(mesh.vertices[i]) + Vec3d{0.5, 0, 0};
            const LitPoint point{
                .position = corner,
                .normal = glm::normalize(convert<double>(mesh.normals[i])),
                .to_viewer = parallel ? Vec3d{0, 0, 1} : glm::normalize(convert<double>(eye) - corner)};
            const auto light = illumination(scene.lights[0], corner).value();
            mean += (i == 0 ? 0.5 : 0.25) * reflected_light(light, point, {1, 1, 1}, scene.materials[0]).x;
        }
        CHECK_THAT(brightness(scene, eye), WithinAbs(mean, 1e-6));
    }
}

TEST_CASE("a triangle seen from behind is lit from behind, by every shading alike") {
    for (const auto shading : {Shading::flat, Shading::gouraud, Shading::phong}) {
        auto scene = one_triangle(shading);
        const double before = brightness(scene, {0.5f, 0.5f, 1});
        scene.lights = {{.kind = DistantLight{{0, 0, 1}}}};
        const auto list = make_accelerator("list", scene);
        Traversal traversal;
        const Ray from_behind{.origin = {0.5f, 0.5f, -1}, .direction = {0, 0, 1}};
        CHECK_THAT(whitted_color(scene, *list, {}, from_behind, traversal).x, WithinAbs(before, 1e-12));
    }
}

TEST_CASE("a mesh without normals is flat, whatever its shading") {
    auto scene = one_triangle(Shading::gouraud);
    Mesh bare = *std::get<std::shared_ptr<const Mesh>>(scene.objects[0].shape);
    bare.normals.clear();
    scene.objects[0].shape = std::make_shared<const Mesh>(bare);
    CHECK_THAT(brightness(scene, {0.5f, 0.5f, 1}), WithinAbs(1, 1e-12));
}

TEST_CASE("where vertices have no normal, or these cancel, the triangle's own stands in") {
    auto scene = one_triangle(Shading::phong);
    Mesh mesh = *std::get<std::shared_ptr<const Mesh>>(scene.objects[0].shape);
    for (const auto& normals :
         {std::vector<Vec3f>(3, Vec3f{0, 0, 0}), std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}}}) {
        mesh.normals = normals;
        scene.objects[0].shape = std::make_shared<const Mesh>(mesh);
        for (const auto shading : {Shading::gouraud, Shading::phong}) {
            scene.objects[0].shading = shading;
            CHECK(std::isfinite(brightness(scene, {0.5f, 0.5f, 1})));
        }
    }
    scene.objects[0].shading = Shading::phong;
    CHECK_THAT(brightness(scene, {0.5f, 0.5f, 1}), WithinAbs(1, 1e-12));
}

TEST_CASE("smooth normals follow a placement by its inverse transpose") {
    auto scene = one_triangle(Shading::phong);
    AffineSteps stretch;
    stretch.columns = {Vec3d{2, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
    scene.objects[0].placement = stretch.rounded();
    const Vec3d corner = glm::normalize(Vec3d{0.6 / 2, 0, 0.8});
    CHECK_THAT(brightness(scene, {4 - 1e-6f, 0, 1}), WithinAbs(corner.z, 1e-6));
    scene.objects[0].shading = Shading::gouraud;
    CHECK_THAT(brightness(scene, {4 - 1e-6f, 0, 1}), WithinAbs(corner.z, 1e-6));
}

TEST_CASE("the dark side of a smooth mesh begins at its triangles under shadows, at its normals without") {
    auto scene = one_triangle(Shading::phong);
    scene.lights = {
        {.kind = DistantLight{{-0.9, 0, 0.1}}}};  // from a little behind the plane: a leaning normal sees it
    const Vec3f leaning{1.9f, 0, 1};
    CHECK(brightness(scene, leaning, {.shadows = WhittedOptions::Shadows::cast}) == 0);
    CHECK(brightness(scene, leaning, {.shadows = WhittedOptions::Shadows::none}) > 0.3);
}

TEST_CASE("a fine mesh's three shadings come near the sphere's own brightness") {
    Scene scene;
    scene.materials = {{.name = "white", .diffuse = Color{1, 1, 1}}};
    scene.lights = {{.kind = DistantLight{{0, 0, -1}}}};
    const auto mesh = std::make_shared<const Mesh>(with_vertex_normals(icosphere(4)));
    const Vec3f above{0.4f, 0.3f, 5};
    const double truth = std::sqrt(1 - 0.4 * 0.4 - 0.3 * 0.3);
    for (const auto& [shading, largest] :
         {std::pair{Shading::flat, 0.03}, {Shading::gouraud, 2e-3}, {Shading::phong, 2e-3}}) {
        scene.objects = {{.shape = mesh, .shading = shading}};
        CHECK_THAT(brightness(scene, above), WithinAbs(truth, largest));
    }
}
