#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/bvh8/ray_in_mesh.h"
#include "raylab/experiment/adversarial/adversarial_rays.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/generate/loose_triangles.h"
#include "raylab/geometry/transformed_ray.h"
#include "raylab/number/dyadic.h"

#include <cmath>

// Placed meshes share a tree: rays are carried into the mesh and rounded there, and no answer depends on the rounding.

using namespace raylab;
using namespace raylab::adversarial;

namespace {

using SharedMesh = std::shared_ptr<const Mesh>;

SharedMesh any_mesh(Draw& draw) {
    if (draw.one_in(2)) return std::make_shared<const Mesh>(bumpy_sphere(1));
    if (draw.one_in(2)) return mesh_of(floor_of(5));
    return mesh_of(soup(draw, 60, 3));
}

// Large and small, far away, nearly flat.
Affine any_place(Draw& draw) {
    Affine placement = any_placement(draw);
    const auto scale = [&](float by) {
        for (Vec3f& column : placement.columns) column = column * by;
    };
    if (draw.one_in(3)) scale(std::ldexp(1.0f, draw.integer(-30, 30)));
    if (draw.one_in(6)) placement.columns[static_cast<std::size_t>(draw.integer(0, 2))] *= 0x1p-16f;
    if (draw.one_in(3)) placement.translation = draw.in_cube(std::ldexp(1.0f, draw.integer(0, 30)));
    return placement;
}

Scene any_scene_of_instances(Draw& draw) {
    Scene scene;
    const std::vector<SharedMesh> meshes{any_mesh(draw), any_mesh(draw)};
    const int count = draw.integer(1, 6);
    for (int i = 0; i < count; ++i) {
        scene.objects.push_back(object(meshes[draw.one_in(2) ? 1 : 0], any_place(draw)));
        scene.objects.back().sides = any_sides(draw);
    }
    if (draw.one_in(2)) scene.objects.push_back(scene.objects[0]);  // each hit is a tie
    if (draw.one_in(3)) scene.objects.push_back(any_object(draw));
    return scene;
}

Ray any_ray(Draw& draw, const Scene& scene, const SceneRays& rays) {
    Ray ray =
        rays.draw(draw, static_cast<std::size_t>(draw.integer(0, static_cast<int>(SceneRays::kinds().size()) - 1)));
    if (draw.one_in(4)) ray.range = {draw.uniform(-1, 1), draw.uniform(1, 3)};
    if (draw.one_in(4)) ray.leaving = {static_cast<std::uint32_t>(draw.integer(0, 1)), 3};
    if (scene.objects.size() == 1) ray.leaving.object = 0;
    return ray;
}

std::optional<std::string> compare(Draw& draw) {
    const Scene scene = any_scene_of_instances(draw);
    const SceneRays rays(scene);
    const auto list = make_accelerator("list", scene), tree = make_accelerator("bvh8", scene);
    Traversal traversal, remembering;
    remembering.toward(0);
    for (int i = 0; i < 60; ++i) {
        const Ray ray = any_ray(draw, scene, rays);
        const auto hit = list->closest(ray, traversal);
        if (!same(hit, tree->closest(ray, traversal))) return "nearest: " + words(ray);
        if (hit.has_value() != tree->occluded(ray, traversal)) return "any: " + words(ray);
        if (hit.has_value() != tree->occluded(ray, remembering)) return "any, with the last blocker: " + words(ray);
        if (!hit) continue;
        Ray ended = ray, leaving = ray;
        ended.range = tight_range(draw, cast<float>(hit->t));
        leaving.leaving = hit->primitive;
        for (const Ray& other : {ended, leaving})
            if (list->occluded(other, traversal) != tree->occluded(other, traversal)) return "any: " + words(other);
    }
    return std::nullopt;
}

Vec3<Dyadic> at(const Vec3<Dyadic>& origin, const Dyadic& t, const Vec3<Dyadic>& direction) {
    return {origin.x + t * direction.x, origin.y + t * direction.y, origin.z + t * direction.z};
}

// Whether |a| <= |b|, exactly.
bool is_no_larger(const Dyadic& a, const Dyadic& b) { return sign(b * b - a * a) != Sign::negative; }

// The exact point in the mesh is adj(A) (x - b) / det A; both sides are multiplied by det A.
std::optional<std::string> compare_with_exact_ray(Draw& draw) {
    const Affine placement = any_place(draw);
    const auto map = WorldToMesh::inverse_of(placement);
    if (!map) return std::nullopt;
    const Mesh mesh = bumpy_sphere(0);
    const Box box = *bounds(Shape(std::make_shared<const Mesh>(mesh)), placement);
    const Vec3d target = transform_point(placement, convert<double>(draw.in_cube(1)));
    const Vec3f origin = convert<float>(target) + draw.in_cube(std::ldexp(1.0f, draw.integer(-4, 34)));
    const Ray ray{origin, (convert<float>(target) - origin) * std::ldexp(1.0f, draw.integer(-20, 20))};
    const auto found = map->carried(ray, ray.range.max, box);
    if (!found || found->displacement == std::numeric_limits<float>::infinity()) return std::nullopt;
    const auto exact = transformed_ray<Dyadic>(ray, placement);
    const double last = found->from + found->ray.range.max / found->scale;
    for (const double share : {0.0, 0.3, 0.9}) {
        const double t = found->from + share * (last - found->from);
        const Vec3<Dyadic> meant = at(exact.origin, Dyadic(t), exact.direction);
        const Vec3<Dyadic> rounded =
            at(convert<Dyadic>(found->ray.origin), (Dyadic(t) - Dyadic(found->from)) * Dyadic(found->scale),
               convert<Dyadic>(found->ray.direction));
        const Dyadic most = exact.scale * Dyadic(double{found->displacement});
        if (!is_no_larger(meant.x - exact.scale * rounded.x, most) ||
            !is_no_larger(meant.y - exact.scale * rounded.y, most) ||
            !is_no_larger(meant.z - exact.scale * rounded.z, most))
            return words(ray);
    }
    return std::nullopt;
}

std::size_t bytes_of(const SharedMesh& mesh, int instances) {
    Scene scene;
    Draw draw(5);
    for (int i = 0; i < instances; ++i) {
        scene.objects.push_back(object(mesh));
        scene.objects.back().placement.translation = {cast<float>(i + 1), 0, 0};
    }
    return make_accelerator("bvh8", scene)->bytes();
}

}  // namespace

