#include "scenes.h"

#include "catch.h"

#include "raylab/sampling/sequence.h"
#include "raylab/scene/camera.h"
#include "raylab/scene/needs.h"
#include "raylab/tracer/picture/whitted_picture.h"

#include <algorithm>
#include <cmath>
#include <memory>

using namespace raylab;
using namespace raylab::test;

namespace {

// A mirror and a glass ball, a diffuse one, a floor; small.
const std::string still_life = glass + R"(
[image]
width = 32
height = 24
[camera]
position = [0, 1.5, 6]
target = [0, 0.7, 0]
fov_y = 40
[background]
color = [0.2, 0.3, 0.6]
ambient = [0.3, 0.3, 0.3]
[material.mirror]
diffuse = [0.1, 0.1, 0.1]
ambient = [0.1, 0.1, 0.1]
specular = [0.5, 0.5, 0.5]
shininess = 50
kr = 0.8
[material.floor]
ambient = [0.5, 0.5, 0.5]
diffuse = { pattern = "checker", a = [0.9, 0.9, 0.9], b = [0.1, 0.1, 0.1], size = 0.5 }
kr = 0.2
[[light]]
type = "point"
position = [3, 5, 4]
[[shape]]
type = "plane"
point = [0, 0, 0]
normal = [0, 1, 0]
material = "floor"
[[shape]]
type = "sphere"
center = [-1, 1, 0]
radius = 1
material = "mirror"
[[shape]]
type = "sphere"
center = [1, 1, 0.5]
radius = 1
material = "half"
[[shape]]
type = "sphere"
center = [0.2, 0.4, 2]
radius = 0.4
[material.half]
diffuse = [0.1, 0, 0]
specular = [0.5, 0.5, 0.5]
shininess = 50
kr = 0.1
kt = 0.85
ior = 1.5
)";

// Two mirrors face each other; one glows a little.
std::string hall(double reflects, double glow) {
    return "[material.mirror]\ndiffuse = [0, 0, 0]\nemission = [" + std::to_string(glow) +
           ", 0, 0]\nkr = " + std::to_string(reflects) +
           "\n[[shape]]\ntype = \"plane\"\npoint = [0, 0, -1]\nnormal = [0, 0, 1]\nmaterial = \"mirror\"\n"
           "[[shape]]\ntype = \"plane\"\npoint = [0, 0, 1]\nnormal = [0, 0, -1]\nmaterial = \"mirror\"\n";
}

Color sum_of_contributions(const RayTree& tree) {
    Color sum{0, 0, 0};
    for (const auto& node : tree.nodes)
        if (node.kind != RayKind::shadow) sum += node.contribution;
    return sum;
}

template <class Work>
void for_each_eye_ray(const Stage& stage, const Work& work) {
    const CameraFrame frame = camera_frame(stage.scene.camera, stage.scene.image);
    for (int y = 0; y < frame.image.height; y += 3)
        for (int x = 0; x < frame.image.width; x += 3) work(eye_ray(frame, x + 0.5, y + 0.5));
}

}  // namespace

TEST_CASE("a mirror reflects at the angle of incidence, in the plane of incidence") {
    const Stage stage(hall(1, 0));
    const Vec3d direction = glm::normalize(Vec3d{0.3, -0.5, -0.7});
    const auto reflected = of_kind(stage.tree({0, 0, 0}, direction, {.depth = 2}), RayKind::reflected);
    REQUIRE(!reflected.empty());
    CHECK(glm::length(convert<double>(reflected[0].ray.direction) - direction * Vec3d{1, 1, -1}) < 1e-6);
}

TEST_CASE("two facing mirrors sum the geometric series, cut off at the depth") {
    const double rho = 0.75, glow = 0.5;
    const Stage stage(hall(rho, glow));
    for (int depth = 1; depth <= 40; ++depth) {
        const double sum = glow * (1 - std::pow(rho, depth)) / (1 - rho);
        CHECK_THAT(stage.tree({0, 0, 0}, {0, 0, -1}, {.depth = depth}).pixel.x, WithinRel(sum, 1e-12));
    }
    CHECK_THAT(stage.tree({0, 0, 0}, {0, 0, -1}, {.depth = 200}).pixel.x, WithinRel(glow / (1 - rho), 1e-12));
}

TEST_CASE("a threshold between mirrors costs at most itself over 1 - rho") {
    const double rho = 0.8, glow = 1;
    const Stage stage(hall(rho, glow));
    const double truth = glow / (1 - rho);
    for (const double threshold : {0.5, 0.1, 0.01, 0.001}) {
        const double error = truth - stage.tree({0, 0, 0}, {0, 0, -1}, {.depth = 1000, .threshold = threshold}).pixel.x;
        CHECK(error > 0);
        CHECK(error <= glow * threshold / (1 - rho) * (1 + 1e-9));
    }
}

