#include "scenes.h"

#include "catch.h"

#include "raylab/tracer/media/eye_media.h"

#include <cmath>
#include <memory>
#include <numbers>

using namespace raylab;
using namespace raylab::test;

namespace {

const WhittedOptions by_fresnel{.depth = 12, .reflectance = WhittedOptions::Reflectance::fresnel};

// The transmitted rays one after another, as indices of nodes: how a ray goes through.
std::vector<std::size_t> way_through(const RayTree& tree) {
    std::vector<std::size_t> way{0};
    for (std::size_t i = 1; i < tree.nodes.size(); ++i)
        if (tree.nodes[i].kind == RayKind::transmitted && tree.nodes[i].parent == way.back() &&
            tree.nodes[i].ended != Ending::depth && tree.nodes[i].ended != Ending::total_internal_reflection)
            way.push_back(i);
    return way;
}

std::vector<RayNode> straight_through(const RayTree& tree) {
    std::vector<RayNode> path;
    for (const std::size_t i : way_through(tree)) path.push_back(tree.nodes[i]);
    return path;
}

// The share that the surface at this ray's end reflects; 0: it has sent no ray back.
double reflected_share(const RayTree& tree, std::size_t node) {
    for (const auto& child : tree.nodes)
        if (child.kind == RayKind::reflected && child.parent == node)
            return child.throughput / tree.nodes[node].throughput;
    return 0;
}

const std::string slab = glass + R"(
[[shape]]
type = "cylinder"
base = [0, -1, 0]
top = [0, 0, 0]
radius = 100
ends = "capped"
material = "glass"
)";

}  // namespace

TEST_CASE("a glass slab shifts a ray aside and leaves its direction") {
    const double angle = 60 * std::numbers::pi / 180;
    const Vec3d direction{std::sin(angle), -std::cos(angle), 0};
    const auto path = straight_through(Stage(slab).tree(-direction, direction));
    REQUIRE(path.size() == 3);  // to the slab, in it, behind it
    CHECK(glm::length(convert<double>(path[2].ray.direction) - direction) < 1e-6);
    const Vec3d out = path[1].point;
    CHECK_THAT(glm::length(out - dot(out, direction) * direction), WithinAbs(0.512472013191, 1e-6));
}

TEST_CASE("a slab reflects and transmits what the sum over all its bounces says") {
    // r = .04 at each side: R = 2 r / (1 + r), T = (1 - r) / (1 + r); it glows red below and blue above.
    const Stage stage(slab + R"(
[[shape]]
type = "plane"
point = [0, -2, 0]
normal = [0, 1, 0]
material = "red"
[[shape]]
type = "plane"
point = [0, 5, 0]
normal = [0, 1, 0]
material = "blue"
[material.red]
diffuse = [0, 0, 0]
emission = [1, 0, 0]
[material.blue]
diffuse = [0, 0, 0]
emission = [0, 0, 1]
)");
    const Color pixel = stage.tree({0, 1, 0}, {0, -1, 0}, by_fresnel).pixel;
    CHECK_THAT(pixel.x, WithinAbs(.9230769231, 1e-7));
    CHECK_THAT(pixel.z, WithinAbs(.0769230769, 1e-7));
}

TEST_CASE("a bubble of air in glass is entered and left, and so is the glass") {
    const Stage stage(glass + R"(
[material.air]
diffuse = [0, 0, 0]
kt = 1
ior = 1
priority = 1
[[shape]]
type = "sphere"
center = [0, 0, 0]
radius = 1
material = "glass"
[[shape]]
type = "sphere"
center = [0, 0, 0]
radius = 0.5
material = "air"
)");
    const auto tree = stage.tree({0.25, 0, 5}, {0, 0, -1}, by_fresnel);
    const auto path = straight_through(tree);
    REQUIRE(path.size() == 5);
    // About one centre n r sin(angle) stays: the index and the distance of the ray's line from the centre.
    const double iors[] = {1, 1.5, 1, 1.5, 1};
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Vec3d o = convert<double>(path[i].ray.origin), d = convert<double>(path[i].ray.direction);
        CHECK_THAT(iors[i] * glm::length(cross(o, d)), WithinAbs(0.25, 1e-6));
    }
}

