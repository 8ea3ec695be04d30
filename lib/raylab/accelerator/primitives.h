#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/base/large_pages.h"
#include "raylab/geometry/bounds/hull.h"
#include "raylab/geometry/bounds/reaches_box.h"
#include "raylab/geometry/filter/triangle_quick_reject.h"
#include "raylab/geometry/intersect/nearest.h"
#include "raylab/geometry/intersect/prepared_shape.h"
#include "raylab/scene/moving.h"

#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace raylab {

/// The place of each object's first primitive, meshes taken apart into triangles, in scene order.
std::vector<std::uint32_t> first_places(const Scene& scene);

/// A scene's primitives, meshes taken apart into triangles, in scene order.
std::vector<Primitive> primitives_of(const Scene& scene);

inline Target target_of(const Scene& scene, Primitive primitive) {
    const Object& object = scene.objects[primitive.object];
    return {&object.shape, primitive.part, &object.placement, object.sides, motion_of(scene, object)};
}

/// Offers a hit of a primitive that has been found to `nearest`.
inline void offer(const Scene& scene, Primitive primitive, const Candidate& found, Nearest& nearest,
                  Traversal& traversal) {
    DecisionCounts decisions;
    nearest.offer(
        found, primitive, [&](Primitive tied) { return target_of(scene, tied); }, decisions);
    traversal.exact_decisions += decisions.exact;
}

/// The box about a primitive, of one that moves where it stands at a time of the rays; absent: unbounded.
std::optional<Box> bounds_at(const Scene& scene, Primitive primitive, float time);

/// The box about a primitive over all times of the rays. Every point of it moves along a straight line at constant
/// speed: what holds it at the first and at the last of them holds it always.
std::optional<Box> bounds_of(const Scene& scene, Primitive primitive);

/// The same of several, found by several threads (0: all cores).
std::vector<std::optional<Box>> bounds_of(const Scene& scene, std::span<const Primitive> some, int threads);

/// The primitives of a scene, meshes taken apart into triangles: what every accelerator holds, in the order that suits
/// it, and tests. Triangles and spheres that are not transformed and do not move lie here themselves, all other shapes
/// prepared: the former are most of what is tested.
class Primitives {
public:
    explicit Primitives(const Scene& scene);                          // in scene order
    Primitives(const Scene& scene, std::span<const Primitive> some);  // in their order
    Primitives(const Primitives& all, std::span<const std::uint32_t> order);

    std::size_t size() const { return items_.size(); }
    std::optional<Box> bounds(std::size_t i) const { return bounds_of(*scene_, primitive(i)); }
    std::optional<Box> bounds_at(std::size_t i, float time) const {
        return raylab::bounds_at(*scene_, primitive(i), time);
    }
    Hull hull(std::size_t i) const;  // over all times of the rays; empty: unbounded
    Interval<float> times() const { return ray_times(*scene_); }
    Target target(std::size_t i) const { return target_of(*scene_, items_[i].primitive); }
    Primitive primitive(std::size_t i) const { return items_[i].primitive; }
    std::optional<Triangle> triangle(std::size_t i) const;  // absent: something else, or not at rest where it was made
    std::optional<Sphere> whole_sphere(
        std::size_t i) const;  // absent: something else, placed, moving, or seen from one side only
    std::size_t bytes() const;

    /// Where each stands in scene order: what an Outline has.
    std::vector<std::uint32_t> places() const;

    /// Whether primitive i may reach into a box, grown as `raylab::reaches` wants it: asked where its bounds do.
    bool reaches(std::size_t i, const BoxOfDoubles& box) const;

    /// Offers the hit of primitive i, if there is one, to `nearest`.
    void test(std::size_t i, const Ray& ray, Nearest& nearest, Traversal& traversal) const {
        if (const auto found = candidate(i, ray, traversal)) offer(i, *found, nearest, traversal);
    }

    /// Offers a hit of primitive i that has been found.
    void offer(std::size_t i, const Candidate& found, Nearest& nearest, Traversal& traversal) const {
        raylab::offer(*scene_, items_[i].primitive, found, nearest, traversal);
    }

    /// The hit of primitive i, which no other is compared with yet.
    std::optional<Candidate> candidate(std::size_t i, const Ray& ray, Traversal& traversal) const {
        if (is_left_by(items_[i], ray)) return std::nullopt;
        ++traversal.primitive_tests;
        return counted_intersection(items_[i], ray, traversal);
    }

    /// Whether the ray hits primitive i.
    bool hits(std::size_t i, const Ray& ray, Traversal& traversal) const {
        if (is_left_by(items_[i], ray)) return false;
        ++traversal.primitive_tests;
        return counted_intersection(items_[i], ray, traversal).has_value();
    }