TEST_CASE("a ray whose throughput is the threshold itself is not followed, and needs says so too") {
    const Stage stage(hall(0.5, 1));
    CHECK(stage.tree({0, 0, 0}, {0, 0, -1}, {.depth = 1000, .threshold = 0.25}).pixel.x == 1.5);
    CHECK(needs_of(stage.scene, {.threshold = 0.25}).depth == 2);
    CHECK(stage.tree({0, 0, 0}, {0, 0, -1}, {.depth = 1000, .threshold = 0.2499}).pixel.x == 1.75);
    CHECK(needs_of(stage.scene, {.threshold = 0.2499}).depth == 3);
}

TEST_CASE("mirrors that reflect everything end at the depth, with a finite colour") {
    const auto tree = Stage(hall(1, 1)).tree({0, 0, 0}, {0, 0, -1}, {.depth = 1000});
    CHECK(tree.pixel.x == 1000);
    CHECK(of_kind(tree, RayKind::reflected).back().ended == Ending::depth);
}

TEST_CASE("the contributions of a ray tree add up to its pixel, which is what the picture shows") {
    const Stage stage(still_life);
    const WhittedOptions options{.depth = 6, .threshold = 0.001};
    Traversal traversal;
    for_each_eye_ray(stage, [&](const Ray& ray) {
        const RayTree tree = ray_tree(stage.scene, *stage.accelerator, options, ray);
        CHECK(glm::length(sum_of_contributions(tree) - tree.pixel) < 1e-14);
        CHECK(whitted_color(stage.scene, *stage.accelerator, options, ray, traversal) == tree.pixel);
    });
}

TEST_CASE("depth 1 is the local colour alone, and each depth adds a layer of the deepest tree") {
    const Stage stage(still_life);
    for_each_eye_ray(stage, [&](const Ray& ray) {
        const RayTree deepest = ray_tree(stage.scene, *stage.accelerator, {.depth = 8}, ray);
        Color sum{0, 0, 0};
        for (int depth = 1; depth <= 8; ++depth) {
            for (const auto& node : deepest.nodes)
                if (node.kind != RayKind::shadow && node.depth == depth) sum += node.contribution;
            const RayTree tree = ray_tree(stage.scene, *stage.accelerator, {.depth = depth}, ray);
            CHECK(glm::length(tree.pixel - sum) < 1e-14);
            if (depth == 1) CHECK(tree.pixel == tree.nodes.front().local);
        }
    });
}

TEST_CASE("what a threshold costs is no more than the throughputs it cut off") {
    // Nothing in the scene is brighter than 2, and no surface passes on more than .95 of what it gets.
    const Stage stage(still_life);
    for_each_eye_ray(stage, [&](const Ray& ray) {
        const Color truth = ray_tree(stage.scene, *stage.accelerator, {.depth = 30}, ray).pixel;
        for (const double threshold : {0.2, 0.05, 0.01}) {
            const RayTree tree = ray_tree(stage.scene, *stage.accelerator, {.depth = 30, .threshold = threshold}, ray);
            double cut = 0;
            for (const auto& node : tree.nodes)
                if (node.ended == Ending::threshold) cut += node.throughput;
            const Color error = truth - tree.pixel;
            CHECK(std::max({error.x, error.y, error.z}) <= cut * 2 / (1 - .95) + 1e-12);
        }
    });
}

TEST_CASE("pictures and counts are the same for any accelerator and number of threads", "[threads]") {
    const Stage list(still_life), tree(still_life, "bvh");
    const CameraFrame frame = camera_frame(list.scene.camera, list.scene.image);
    const auto one = counted_whitted_picture(list.scene, *list.accelerator, frame, {.depth = 6}, {.threads = 1});
    for (const Stage* stage : {&list, &tree})
        for (const int threads : {1, 3}) {
            const auto other =
                counted_whitted_picture(stage->scene, *stage->accelerator, frame, {.depth = 6}, {.threads = threads});
            CHECK(other.image.pixels() == one.image.pixels());
            CHECK(other.rays.primary.cast == one.rays.primary.cast);
            CHECK(other.rays.shadow.cast == one.rays.shadow.cast);
            CHECK(other.rays.shadow.hit == one.rays.shadow.hit);
            CHECK(other.rays.secondary.cast == one.rays.secondary.cast);
            CHECK(other.rays.secondary.hit == one.rays.secondary.hit);
        }
    CHECK(one.rays.primary.cast == 32 * 24);
}

