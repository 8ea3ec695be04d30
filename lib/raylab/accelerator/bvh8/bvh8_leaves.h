#pragma once

#include "raylab/accelerator/bvh8/bvh8_contents.h"
#include "raylab/accelerator/bvh8/bvh8_walk.h"
#include "raylab/geometry/intersect/nearest.h"
#include "raylab/geometry/predicate/accuracy.h"
#include "raylab/geometry/shape_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace raylab {

/// The exact tests of a leaf's primitives: the part that is common to all queries.
class PrimitiveLeaves : public Bvh8Leaves {
public:
    PrimitiveLeaves(const Bvh8Contents& contents, const Ray& ray, Traversal& traversal)
        : contents_(contents), ray_(ray), traversal_(traversal) {}

protected:
    std::optional<Candidate> test(Bvh8Child leaf, std::size_t place) {
        DecisionCounts decisions;
        const auto candidate =
            intersect(ray_, contents_.tree().triangle(leaf, place), decisions, contents_.tree().sides(leaf, place));
        traversal_.exact_decisions += decisions.exact;
        return candidate;
    }

    std::uint32_t number(Bvh8Child leaf, std::size_t place) const { return contents_.tree().number(leaf, place); }

    const Bvh8Contents& contents_;
    const Ray& ray_;
    Traversal& traversal_;
};

/// The exact tests for the nearest hit.
class NearestLeaves : public PrimitiveLeaves {
public:
    // (Compiled into the walk, which saves a closest hit 2 to 3 % of its instructions.)
    [[gnu::always_inline]] NearestLeaves(const Bvh8Contents& contents, const Ray& ray, Traversal& traversal)
        : PrimitiveLeaves(contents, ray, traversal), asked_(ray) {
        for (std::size_t i = 0; i < contents.unbounded().size(); ++i)
            contents.unbounded().test(i, ray, asked_, traversal);
    }

    double uncertain(Bvh8Child leaf, std::size_t place) override {
        if (const auto candidate = test(leaf, place)) offer(*candidate, number(leaf, place));
        return end();
    }

    double hit_found(Bvh8Child leaf, std::size_t place) override { return uncertain(leaf, place); }

    double others(Bvh8Child leaf) override {
        const std::size_t shapes = contents_.others().size();
        for (std::size_t i = leaf.first(); i < leaf.first() + leaf.count(); ++i) {
            const std::size_t other = contents_.tree().other(i);
            if (other < shapes)
                contents_.others().test(other, ray_, asked_, traversal_);
            else
                contents_.instances().test(other - shapes, ray_, nearest_end(), asked_, traversal_);
        }
        return end();
    }

    double end() const { return std::min<double>(ray_.range.max, asked_.limit()); }

    /// The nearer one of the hits that were tested exactly and of the hit that the traversal kept.
    std::optional<Hit> hit() {
        if (nearest && at.is_accurate) {
            // (Made in place, which saves a closest hit 7 % of its time: see Nearest::hit().)
            if (asked_.limit() == std::numeric_limits<double>::infinity())
                return std::optional<Hit>(std::in_place, at.t,
                                          contents_.primitive(number(nearest->leaf, nearest->place)), at.u, at.v);
            offer({at.t, std::abs(at.t) * t_accuracy, at.u, at.v}, number(nearest->leaf, nearest->place));
        } else if (nearest) {
            uncertain(nearest->leaf, nearest->place);
        }
        return asked_.hit();
    }

private:
    // The same, where the hit that the traversal has kept counts, too.
    double nearest_end() const { return nearest ? std::min<double>(end(), nearest->latest) : end(); }

    void offer(const Candidate& candidate, std::uint32_t number) {
        raylab::offer(contents_.scene(), contents_.primitive(number), candidate, asked_, traversal_);
    }

    Nearest asked_;
};

/// The exact tests for any hit.
class AnyLeaves final : public PrimitiveLeaves {
public:
    using PrimitiveLeaves::PrimitiveLeaves;

    double uncertain(Bvh8Child leaf, std::size_t place) override {
        return test(leaf, place) ? hit_found(leaf, place) : end();
    }

    double hit_found(Bvh8Child leaf, std::size_t place) override { return stopped_by(number(leaf, place)); }

    double others(Bvh8Child leaf) override {
        for (std::size_t i = leaf.first(); i < leaf.first() + leaf.count(); ++i) {
            const std::size_t other = contents_.tree().other(i);
            if (hits_other(other)) return stopped_by(contents_.tree().triangle_count + other);
        }
        return end();
    }

    double end() const { return ray_.range.max; }

    bool is_hit() const { return hit_; }

    /// Whether the ray hits what it need not be followed for: the light's last blocker, or something unbounded. (As a
    /// function that is called it would take a fiftieth of a shadow ray's instructions.)
    [[gnu::always_inline]] bool is_hit_at_once() {
        if (traversal_.stopped_again([&](std::size_t number) { return hits(number); })) return true;
        const Primitives& unbounded = contents_.unbounded();
        for (std::size_t i = 0; i < unbounded.size(); ++i)
            if (unbounded.hits(i, ray_, traversal_)) return true;
        return false;
    }

    /// Whether the ray hits the primitive that has this number as a blocker.
    bool hits(std::size_t number) {
        const std::size_t triangles = contents_.tree().triangle_count;
        if (number >= triangles) return hits_other(number - triangles);
        const Primitive name = contents_.primitive(static_cast<std::uint32_t>(number));
        if (name == ray_.leaving) return false;
        ++traversal_.primitive_tests;
        const Object& object = contents_.scene().objects[name.object];
        DecisionCounts decisions;
        const bool hit = intersect(ray_, *triangle_of(object.shape, name.part), decisions, object.sides).has_value();
        traversal_.exact_decisions += decisions.exact;
        return hit;
    }

private:
    bool hits_other(std::size_t other) const {
        const std::size_t shapes = contents_.others().size();
        if (other < shapes) return contents_.others().hits(other, ray_, traversal_);
        return contents_.instances().hits(other - shapes, ray_, traversal_);
    }

    double stopped_by(std::size_t number) {
        traversal_.stopped_by(number);
        hit_ = true;
        return nothing_more;
    }
    bool hit_ = false;
};

}  // namespace raylab
