#include "catch.h"

#include "raylab/experiment/adversarial/adversarial_rays.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/tracer/shading/any_surface.h"

#include <cstring>
#include <set>

using namespace raylab;

namespace {

bool same_bits(const SurfacePoint& a, const SurfacePoint& b) { return std::memcmp(&a, &b, sizeof(SurfacePoint)) == 0; }

// Shapes of every kind, some at rest, some placed, and a mesh with normals.
Scene any_scene(adversarial::Draw& draw) {
    Scene scene = adversarial::any_scene(draw, 6);
    Mesh mesh{.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0.5f}}, .faces = {{0, 1, 2}, {2, 3, 0}}};
    mesh.normals = {{0, 0, 1}, {0.6f, 0, 0.8f}, {0, -0.6f, 0.8f}, {0, 0, 3}};
    scene.objects.push_back(adversarial::object(adversarial::any_annulus(draw), adversarial::any_placement(draw)));
    scene.objects.push_back(adversarial::object(std::make_shared<const Mesh>(std::move(mesh)),
                                                draw.one_in(2) ? Affine{} : adversarial::any_placement(draw)));
    return scene;
}

}  // namespace

TEST_CASE("a surface prepared for many rays says of each of them what one that is hit once says, to the bit") {
    adversarial::Draw draw(1);
    std::set<std::size_t> at_rest, placed;
    for (int scenes = 0; scenes < 100; ++scenes) {
        const Scene scene = any_scene(draw);
        const auto list = make_accelerator("list", scene);
        const AnySurface once(scene, *list);
        const PreparedSurfaces prepared(scene, *list);
        const adversarial::SceneRays rays(scene);
        for (std::size_t i = 0; i < 100; ++i) {
            const Ray ray = rays.draw(draw, i % adversarial::SceneRays::kinds().size());
            Traversal traversal;
            const auto hit = once.closest(ray, traversal);
            if (!hit) continue;
            INFO("scene " << scenes << ", object " << hit->primitive.object);
            REQUIRE(same_bits(prepared.point(ray, *hit), once.point(ray, *hit)));
            const Object& object = scene.objects[hit->primitive.object];
            (object.placement.is_identity() ? at_rest : placed).insert(object.shape.index());
        }
    }
    CHECK(at_rest.size() == std::variant_size_v<Shape>);
    CHECK(placed.size() == std::variant_size_v<Shape>);
}