TEST_CASE("bvh8 answers as the list does about meshes at places of their own") { CHECK(faults(600, compare) == ""); }

TEST_CASE("a ray that is carried into a mesh is no farther from the exact one than it says") {
    CHECK(faults(20'000, compare_with_exact_ray) == "");
}

TEST_CASE("rays carried into a mesh are as precise as its floats, however far away it stands") {
    Affine placement;
    placement.columns = {Vec3f{0, 3, 0}, Vec3f{-3, 0, 0}, Vec3f{0, 0, 3}};
    placement.translation = {1e6f, 2e6f, 0};
    const Box box{{1e6f - 3, 2e6f - 3, -3}, {1e6f + 3, 2e6f + 3, 3}};
    const auto found = WorldToMesh::inverse_of(placement)->carried({{0, 0, 0}, {1, 2, 0}}, 1e30, box);
    REQUIRE(found);
    CHECK(found->displacement < 0x1p-20f);
}

TEST_CASE("a mesh that is used often is stored once, with one tree") {
    const auto mesh = std::make_shared<const Mesh>(bumpy_sphere(4));
    const std::size_t one = bytes_of(mesh, 1), thousand = bytes_of(mesh, 1000);
    CHECK(one > 20 * mesh->faces.size());
    CHECK(thousand < one + 1000 * 300);
}
