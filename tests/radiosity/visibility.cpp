#include "catch.h"
#include "rooms.h"

#include "raylab/radiosity/form_factor/contour_form_factor.h"
#include "raylab/radiosity/patch_form_factors.h"

using namespace raylab;

namespace {

// The scene turned by any angles and moved far from the origin, where floats are coarse.
Scene turned(Scene scene) {
    Affine placement;
    placement.columns = {Vec3f{0.8f, 0.36f, 0.48f}, Vec3f{-0.6f, 0.48f, 0.64f}, Vec3f{0, -0.8f, 0.6f}};
    placement.translation = {17.3f, -9.1f, 5.7f};
    for (Object& object : scene.objects) object.placement = placement;
    return scene;
}

Scene inside_of_ball() {
    Scene scene;
    scene.materials = {{.diffuse = Color(0.5)}};
    scene.objects = {{.shape = Sphere{{0, 0, 0}, 1}, .sides = Sides::back}};
    return scene;
}

}  // namespace

// A ray that ends on a patch at a slant must not meet that patch's own plane, or a neighbour's, before its end.
TEST_CASE("in a convex room no shadow ray between patches is stopped, however slanted") {
    struct Room {
        Scene scene;
        double edge, stopped;  // the share of pairs of patches for which a ray is stopped
    };
    // Moved and rounded, the ball's facets have corners that lie in no plane, and some hide a neighbour's rim.
    for (const auto& [scene, edge, most] :
         {Room{cube_room(0.5), 0.25, 0}, Room{turned(cube_room(0.5)), 0.25, 0}, Room{inside_of_ball(), 0.5, 0},
          Room{turned(inside_of_ball()), 0.8, 2e-4}}) {
        const PatchMesh mesh = patch_mesh(scene, {.edge = edge});
        const PatchVisibility visibility(mesh);
        Traversal traversal;
        std::size_t pairs = 0, stopped = 0;
        for (std::uint32_t i = 0; i < mesh.patches.size(); ++i)
            for (std::uint32_t j = 0; j < mesh.patches.size(); ++j) {
                if (i == j || !face_each_other(mesh.patches[i], mesh.patches[j])) continue;
                ++pairs;
                if (visibility.share(i, j, 16, traversal).share < 1) ++stopped;
            }
        CHECK(pairs > 5000);
        CHECK(static_cast<double>(stopped) <= most * static_cast<double>(pairs));
    }
}

TEST_CASE("a patch under a box without a bottom sees its inside, which has no patches") {
    Scene scene = cube_room(0.5);
    add_box_without_bottom(scene);
    const PatchMesh mesh = patch_mesh(scene, {.edge = 0.125});
    const PatchVisibility visibility(mesh);
    Traversal traversal;
    for (std::uint32_t i = 0; i < mesh.patches.size(); ++i) {
        const Vec3d& at = mesh.patches[i].center;
        const bool below = at.y == 0 && std::max(std::abs(at.x - 0.5), std::abs(at.z - 0.5)) < 0.25;
        CHECK(visibility.surroundings({i, mesh.patches[i]}, 16, traversal).with_patches == (below ? 0 : 1));
    }
}

// A floor and a wall that share an edge. A screen across the room hides the far pairs of points, which exchange little;
// the truth is Lambert's formula at 250 000 points of the floor, each with the part of the wall that it sees.
TEST_CASE("shadow rays count by what their points would exchange, so near pairs that see each other are not lost") {
    Scene scene = cube_room(0.5);
    scene.objects.resize(3);
    scene.objects.erase(scene.objects.begin() + 1);  // the floor, y = 0, and the wall x = 0
    constexpr double at = 0.4, height = 0.5;         // the screen x = 0.4 stands up to this height
    scene.objects.push_back({.shape = float_rectangle({0.4f, 0, 0}, {0, 0.5f, 0}, {0, 0, 1}),
                             .front = 0,
                             .back = 0,
                             .sides = Sides::front});
    const PatchMesh mesh = patch_mesh(scene, {.edge = 1});
    double truth = 0, in_full_view = 0;
    constexpr int n = 500;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const Vec3d point{(i + 0.5) / n, 0, (j + 0.5) / n};
            // Over the screen a point behind it sees the wall from this height on.
            const double from = point.x > at ? std::min(1.0, height * point.x / (point.x - at)) : 0;
            const auto seen = [&](double low) {
                const std::vector<Vec3d> wall{{0, low, 0}, {0, 1, 0}, {0, 1, 1}, {0, low, 1}};
                return low < 1 ? contour_form_factor(point, {0, 1, 0}, wall) / (n * n) : 0;
            };
            truth += seen(from);
            in_full_view += seen(0);
        }
    const PatchVisibility visibility(mesh);
    Traversal traversal;
    CHECK(visibility.share(0, 1, 20'000, traversal).share == Approx(truth / in_full_view).epsilon(0.03));
    double of_eight = 0;
    for (std::uint64_t k = 0; k < 500; ++k)
        of_eight +=
            visibility.share({0, mesh.patches[0]}, {1, mesh.patches[1]}, 8, shifts_of_pair(k, 7), traversal).share /
            500;
    // The worst there is, patches that touch: among eight pairs few are near enough. Counted alike, they say 0.24.
    CHECK(of_eight > 0.75 * truth / in_full_view);
}

TEST_CASE("nothing hides in a convex room, wherever it stands; a screen, a box or a wall that is moved inwards does") {
    const auto nothing_hides = [](const Scene& scene) {
        const PatchMesh mesh = patch_mesh(scene, {.edge = 0.5});
        return PatchVisibility(mesh).nothing_hides();
    };
    CHECK(nothing_hides(cube_room(0.5)));
    CHECK(nothing_hides(turned(cube_room(0.5))));
    Scene open = cube_room(0.5), screen = open, box = open, moved = open;
    open.objects.erase(open.objects.begin() + 4);
    CHECK(nothing_hides(open));
    screen.objects.push_back({.shape = float_rectangle({0.3f, 0.4f, 0.3f}, {0, 0, 0.4f}, {0.4f, 0, 0})});
    CHECK_FALSE(nothing_hides(screen));
    add_box_without_bottom(box);
    CHECK_FALSE(nothing_hides(box));
    moved.objects[5].shape = float_rectangle({0, 0, 0.99999f}, {0, 1, 0}, {1, 0, 0});
    CHECK_FALSE(nothing_hides(moved));
}

TEST_CASE("where nothing hides no shadow ray is cast, and the form factors are the same") {
    const PatchMesh mesh = patch_mesh(cube_room(0.5), {.edge = 0.25});
    const PatchVisibility visibility(mesh);
    const auto none = patch_form_factors(mesh, visibility, {.rays = 0}),
               eight = patch_form_factors(mesh, visibility, {});
    CHECK(eight.work.rays == 0);
    CHECK(eight.factors.at(0, 20) == none.factors.at(0, 20));
}