TEST_CASE("where water overlaps glass, the priority decides what lies behind what") {
    const std::string both = glass + R"(
[material.water]
diffuse = [0, 0, 0]
kt = 1
ior = 1.33
[[shape]]
type = "cylinder"
base = [0, -3, 0]
top = [0, -0.8, 0]
radius = 100
ends = "capped"
material = "water"
)";
    const Stage stage(both + "\n[[shape]]\ntype = \"cylinder\"\nbase = [0, -1, 0]\ntop = [0, 0, 0]\nradius = "
                             "100\nends = \"capped\"\nmaterial = \"strong\"\n[material.strong]\ndiffuse = [0, 0, "
                             "0]\nkt = 1\nior = 1.5\npriority = 1\n");
    const auto tree = stage.tree({0, 1, 0}, {0, -1, 0}, by_fresnel);
    const auto path = straight_through(tree);
    const auto way = way_through(tree);
    REQUIRE(path.size() ==
            5);  // to the glass; to the water's top, hidden in glass; to the glass's end; in water; below
    CHECK_THAT(path[1].point.y, WithinAbs(-0.8, 1e-6));
    CHECK(reflected_share(tree, way[1]) == 0);
    CHECK_THAT(path[2].point.y, WithinAbs(-1, 1e-6));
    CHECK_THAT(reflected_share(tree, way[2]), WithinRel(std::pow(.17 / 2.83, 2), 1e-9));  // .00360848, not .04
    CHECK_THAT(reflected_share(tree, way[3]), WithinRel(std::pow(.33 / 2.33, 2), 1e-9));
}

TEST_CASE("an eye inside glass leaves it") {
    const Stage stage(glass + "[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"glass\"\n");
    const auto through = straight_through(stage.tree({0.5, 0, 0}, {0, 0, 1}, by_fresnel));
    REQUIRE(through.size() == 2);
    const Ray& ray = through[1].ray;
    CHECK_THAT(glm::length(cross(convert<double>(ray.origin), convert<double>(ray.direction))),
               WithinAbs(1.5 * 0.5, 1e-6));
    const auto kept = stage.tree({0.8, 0, 0}, {0, 0, 1}, by_fresnel);  // 1.5 * 0.8 > 1
    CHECK(of_kind(kept, RayKind::reflected).size() == 12);             // the last one cut off by the depth
    CHECK(of_kind(kept, RayKind::transmitted).back().ended == Ending::total_internal_reflection);
}

TEST_CASE("an eye inside nested media knows them all") {
    // Air, glass, air, glass about the eye: about one centre n r sin(angle) stays.
    std::string text = glass + "[material.air]\ndiffuse = [0, 0, 0]\nkt = 1\n";
    for (int radius = 4; radius >= 1; --radius)
        text += "[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = " + std::to_string(radius) +
                "\nmaterial = \"" + (radius % 2 == 0 ? "glass" : "air") + "\"\n";
    text += "[[shape]]\ntype = \"sphere\"\ncenter = [9, 0, 0]\nradius = 3\nmaterial = \"glass\"\n";  // not around it
    const Stage stage(text);
    const auto path = straight_through(stage.tree({0.5, 0, 0}, {0, 0, 1}, by_fresnel));
    REQUIRE(path.size() == 5);
    const double iors[] = {1, 1.5, 1, 1.5, 1};
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Vec3d o = convert<double>(path[i].ray.origin), d = convert<double>(path[i].ray.direction);
        CHECK_THAT(iors[i] * glm::length(cross(o, d)), WithinAbs(0.5, 1e-6));
    }
    CHECK(ior_of(media_at(stage.scene, *stage.accelerator, {9, 0, 0}).current(stage.scene), stage.scene) == 1.5);
    CHECK(media_at(stage.scene, *stage.accelerator, {0, 50, 0}).current(stage.scene) == nullptr);
}

