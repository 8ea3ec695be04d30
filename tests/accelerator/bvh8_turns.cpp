#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/bvh8/bvh8.h"
#include "raylab/experiment/adversarial/adversarial_rays.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/experiment/generate/generate.h"

using namespace raylab;
using namespace raylab::adversarial;

namespace {

using Hits = std::vector<std::optional<Hit>>;

// What differs from the counts of rays that are asked alone.
std::string difference(const TestCounts& counts, const TestCounts& together) {
    if (together.steps != counts.steps || together.box_tests != counts.box_tests) return "nodes";
    if (together.primitive_tests != counts.primitive_tests) return "primitives";
    if (together.exact_decisions != counts.exact_decisions) return "exact decisions";
    return "";
}

// What differs from the answers, and the counts, of rays that are asked alone (by Accelerator::closest_of()).
std::string difference(const Hits& alone, const TestCounts& counts, const Hits& hits, const TestCounts& together) {
    if (hits.size() != alone.size()) return "an answer is missing";
    for (std::size_t i = 0; i < hits.size(); ++i)
        if (!same(hits[i], alone[i])) return fmt::format("ray {}", i);
    return difference(counts, together);
}

// The same of rays that are asked for any hit.
std::string difference(const std::vector<bool>& alone, const TestCounts& counts, const std::vector<bool>& occluded,
                       const TestCounts& together) {
    return occluded == alone ? difference(counts, together) : "whether there is a hit";
}

Ray any_ray(Draw& draw, const SceneRays& rays) {
    Ray ray =
        rays.draw(draw, static_cast<std::size_t>(draw.integer(0, static_cast<int>(SceneRays::kinds().size()) - 1)));
    if (draw.one_in(50)) ray.direction = Vec3f(0);
    if (draw.one_in(10))
        ray.range = {draw.uniform(-0.1f, 0.5f), draw.uniform(0, 2)};  // in doubles, if it begins before 0
    return ray;
}

// Rays are asked one after the other, and in turns that end at each step, at some, and at none.
std::optional<std::string> compare_turns(Draw& draw, const Scene& scene) {
    const Bvh8 tree(scene);
    const SceneRays scene_rays(scene);
    std::vector<Ray> rays;
    const int count = draw.one_in(5) ? draw.integer(0, 9) : draw.integer(10, 60);
    for (int i = 0; i < count; ++i) {
        rays.push_back(any_ray(draw, scene_rays));
        // Some leave what another one has hit.
        if (i == 0 || !draw.one_in(4)) continue;
        Traversal traversal;
        if (const auto hit = tree.closest(rays[static_cast<std::size_t>(i) - 1], traversal))
            rays.back().leaving = hit->primitive;
    }
    Traversal alone, alone_for_any;
    const Hits expected = tree.Accelerator::closest_of(rays, alone);
    const std::vector<bool> occluded = tree.Accelerator::occluded_of(rays, alone_for_any);
    for (const std::size_t near_bytes : {std::size_t{0}, std::size_t{500}, ~std::size_t{0}}) {
        Traversal together, together_for_any;
        const Hits hits = tree.closest_in_turns(rays, near_bytes, together);
        std::string differs = difference(expected, alone, hits, together);
        if (!differs.empty()) return fmt::format("{} with {} bytes near", differs, near_bytes);
        differs = difference(occluded, alone_for_any, tree.occluded_in_turns(rays, near_bytes, together_for_any),
                             together_for_any);
        if (!differs.empty()) return fmt::format("any hit: {} with {} bytes near", differs, near_bytes);
    }
    return std::nullopt;
}

}  // namespace

TEST_CASE("rays that take turns have the answers and counts of rays asked alone") {
    const auto kinds = every_scene_kind();
    std::size_t number = 0;
    const auto compare = [&](Draw& draw) { return compare_turns(draw, kinds[number++ % kinds.size()].make(draw)); };
    CHECK(faults(4000, compare) == "");
}

// (The tree has 12 MB: see Bvh8::wait_for_memory().)
TEST_CASE("rays asked together in a large tree have the answers and counts of rays asked alone") {
    Scene scene = scene_of({});
    scene.objects = {object(std::make_shared<const Mesh>(bumpy_sphere(7)))};
    const Bvh8 tree(scene);
    Draw draw(5);
    for (const bool apart : {true, false}) {
        std::vector<Ray> rays;
        for (int i = 0; i < 3000; ++i) {
            const Vec3f origin = apart ? draw.in_cube(1.2f) : Vec3f(0, 0, 3) + draw.in_cube(0.01f);
            rays.push_back({origin, apart ? draw.in_cube(1) : draw.in_cube(1) - origin});
        }
        Traversal alone, together;
        const Hits expected = tree.Accelerator::closest_of(rays, alone);
        const Hits hits = tree.closest_of(rays, together);
        CHECK(difference(expected, alone, hits, together) == "");
        Traversal alone_for_any, together_for_any;
        const auto occluded = tree.Accelerator::occluded_of(rays, alone_for_any);
        CHECK(difference(occluded, alone_for_any, tree.occluded_of(rays, together_for_any), together_for_any) == "");
    }
}
