#pragma once

#include "raylab/geometry/intersect/intersect.h"
#include "raylab/number/enclosure.h"
#include "raylab/number/sign.h"

#include <limits>
#include <optional>

// The order of two hits along a ray, decided exactly: so every accelerator gives the same answer.

namespace raylab {

/// One primitive at its place, as rays are intersected with it.
struct Target {
    const Shape* shape;
    std::uint32_t part;  // which triangle of a mesh; 0 for any other shape
    const Affine* placement;
    Sides sides;
    const Motion* motion = nullptr;  // null: at rest
};

/// The nearest hit of a primitive inside ray.range; absent: none.
std::optional<Candidate> intersect(const Ray& ray, const Target& target, DecisionCounts& decisions);

/// A flat primitive that a ray leaves is not hit again by it; a curved one may be.
bool is_flat(const Shape& shape);

/// Two hits of one ray: negative where a's t is surely the smaller one, zero where their errors leave that open.
Sign sure_order(const Candidate& a, const Candidate& b);

/// The same decided exactly: zero where the two are equal.
Sign order(const Ray& ray, const Target& a, const Candidate& at_a, const Target& b, const Candidate& at_b,
           DecisionCounts& decisions);

/// Keeps the nearest of the hits it is offered, in whatever order: the exact t decides, then the lower primitive.
class Nearest {
public:
    explicit Nearest(const Ray& ray) : ray_(&ray) {}

    /// What `target_of(Primitive)` returns is asked for where t does not tell: of very many objects each would be
    /// waited for, until it has come from memory.
    template <class TargetOf>
    void offer(const Candidate& candidate, Primitive primitive, const TargetOf& target_of, DecisionCounts& decisions) {
        if (best_ && !beats_best(candidate, primitive, target_of, decisions)) return;
        best_ = {candidate, primitive};
        limit_ = limit(candidate);
    }

    /// Hits that lie surely beyond this t need not be offered any more.
    double limit() const { return limit_; }

    /// The same where this one alone is known.
    static double limit(const Candidate& nearest) { return Enclosure(nearest.t, nearest.t_error).upper(); }

    std::optional<Hit> hit() const {
        if (!best_) return std::nullopt;
        const Candidate& c = best_->candidate;
        // Made in place: the copy of a temporary would be read in other pieces than it was written in, which stalls.
        return std::optional<Hit>(std::in_place, c.t, best_->primitive, c.u, c.v, c.part);
    }

private:
    template <class TargetOf>
    bool beats_best(const Candidate& candidate, Primitive primitive, const TargetOf& target_of,
                    DecisionCounts& decisions) const {
        if (best_->primitive == primitive) return false;  // hit in two cells: the same hit
        Sign against = sure_order(candidate, best_->candidate);
        if (against == Sign::zero) [[unlikely]]
            against =
                order(*ray_, target_of(primitive), candidate, target_of(best_->primitive), best_->candidate, decisions);
        return against == Sign::negative || (against == Sign::zero && primitive < best_->primitive);
    }

    struct Best {
        Candidate candidate;
        Primitive primitive;
    };
    const Ray* ray_;
    std::optional<Best> best_;
    double limit_ = std::numeric_limits<double>::infinity();
};

}  // namespace raylab
