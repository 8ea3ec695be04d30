#include "accelerator/instruction_sets.h"
#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/bvh8/bvh8_contents.h"
#include "raylab/accelerator/bvh8/bvh8_triangles-inl.h"
#include "raylab/accelerator/bvh8/bvh8_walk.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/geometry/filter/triangle_filter.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>

using namespace raylab;
using namespace raylab::adversarial;

namespace {

// Counts the triangles that floats leave open.
class Open final : public Bvh8Leaves {
public:
    double uncertain(Bvh8Child, std::size_t) override {
        ++count;
        return nothing_more;
    }
    double hit_found(Bvh8Child, std::size_t) override { return nothing_more; }
    double others(Bvh8Child) override { return nothing_more; }

    int count = 0;
};

// What a walk to a triangle tells; absent: floats do not suffice for the ray.
std::optional<Open> walked(const Bvh8Walks& walks, const Ray& ray, const Triangle& triangle) {
    const Scene scene = scene_of({triangle});
    const Bvh8Contents contents(scene);
    Open leaves;
    Traversal traversal;
    if (!walks.nearest_told(contents.tree(), {ray, ray.range.max, Bvh8Query::leaves_none}, leaves, traversal))
        return std::nullopt;
    return leaves;
}

// A triangle with a corner in a point; one of three is a needle, and so narrow as drawn then.
template <class Width>
Triangle squat_or_needle(Draw& draw, const Vec3f& at, double size, const Width& width) {
    Triangle triangle{at, at + draw.in_cube(size), at + draw.in_cube(size)};
    if (draw.one_in(3)) triangle.c = at + (triangle.b - at) * draw.uniform(-1, 2) + draw.in_cube(size * width());
    return triangle;
}

// A point of the triangle's plane, mostly inside or near it.
Vec3d about(Draw& draw, const Triangle& triangle) {
    const Vec3d sum = convert<double>(triangle.a) + convert<double>(triangle.b) * draw.number(0, 2) +
                      convert<double>(triangle.c) * draw.number(0, 2);
    return sum / draw.number(2.5, 3.5);
}

// A ray through the middle of a triangle that is perpendicular to it.
Open asked(const Vec3f& direction) {
    const auto part = [&](int axis) { return std::abs(direction[axis]); };
    const int steepest = part(0) >= part(1) && part(0) >= part(2) ? 0 : part(1) >= part(2) ? 1 : 2;
    Vec3f right(0), up(0);
    right[(steepest + 1) % 3] = 1;
    up[(steepest + 2) % 3] = 1;
    const auto leaves =
        walked(best_bvh8_walks(), {direction * -5.0f, direction}, Triangle{right, up - right, -up - right});
    REQUIRE(leaves);
    return *leaves;
}

// Whether both answers to a ray are those of the list.
bool answered_as_by(const Accelerator& list, const Accelerator& bvh8, const Ray& ray) {
    Traversal traversal;
    const auto right = list.closest(ray, traversal);
    return same(right, bvh8.closest(ray, traversal)) && right.has_value() == bvh8.occluded(ray, traversal);
}

}  // namespace

TEST_CASE("floats decide about a triangle across the ray, whichever axes the ray is steep, flat and level along") {
    // Sheared along another axis than the steepest, the triangle would be all rounding errors, or NaN.
    std::array<float, 3> parts{0, 0x1p-40f, 1};
    do {
        const Vec3f direction(parts[0], parts[1], parts[2]);
        for (const Vec3f& d : {direction, -direction}) {
            INFO("direction " << d.x << " " << d.y << " " << d.z);
            const Open open = asked(d);
            CHECK(open.count == 0);
            CHECK(open.nearest.has_value());
        }
    } while (std::ranges::next_permutation(parts).found);
}