TEST_CASE("an eye inside a glass mesh leaves it, too, though nobody has asked whether it is closed") {
    Stage stage(glass + "[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"glass\"\n");
    auto mesh = std::make_shared<Mesh>();
    mesh->vertices = {{-9, -9, 1}, {9, -9, 1}, {0, 9, 1}, {0, 0, -9}};
    mesh->faces = {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}};
    stage.scene.objects[0].shape = std::shared_ptr<const Mesh>(mesh);
    stage.accelerator = make_accelerator("list", stage.scene);
    const auto through = straight_through(stage.tree({0, 0, 0}, {0.48f, 0, 0.877f}, by_fresnel));
    REQUIRE(through.size() == 2);
    CHECK_THAT(through[1].ray.direction.x, WithinAbs(1.5 * 0.48 / std::hypot(0.48, 0.877), 1e-6));
}

TEST_CASE("surfaces that lie in one another end, too") {
    const std::string one = "[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"glass\"\n";
    const std::string pane = "[[shape]]\ntype = \"disk\"\ncenter = [0, 0, 2]\nnormal = [0, 0, 1]\nradius = "
                             "3\nmaterial = \"glass\"\n";
    const Stage stage(glass + one + one + one + pane + pane + pane + one);
    for (const double x : {0.0, 0.3, 0.9, 0.999}) {
        const auto tree = stage.tree({x, 0, 5}, {0, 0, -1}, by_fresnel);
        CHECK(tree.nodes.size() < 100'000);
        const auto back = stage.tree({x, 0, 0}, {0, 0, 1}, by_fresnel);
        CHECK(back.nodes.size() < 100'000);
    }
}

TEST_CASE("thousands of surfaces may be hidden in a stronger medium") {
    Stage stage(glass + "[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 9\nmaterial = \"glass\"\n");
    stage.scene.materials[stage.scene.objects[0].front].priority = 1;
    stage.scene.materials.push_back({.name = "weak", .kt = 1, .ior = 1.2});
    for (int i = 0; i < 8'000; ++i)  // a string of beads
        stage.scene.objects.push_back({.shape = Sphere{{0, 0, static_cast<float>(i - 4'000) * 5e-4f}, 2e-4f},
                                       .placement = {},
                                       .front = stage.scene.materials.size() - 1,
                                       .back = stage.scene.materials.size() - 1});
    stage.accelerator = make_accelerator("bvh", stage.scene);
    const auto path = straight_through(stage.tree({0, 0, 20}, {0, 0, -1}, {.depth = 3}));
    CHECK(path.size() > 16'000);
    CHECK(path.back().depth == 3);
}

TEST_CASE("a ray that finds its own surface again and again ends, too") {
    const Stage stage(glass + "[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"glass\"\n");
    WhittedOptions careless = by_fresnel;
    careless.start = ray_start_from_words("none");
    for (int i = 0; i < 100; ++i) CHECK(stage.tree({i / 100.0, 0, 5}, {0, 0, -1}, careless).nodes.size() < 100'000);
}

TEST_CASE("what was entered last counts among equals, what has the highest priority before all") {
    Scene scene;
    scene.materials = {{.name = "weak", .ior = 1.1}, {.name = "strong", .ior = 1.2, .priority = 1}};
    scene.objects.resize(3);
    scene.objects[1].front = 1;
    const Object *a = &scene.objects[0], *strong = &scene.objects[1], *b = &scene.objects[2];
    CHECK(Media{}.current(scene) == nullptr);
    CHECK(ior_of(Media{}.current(scene), scene) == 1);
    const Media all = Media{}.entered(a).entered(strong).entered(b);
    CHECK(all.current(scene) == strong);
    CHECK(all.left(strong).current(scene) == b);
    CHECK(all.left(strong).left(b).current(scene) == a);
    CHECK(all.left(strong).left(a).current(scene) == b);
    CHECK(all.left(a).left(b).left(strong).current(scene) == nullptr);
    CHECK(Media{}.left(a).current(scene) == nullptr);
    CHECK(Media{}.entered(a).entered(b).entered(a).left(a).current(scene) == b);
}
