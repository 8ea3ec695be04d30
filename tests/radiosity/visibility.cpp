#include "catch.h"
#include "rooms.h"

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
                if (visibility.share(i, j, 16, traversal) < 1) ++stopped;
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
        CHECK(visibility.share_with_patches({i, mesh.patches[i]}, 16, traversal) == (below ? 0 : 1));
    }
}