TEST_CASE("Fresnel shares out kr + kt, which may be less than all") {
    const Stage stage(R"(
[material.dim]
diffuse = [0, 0, 0]
kr = 0.3
kt = 0.5
ior = 1.5
[[shape]]
type = "plane"
point = [0, 0, 0]
normal = [0, 0, 1]
material = "dim"
)");
    const auto tree =
        stage.tree({0, 0, 1}, {0, 0, -1}, {.depth = 2, .reflectance = WhittedOptions::Reflectance::fresnel});
    REQUIRE(tree.nodes.size() == 3);
    CHECK_THAT(tree.nodes[1].throughput, WithinRel(0.8 * 0.04, 1e-12));
    CHECK_THAT(tree.nodes[2].throughput, WithinRel(0.8 * 0.96, 1e-12));
}

TEST_CASE("rays leave a smooth mesh on their own side of its triangles, however its normals are smoothed") {
    Stage stage(glass + "[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"glass\"\n");
    RandomSequence random(5, 0);
    for (int i = 0; i < 300; ++i) {
        auto mesh = std::make_shared<Mesh>();
        mesh->vertices = {{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}};
        mesh->faces = {{0, 1, 2}};
        for (int vertex = 0; vertex < 3; ++vertex)  // up to 80 degrees off the triangle's own
            mesh->normals.push_back(
                convert<float>(glm::normalize(Vec3d{random.between(-4, 4), random.between(-4, 4), 1})));
        stage.scene.objects[0].shape = std::shared_ptr<const Mesh>(mesh);
        stage.scene.materials[stage.scene.objects[0].front].kr = 0.5;
        stage.scene.materials[stage.scene.objects[0].front].kt = 0.5;
        stage.accelerator = make_accelerator("list", stage.scene);
        const double side = random.whole(0, 1) * 2 - 1;
        const Vec3d from{random.between(-4, 4), random.between(-4, 4), side * random.between(0.2, 3)};
        const auto tree = stage.tree(from, glm::normalize(Vec3d{0, -3, 0} - from), {.depth = 2});
        for (const auto& node : tree.nodes) {
            if (node.kind == RayKind::reflected) CHECK(node.ray.direction.z * side > 0);
            if (node.kind == RayKind::transmitted && node.ended != Ending::total_internal_reflection)
                CHECK(node.ray.direction.z * side < 0);
        }
    }
}

TEST_CASE("a smooth normal that looks away bends nothing: the triangle's own does") {
    Stage stage(glass + "[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"glass\"\n");
    auto mesh = std::make_shared<Mesh>();
    mesh->vertices = {{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}};
    mesh->faces = {{0, 1, 2}};
    mesh->normals.assign(3, convert<float>(glm::normalize(Vec3d{1, 0, -0.1})));
    stage.scene.objects[0].shape = std::shared_ptr<const Mesh>(mesh);
    stage.accelerator = make_accelerator("list", stage.scene);
    const auto tree =
        stage.tree({0, 0, 1}, {0, 0, -1}, {.depth = 2, .reflectance = WhittedOptions::Reflectance::fresnel});
    const auto through = of_kind(tree, RayKind::transmitted);
    REQUIRE(through.size() == 1);
    CHECK(through[0].ray.direction == Vec3f{0, 0, -1});
    CHECK_THAT(through[0].throughput, WithinRel(0.96, 1e-12));
}

TEST_CASE("no pixel is ever anything but a number") {
    RandomSequence random(3, 0);
    for (int i = 0; i < 30; ++i) {
        Stage stage(still_life);
        for (auto& material : stage.scene.materials) {
            material.kr = random.next();
            material.kt = random.whole(0, 1) * (1 - material.kr);
            material.ior = std::pow(10.0, random.between(-3, 3) * (i % 3 == 0 ? 100 : 1));
            material.shininess = std::pow(10.0, random.between(0, 6));
        }
        stage.scene.lights.push_back({PointLight{{1, 1, 0.5}}});  // in the middle of the glass ball
        stage.scene.lights.push_back({PointLight{{1, 2, 0.5}}, {1, 1, 1}, {0, 0, 1}});  // on it
        const WhittedOptions options{
            .depth = 5,
            .reflectance = i % 2 == 0 ? WhittedOptions::Reflectance::constant : WhittedOptions::Reflectance::fresnel};
        for_each_eye_ray(stage, [&](const Ray& ray) {
            const Color color = ray_tree(stage.scene, *stage.accelerator, options, ray).pixel;
            CHECK((std::isfinite(color.x) && std::isfinite(color.y) && std::isfinite(color.z)));
        });
    }
}