    /// What many of them cost less with, and counts and answers are the same: a look that is prepared once for a ray.
    TriangleQuickReject quick_reject(const Ray& ray) const { return TriangleQuickReject(ray, triangles_); }
    void test(std::size_t i, const Ray& ray, const TriangleQuickReject& quick_reject, Nearest& nearest,
              Traversal& traversal) const {
        if (!is_rejected_early(items_[i], ray.leaving, quick_reject, traversal.primitive_tests))
            test(i, ray, nearest, traversal);
    }
    bool hits(std::size_t i, const Ray& ray, const TriangleQuickReject& quick_reject, Traversal& traversal) const {
        return !is_rejected_early(items_[i], ray.leaving, quick_reject, traversal.primitive_tests) &&
               hits(i, ray, traversal);
    }

    /// The same of several, one after the other: sooner where they are more than a few.
    using Some = std::span<const std::uint32_t>;
    void test(Some some, const Ray& ray, const TriangleQuickReject& quick_reject, Nearest& nearest,
              Traversal& traversal) const {
        if (!some.empty()) test_all(some, ray, quick_reject, nearest, traversal);
    }
    /// The first of them that the ray hits.
    std::optional<std::uint32_t> first_hit(Some some, const Ray& ray, const TriangleQuickReject& quick_reject,
                                           Traversal& traversal) const {
        return some.empty() ? std::nullopt : first_hit_of(some, ray, quick_reject, traversal);
    }

private:
    using Prepared = std::uint32_t;  // index into prepared_, the same for all triangles of a mesh
    static constexpr auto none = static_cast<Prepared>(-1);
    struct Item {
        std::variant<TriangleRows, Sphere, Prepared> shape;
        Primitive primitive;
        Sides sides;
        enum class Surface : std::uint8_t { flat, curved } surface;
    };

    // Counted as a test then, if it is one.
    static bool is_rejected_early(const Item& item, Primitive leaving, const TriangleQuickReject& quick_reject,
                                  std::uint64_t& tests) {
        const auto* rows = std::get_if<TriangleRows>(&item.shape);
        if (!rows || !quick_reject.surely_misses(*rows)) return false;
        // (Both numbers at once: two comparisons are a branch, for each triangle.)
        tests += std::bit_cast<std::uint64_t>(item.primitive) != std::bit_cast<std::uint64_t>(leaving) ? 1 : 0;
        return true;
    }

    // The place of the next that is not rejected, from `at` on. (A loop of its own, in which nothing is called, so that
    // what the look is stays in registers: an octree's any-hit rays .9 of the time.)
    [[gnu::always_inline]] std::size_t next_open(Some some, std::size_t at, const Ray& ray,
                                                 const TriangleQuickReject& quick_reject, Traversal& traversal) const {
        if (at == some.size() || !quick_reject.is_tame()) return at;
        const TriangleQuickReject look = quick_reject;  // copies, which nothing else may change
        const Primitive leaving = ray.leaving;
        const Item* const items = items_.data();
        std::uint64_t tests = 0;
        while (at < some.size() && is_rejected_early(items[some[at]], leaving, look, tests)) ++at;
        traversal.primitive_tests += tests;
        return at;
    }

    // (Not inlined, so that the registers that this takes are saved for lists alone that are not empty.)
    [[gnu::noinline]] void test_all(Some some, const Ray& ray, const TriangleQuickReject& quick_reject,
                                    Nearest& nearest, Traversal& traversal) const {
        for (std::size_t at = 0; (at = next_open(some, at, ray, quick_reject, traversal)) < some.size(); ++at)
            test(some[at], ray, nearest, traversal);
    }
    [[gnu::noinline]] std::optional<std::uint32_t> first_hit_of(Some some, const Ray& ray,
                                                                const TriangleQuickReject& quick_reject,
                                                                Traversal& traversal) const {
        for (std::size_t at = 0; (at = next_open(some, at, ray, quick_reject, traversal)) < some.size(); ++at)
            if (hits(some[at], ray, traversal)) return some[at];
        return std::nullopt;
    }

    Hull corners_at_both_ends(std::size_t i) const;
    Item item(Primitive primitive) const;
    template <class Prepare>
    void add(Item item, Prepared& place, const Prepare& prepare);
    static bool is_left_by(const Item& item, const Ray& ray) {
        return item.primitive == ray.leaving && item.surface == Item::Surface::flat;
    }
    std::optional<Candidate> intersection(const Item& item, const Ray& ray, DecisionCounts& decisions) const;
    // (It returns nothing else, so that the answer is made where it is returned: a copy would wait for it.)
    std::optional<Candidate> counted_intersection(const Item& item, const Ray& ray, Traversal& traversal) const {
        DecisionCounts decisions;
        const auto found = intersection(item, ray, decisions);
        traversal.exact_decisions += decisions.exact;
        return found;
    }

    const Scene* scene_;
    LargeVector<Item> items_;
    std::vector<PreparedShape> prepared_;
    Box triangles_;  // about those that lie here themselves
};

}  // namespace raylab
