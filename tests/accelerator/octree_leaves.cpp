#include "raylab/accelerator/octree/octree.h"

#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"

#include <algorithm>
#include <cmath>

// Tests of the leaves that a ray visits.

using namespace raylab;
using namespace raylab::adversarial;

namespace {

constexpr OctreeLimits::Seads seads{.largest = 20, .bits = 3};

const Box& box_of(const Bound& bound) { return std::get<Box>(bound); }

Box common(const Box& a, const Box& b) {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = std::max(a.min[axis], b.min[axis]);
        box.max[axis] = std::min(a.max[axis], b.max[axis]);
    }
    return box;
}

// The t at which the ray is surely inside a box: the ends are moved inward by 2^-20, which is more than any rounding.
std::optional<Interval<double>> surely_inside(const Ray& ray, const Box& box) {
    Interval<double> t{ray.range.min, ray.range.max};
    for (int axis = 0; axis < 3; ++axis) {
        double in = (double{box.min[axis]} - ray.origin[axis]) / ray.direction[axis];
        double out = (double{box.max[axis]} - ray.origin[axis]) / ray.direction[axis];
        if (in > out) std::swap(in, out);
        t = {std::max(t.min, in), std::min(t.max, out)};
    }
    if (!(t.max - t.min > 1e-5 * (std::abs(t.min) + std::abs(t.max)))) return std::nullopt;
    return t;
}

// Leaves reach out of the scene's box, but a ray is followed only inside it.
std::vector<Visit> visits_of_leaves(const Outline& outline, const Box& all, const Ray& ray, double end) {
    struct Crossed {
        double t;
        const Outline::Node* leaf;
    };
    std::vector<Crossed> crossed;
    for (const Outline::Node& node : outline.nodes) {
        if (!node.children.empty()) continue;
        const auto inside = surely_inside(ray, common(box_of(node.bound), all));
        if (inside && inside->max < end) crossed.push_back({inside->min, &node});
    }
    std::ranges::sort(crossed, {}, &Crossed::t);
    std::vector<Visit> visits;
    for (const Crossed& c : crossed) {
        const std::size_t tests = c.leaf->primitives.size();
        visits.push_back({c.leaf->bound, tests == 0 ? Visit::Kind::empty : Visit::Kind::leaf, tests});
    }
    return visits;
}

bool same_visit(const Visit& a, const Visit& b) {
    const Box &in_a = box_of(a.bound), &in_b = box_of(b.bound);
    return in_a.min == in_b.min && in_a.max == in_b.max && a.kind == b.kind && a.tests == b.tests;
}

// Whether all of `part` is in `whole`, in that order.
bool in_order(const std::vector<Visit>& part, const std::vector<Visit>& whole) {
    auto next = whole.begin();
    for (const Visit& visit : part) {
        next = std::find_if(next, whole.end(), [&](const Visit& v) { return same_visit(v, visit); });
        if (next == whole.end()) return false;
        ++next;
    }
    return true;
}

template <class Structure>
std::string leaves_passed_over(const OctreeLimits& limits) {
    Draw scene_draw(5);
    const Scene scene = scene_of(soup(scene_draw, 300, 2));
    const Structure octree(scene, limits);
    const Outline outline = octree.outline();
    const Box all = *bounds(scene.objects[0].shape);
    return faults(2'000, [&](Draw& draw) -> std::optional<std::string> {
        const Ray ray = through(draw.in_cube(4), convert<double>(draw.in_cube(2)));
        Traversal traversal;
        const auto hit = octree.closest(ray, traversal);
        const auto visits = octree.visits(ray);
        if (traversal.steps < visits.size()) return "more leaves than steps: " + words(ray);
        const auto expected = visits_of_leaves(outline, all, ray, hit ? hit->t : 1e30);
        return in_order(expected, visits) ? std::nullopt : std::optional(words(ray));
    });
}

}  // namespace

TEST_CASE("no leaf that a ray surely goes through is passed over, and they come in order") {
    CHECK(leaves_passed_over<Octree>({.few = 2}) == "");
    CHECK(leaves_passed_over<OctreePoint>({.few = 2}) == "");
    CHECK(leaves_passed_over<OctreeHash>({.few = 2}) == "");
    CHECK(leaves_passed_over<OctreeSeads>({.few = 2}) == "");
    CHECK(leaves_passed_over<OctreeSeads>({.few = 2, .seads = seads}) == "");
}

TEST_CASE("one octree, four ways: the same leaves one after the other") {
    Draw scene_draw(5);
    const Scene scene = scene_of(soup(scene_draw, 300, 2));
    const OctreeLimits limits{.few = 3, .depth = 9};
    const Octree by_times(scene, limits);
    const OctreePoint by_points(scene, limits);
    const OctreeHash by_names(scene, limits);
    const OctreeSeads by_blocks(scene, limits);
    const auto judge = [&](Draw& draw) -> std::optional<std::string> {
        const Ray ray = through(draw.in_cube(4), convert<double>(draw.in_cube(2)));
        const auto expected = by_times.visits(ray);
        const bool same = std::ranges::equal(expected, by_points.visits(ray), same_visit) &&
                          std::ranges::equal(expected, by_names.visits(ray), same_visit) &&
                          std::ranges::equal(expected, by_blocks.visits(ray), same_visit);
        return same ? std::nullopt : std::optional(words(ray));
    };
    CHECK(faults(3'000, judge) == "");
}
