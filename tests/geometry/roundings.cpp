#include "catch.h"
#include "geometry/every_shape.h"
#include "raylab/geometry/predicate/intersection.h"

#include <algorithm>

// Estimate's bound rests on the number of roundings that a predicate takes.

using namespace raylab;
using namespace raylab::adversarial;

namespace {

/// A double and the roundings on its way: those of the factors of a product add up, and a rounding joins them.
struct Counted {
    double value = 0;
    int roundings = 0;

    Counted() = default;
    explicit Counted(double exact) : value(exact) {}
    Counted(double rounded, int after) : value(rounded), roundings(after) {}

    friend Counted operator-(const Counted& a) { return {-a.value, a.roundings}; }
    friend Counted operator+(const Counted& a, const Counted& b) {
        return {a.value + b.value, std::max(a.roundings, b.roundings) + 1};
    }
    friend Counted operator-(const Counted& a, const Counted& b) { return a + -b; }
    friend Counted operator*(const Counted& a, const Counted& b) {
        return {a.value * b.value, a.roundings + b.roundings + 1};
    }
    friend std::optional<Sign> sign(const Counted& a) {
        largest = std::max(largest, a.roundings);
        return sign(a.value);
    }

    static int largest;
};
int Counted::largest = 0;

}  // namespace

TEST_CASE("no predicate of any shape takes more roundings than an estimate's bound allows for") {
    Draw draw(1);
    for (int i = 0; i < 200'000; ++i) {
        Object target = object_of_every_kind(draw);
        if (std::holds_alternative<std::shared_ptr<const Mesh>>(target.shape)) continue;
        Ray ray = through(any_point(draw), convert<double>(any_point(draw)));
        if (draw.one_in(2)) ray.range = tight_range(draw, 1);
        ray.time = any_time(draw);
        const Motion translation{.translation = draw.in_cube(1)};
        const bool moves = draw.one_in(2);
        if (moves) target.placement.columns = Affine{}.columns;  // nothing else that moves is estimated
        Signs<Counted> signs;
        const auto found =
            intersect(ray, target.shape, target.placement, moves ? &translation : nullptr, target.sides, signs);
        if (found)
            for (const Counted& part : {found->t.a, found->t.b, found->t.c, found->t.discriminant})
                Counted::largest = std::max(Counted::largest, part.roundings);
    }
    INFO(Counted::largest);
    CHECK(Counted::largest <= Estimate::max_roundings);
    CHECK(Counted::largest > Estimate::max_roundings / 2);  // else the bound might be tighter
}