TEST_CASE("rays at an edge that two triangles share hit the one that the list says, from near and far") {
    // Numbers with all their bits, so that every product of the test in floats is rounded.
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        const double away = std::pow(10, draw.number(-1, 3)), reach = std::pow(10, draw.number(0, 3));
        const Vec3f at = draw.in_cube(away), a = at + draw.in_cube(reach), b = at + draw.in_cube(reach);
        const Scene scene = scene_of({{a, b, at + draw.in_cube(reach)}, {b, a, at + draw.in_cube(reach)}});
        const auto list = make_accelerator("list", scene), bvh8_width = make_accelerator("bvh8", scene);
        for (int i = 0; i < 40; ++i) {
            const double share = draw.number(0, 1);
            const Vec3d target = convert<double>(a) * share + convert<double>(b) * (1 - share);
            const Ray ray = through(
                convert<float>(target + convert<double>(draw.in_cube(std::pow(10, draw.number(-1, 4))))), target);
            Traversal traversal;
            if (!same(list->closest(ray, traversal), bvh8_width->closest(ray, traversal))) return words(ray);
        }
        return std::nullopt;
    };
    CHECK(faults(2'000, judge) == "");
}

TEST_CASE("rays that stand still along axes lose nothing, whatever the sizes of the scene and of the direction") {
    // Corners, origins and ends on a lattice, so that rays lie in the sides of boxes and end at them; another lattice
    // far away makes the tree large.
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        const auto power = [&](int least, int most) { return std::ldexp(1.0f, draw.integer(least, most)); };
        const float size = power(-60, 36), far = draw.one_in(2) ? size : std::min(size * power(0, 40), 0x1p36f);
        const auto on_lattice = [&](float unit) {
            const auto number = [&] { return static_cast<float>(draw.integer(-3, 3)) * unit; };
            return Vec3f(number(), number(), number());
        };
        std::vector<Triangle> triangles;
        for (int i = 0; i < 12; ++i) triangles.push_back({on_lattice(size), on_lattice(size), on_lattice(size)});
        triangles.push_back({on_lattice(far), on_lattice(far), on_lattice(far)});
        const Scene scene = scene_of(triangles);
        const auto list = make_accelerator("list", scene), bvh8 = make_accelerator("bvh8", scene);
        for (int i = 0; i < 60; ++i) {
            const float speed = power(-20, 20);
            Ray ray{on_lattice(draw.one_in(4) ? far : size), on_lattice(speed)};
            ray.direction[draw.integer(0, 2)] = draw.one_in(2) ? 0.0f : -0.0f;
            if (draw.one_in(3)) ray.direction[draw.integer(0, 2)] *= power(-30, 0);
            if (ray.direction == Vec3f(0)) continue;
            if (draw.one_in(2)) ray.range.max = static_cast<float>(draw.integer(0, 6)) * size / speed;
            if (!answered_as_by(*list, *bvh8, ray)) return words(ray);
        }
        return std::nullopt;
    };
    CHECK(faults(4'000, judge) == "");
}

TEST_CASE("what lies behind a ray is not hit where its range begins at -0, with every instruction set") {
    // Floats are compared as integers, of which that of -0 is the least.
    with_each_instruction_set([] {
        const auto judge = [](Draw& draw) -> std::optional<std::string> {
            std::vector<Triangle> triangles;
            for (int i = 0; i < 12; ++i) triangles.push_back({draw.in_cube(1), draw.in_cube(1), draw.in_cube(1)});
            const Scene scene = scene_of(triangles);
            const auto list = make_accelerator("list", scene), bvh8 = make_accelerator("bvh8", scene);
            Ray ray{draw.in_cube(.25), draw.in_cube(1)};
            ray.range.min = -0.0f;
            if (draw.one_in(4)) ray.range.max = draw.one_in(2) ? -0.0f : draw.uniform(-1, 1);
            if (!answered_as_by(*list, *bvh8, ray)) return words(ray);
            return std::nullopt;
        };
        CHECK(faults(2'000, judge) == "");
    });
}

TEST_CASE(
    "a ray that touches boxes in a single point, a corner of their triangle, hits it, with every instruction set") {
    // From the origin of coordinates, where a ray is not moved outward by its rounding, along whole numbers to
    // multiples of them: the planes that meet there have one exact t, but each its own in floats. Half of the triangles
    // are moved aside, and the ray may end at the nearest that is not.
    with_each_instruction_set([] {
        const auto judge = [](Draw& draw) -> std::optional<std::string> {
            const auto some = [&](int most) { return static_cast<float>(draw.integer(1, most)); };
            const auto sign = [&] { return draw.one_in(2) ? 1.0f : -1.0f; };
            const Vec3f direction(sign() * some(2047), sign() * some(2047), sign() * some(2047));
            std::vector<Triangle> triangles;
            float nearest = 4096;
            for (int i = 0; i < 24; ++i) {
                const float t = some(4095);
                Vec3f corner = direction * t;
                if (i % 2 == 0) {
                    nearest = std::min(nearest, t);
                } else {
                    corner += Vec3f(sign(), sign(), 0) * 64.0f;
                }
                const Vec3f along(sign(), sign(), sign());
                const auto another = [&] { return corner + along * Vec3f(some(4095), some(4095), some(4095)); };
                triangles.push_back({corner, another(), another()});
            }
            const Scene scene = scene_of(triangles);
            const auto list = make_accelerator("list", scene), bvh8 = make_accelerator("bvh8", scene);
            Ray ray{Vec3f(0), direction};
            if (draw.one_in(2)) ray.range.max = nearest;
            if (!answered_as_by(*list, *bvh8, ray)) return words(ray);
            return std::nullopt;
        };
        CHECK(faults(2'000, judge) == "");
    });
}

TEST_CASE("where floats are sure of a hit, its exact t lies between their bounds, with every instruction set") {
    std::atomic<int> sure = 0, all = 0;
    with_each_instruction_set([&] {
        const Bvh8Walks walks = best_bvh8_walks();
        // Squat triangles and needles, many across an axis, near and far, of all sizes that floats are for.
        const auto judge = [&](Draw& draw) -> std::optional<std::string> {
            const auto power = [&](int least, int most) { return std::ldexp(1.0, draw.integer(least, most)); };
            const double size = power(-60, 30);
            const Vec3f at = draw.in_cube(size * power(-8, 7));
            Triangle triangle = squat_or_needle(draw, at, size, [&] { return power(-12, 0); });
            if (const int axis = draw.integer(0, 5); axis < 3) triangle.b[axis] = triangle.c[axis] = at[axis];
            Ray ray = through(at + draw.in_cube(size * power(-6, 8)), about(draw, triangle));
            ray.direction = ray.direction * static_cast<float>(power(-20, 20));
            const auto leaves = walked(walks, ray, triangle);
            if (!leaves) return std::nullopt;
            ++all;
            if (!leaves->nearest) return std::nullopt;
            ++sure;
            const auto truth = oracle::intersect(
                in<double>(ray),
                {convert<double>(triangle.a), convert<double>(triangle.b), convert<double>(triangle.c)});
            const auto [leaf, place, soonest, latest] = *leaves->nearest;
            if (truth.hit() && is_gteq(truth.t->compare(soonest)) && is_lteq(truth.t->compare(latest)))
                return std::nullopt;
            return fmt::format("t is not in [{:a}, {:a}] but {}: {} at {} {} {}", soonest, latest,
                               truth.hit() ? truth.t->to_string() : "no hit", words(ray), words(triangle.a),
                               words(triangle.b), words(triangle.c));
        };
        CHECK(faults(30'000, judge) == "");
    });
    INFO(sure << " of " << all << " rays are surely hits");
    CHECK(sure > all / 10);
}

namespace {

struct Shot {
    Ray ray;
    Triangle triangle;
};

// How far from the middle of what floats say about t its exact value is, where their bounds are at one; absent: they do
// not say that there is a hit.
std::optional<double> stretched(const Bvh8Walks& walks, const Shot& shot) {
    const auto leaves = walked(walks, shot.ray, shot.triangle);
    if (!leaves || !leaves->nearest) return std::nullopt;
    DecisionCounts decisions;
    const auto hit = intersect(shot.ray, shot.triangle, decisions);
    const double first = leaves->nearest->soonest, last = leaves->nearest->latest;
    return hit ? std::abs(hit->t - (first + last) / 2) / ((last - first) / 2) : std::numeric_limits<double>::infinity();
}

// How far the areas about a shot's ray are from their exact values, in floats without multiply-add, where their error
// bound is at one; absent: floats do not suffice.
HWY_ATTR std::optional<double> mistaken(const Shot& shot) {
    namespace floats = HWY_NAMESPACE;
    const Scene scene = scene_of({shot.triangle});
    const Bvh8Contents contents(scene);
    const Bvh8Nodes& tree = contents.tree();
    const floats::BoxRay boxes(shot.ray, tree, 0);
    if (!boxes.fits_floats) return std::nullopt;
    floats::Bvh8Ray ray(shot.ray, boxes, shot.ray.range.max);
    ray.prepare_for_triangles(shot.ray, tree, 0);
    const Bvh8Vertices vertices = tree.vertices(tree.nodes[0].children[0]);
    const floats::Areas areas(ray, floats::sheared_vertices(ray, vertices), floats::Corners(vertices, 0));

    const Vec3d d = convert<double>(shot.ray.direction);
    const auto [a, b, c, magnitude, roundings] = triangle_filter::corners(shot.ray, shot.triangle);
    const auto exact = triangle_filter::triangle_volumes(d, a, b, c);
    const auto off = [&](floats::Floats area, double volume) HWY_ATTR {
        return std::abs(double{hwy::HWY_NAMESPACE::GetLane(area)} + volume / d[ray.axes[2]]);
    };
    const double most = std::max({off(areas.u, exact.u), off(areas.v, exact.v), off(areas.w, exact.w)});
    return most / double{hwy::HWY_NAMESPACE::GetLane(areas.error)};
}

// Changes one number of a shot, by much or by a last bit.
Shot changed(Draw& draw, Shot shot) {
    const std::array<Vec3f*, 5> points{&shot.ray.origin, &shot.ray.direction, &shot.triangle.a, &shot.triangle.b,
                                       &shot.triangle.c};
    float& number = (*points[static_cast<std::size_t>(draw.integer(0, 4))])[draw.integer(0, 2)];
    number *= 1 + draw.uniform(-1, 1) * static_cast<float>(std::ldexp(1.0, draw.integer(-23, 0)));
    return shot;
}

// A shot at a needle or a squat triangle, near or far, and from it so many others: of two, the one of the greater score
// is kept. (Shots at random seldom come to a tenth of the way to a bound, and would not notice one that is a fifth of
// what it must be.)
struct Climbed {
    Shot best;
    double score;

    template <class Score>
    Climbed(Draw& draw, const Score& score_of) {
        const auto power = [&](int least, int most) {
            return static_cast<float>(std::ldexp(1.0, draw.integer(least, most)));
        };
        const Vec3f at = draw.in_cube(power(-8, 7));
        best = {{at + draw.in_cube(power(-6, 8)), Vec3f(0)}, {at, at + draw.in_cube(1), at + draw.in_cube(1)}};
        if (draw.one_in(2)) best.triangle.c = best.triangle.b + draw.in_cube(power(-12, 0));
        best.ray = through(best.ray.origin, (convert<double>(best.triangle.a) + convert<double>(best.triangle.b) +
                                             convert<double>(best.triangle.c)) /
                                                3.0);
        score = score_of(best).value_or(0);
        for (int shot = 0; shot < 3000; ++shot) {
            const Shot next = changed(draw, best);
            const double found = score_of(next).value_or(0);
            if (found < score) continue;
            best = next;
            score = found;
        }
    }

    std::string words() const {
        return fmt::format("{}: {} at {} {} {}", score, adversarial::words(best.ray),
                           adversarial::words(best.triangle.a), adversarial::words(best.triangle.b),
                           adversarial::words(best.triangle.c));
    }
};

// Climbs many times: words of where a score passed one, and the highest score.
template <class Score>
void check_climbs(const Score& score_of) {
    std::atomic<double> highest = 0;
    const auto judge = [&](Draw& draw) -> std::optional<std::string> {
        const Climbed climbed(draw, score_of);
        for (double last = highest; last < climbed.score && !highest.compare_exchange_weak(last, climbed.score);) {
        }
        return climbed.score <= 1 ? std::nullopt : std::optional(climbed.words());
    };
    CHECK(faults(120, judge) == "");
    CHECK((is_sanitized || highest > 0.4));  // a sanitizer watches few climbs
}

}  // namespace

TEST_CASE("climbing towards the error bound of areas in floats, from shot to shot, does not get past it") {
    check_climbs(mistaken);
}

TEST_CASE("climbing towards the ends of what floats say about t, from shot to shot, does not get past them") {
    const Bvh8Walks walks = best_bvh8_walks();
    check_climbs([&](const Shot& shot) { return stretched(walks, shot); });
}

TEST_CASE("bvh8 says where a hit is in the very bits of intersect(), with every instruction set") {
    // From so near and so far that t is accurate in doubles and hardly so: from a thousand times a triangle's size on
    // it begins not to be, sooner for needles and for rays along the triangle.
    std::atomic<int> accurate = 0, located = 0, left_open = 0;
    with_each_instruction_set([&] {
        const Bvh8Walks walks = best_bvh8_walks();
        const auto judge = [&](Draw& draw) -> std::optional<std::string> {
            const auto power = [&](int least, int most) { return std::ldexp(1.0, draw.integer(least, most)); };
            const double size = power(-40, 20);
            const Vec3f at = draw.in_cube(size * power(-2, 2));
            const Triangle triangle = squat_or_needle(draw, at, size, [&] { return power(-10, 0); });
            const Ray ray = through(at + draw.in_cube(size * power(-2, 14)), about(draw, triangle));
            const auto leaves = walked(walks, ray, triangle);
            if (!leaves || !leaves->nearest) return std::nullopt;
            const auto decision = triangle_filter::decide(
                triangle_filter::filter(ray, triangle_filter::corners(ray, triangle)), ray.range, Sides::both);
            const auto* told = std::get_if<Candidate>(&decision);
            accurate += told != nullptr;
            if (!leaves->at.is_accurate) {
                left_open += told != nullptr;
                return std::nullopt;
            }
            ++located;
            if (told && leaves->at.t == told->t && leaves->at.u == told->u && leaves->at.v == told->v)
                return std::nullopt;
            return fmt::format("{} at {} {} {}", words(ray), words(triangle.a), words(triangle.b), words(triangle.c));
        };
        CHECK(faults(30'000, judge) == "");
    });
    INFO(accurate << " accurate hits, of which " << left_open << " are left open");
    CHECK(located > 0);
    CHECK(10 * left_open < accurate);
}
