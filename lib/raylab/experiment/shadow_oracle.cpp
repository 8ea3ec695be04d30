#include "raylab/experiment/shadow_oracle.h"

#include "raylab/geometry/intersect/nearest.h"
#include "raylab/geometry/largest_coordinate.h"
#include "raylab/geometry/oracle/oracle.h"
#include "raylab/geometry/predicate/intersection.h"
#include "raylab/geometry/scaled_to_largest_one.h"
#include "raylab/geometry/shape_parts.h"
#include "raylab/number/next_float.h"
#include "raylab/sampling/random.h"
#include "raylab/scene/moving.h"
#include "raylab/tracer/shading/surface_point.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>

namespace raylab {

namespace {

double float_ulp(double x) {
    const float size = static_cast<float>(x);
    return double{std::nextafter(size, std::numeric_limits<float>::infinity())} - size;
}

Target target(const Scene& scene, Primitive primitive) {
    const Object& object = scene.objects[primitive.object];
    return {&object.shape, primitive.part, &object.placement, object.sides};
}

// The triangle, if the primitive is a mesh's.
std::optional<Triangle> triangle_of_mesh(const Target& target) {
    const Mesh* mesh = as_mesh(*target.shape);
    return mesh ? std::optional(mesh->triangle(target.part)) : std::nullopt;
}

// Sides that a ray sees which sees both of two; absent: it sees none.
std::optional<Sides> both_of(Sides a, Sides b) {
    if (a == Sides::both || a == b) return b;
    return b == Sides::both ? std::optional(a) : std::nullopt;
}

// A convex body lies behind each of its tangent planes: it never shades what it shows to a light outside.
bool never_shades_outside(const Shape& shape) { return !std::holds_alternative<Hyperboloid>(shape); }

}  // namespace

struct ShadowOracle::Way {
    Vec3d from, to;
};

// All ways to the light, from a box about the exact point to one about the light.
struct ShadowOracle::Segment {
    Primitive from;
    Vec3d point, light;                 // `point`: the middle
    Vec3d normal;                       // on the light's side
    double band;                        // metres
    Vec3<Enclosure> origin, direction;  // of all ways inside the band
    // A quadric that is crossed outward here can be crossed again only inward, and the other way round: which tells the
    // point itself from a second hit, however near. Absent: the surface cannot be hit again.
    std::optional<Sides> own;
};

ShadowOracle::ShadowOracle(const Scene& scene) : scene_(scene) {
    assert(!anything_moves(scene));
    for (std::uint32_t number = 0; number < scene.objects.size(); ++number) {
        const Object& object = scene.objects[number];
        const Mesh* mesh = as_mesh(object.shape);
        if (!mesh) parts_.push_back({{number, 0}, bounds(object.shape, object.placement)});
        for (std::uint32_t part = 0; mesh && part < mesh->faces.size(); ++part)
            parts_.push_back({{number, part}, bounds(mesh->triangle(part), object.placement)});
    }
}

ShadowOracle::Segment ShadowOracle::segment(const ShadowQuestion& question, double ulps) const {
    DecisionCounts decisions;
    const Target surface = target(scene_, question.hit.primitive);
    const auto hit_found = intersect(question.arrived, surface, decisions);
    const Enclosure t(hit_found->t, hit_found->t_error);
    const auto exact = convert<Enclosure>(question.arrived.origin) + t * convert<Enclosure>(question.arrived.direction);
    const Vec3d point{exact.x.middle(), exact.y.middle(), exact.z.middle()};
    const double band = ulps * float_ulp(std::max(largest_coordinate(point), largest_coordinate(question.light)));
    const auto widened = [&](const Enclosure& x) { return Enclosure(x.middle(), x.radius() + band); };
    const Vec3<Enclosure> from{widened(exact.x), widened(exact.y), widened(exact.z)};
    const Vec3<Enclosure> to{Enclosure(question.light.x, band), Enclosure(question.light.y, band),
                             Enclosure(question.light.z, band)};

    const Vec3d outward = surface_point(scene_, question.arrived, question.hit).normal;
    const Vec3d way = question.light - point;
    const bool outside = dot(outward, way) > 0;
    const bool hit_once = is_flat(*surface.shape) || (outside && never_shades_outside(*surface.shape));
    return {.from = question.hit.primitive,
            .point = point,
            .light = question.light,
            .normal = outside ? outward : -outward,
            .band = band,
            .origin = from,
            .direction = to - from,
            .own = hit_once ? std::nullopt : both_of(surface.sides, outside ? Sides::front : Sides::back)};
}

// The sides of a primitive that may stop the light; absent: none.
std::optional<Sides> ShadowOracle::stopping(const Segment& segment, Primitive primitive) const {
    return primitive == segment.from ? segment.own : std::optional(scene_.objects[primitive.object].sides);
}

// Whether the boxes about the way and about the part overlap.
bool ShadowOracle::may_hit(const Segment& segment, const BoxedPrimitive& part) {
    if (!part.box) return true;
    for (int i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax(segment.point[i], segment.light[i]);
        if (low - 2 * segment.band > part.box->max[i] || high + 2 * segment.band < part.box->min[i]) return false;
    }
    return true;
}

// Whether the primitive stops the light that comes that way.
bool ShadowOracle::blocks(const Segment& segment, const Way& way, Primitive primitive) const {
    // Beside its surface, a point has it for an obstacle like any other.
    const bool on_surface = way.from == segment.point;
    const auto sides =
        on_surface ? stopping(segment, primitive) : std::optional(scene_.objects[primitive.object].sides);
    if (!sides) return false;
    const RayOf<double> ray{way.from, way.to - way.from, {0, 1}};
    const Target t = target(scene_, primitive);
    const auto triangle = triangle_of_mesh(t);
    return oracle::intersect(ray, triangle ? Shape(*triangle) : *t.shape, *t.placement, *sides).hit();
}

std::optional<bool> ShadowOracle::surely_blocks(const Segment& segment, Primitive primitive) const {
    const auto sides = stopping(segment, primitive);
    if (!sides) return false;
    const Target t = target(scene_, primitive);
    const auto way = transformed_ray<Enclosure>(segment.origin, segment.direction, {0, 1}, *t.placement);
    Signs<Enclosure> signs;
    const auto hit_found = std::visit(
        [&]<class S>(const S& shape) {
            if constexpr (std::same_as<S, std::shared_ptr<const Mesh>>)
                return intersect(way, shape->triangle(t.part), *sides, signs).has_value();
            else
                return intersect(way, shape, *sides, signs).has_value();
        },
        *t.shape);
    return signs.undecided() ? std::nullopt : std::optional(hit_found);
}

std::optional<Shade> ShadowOracle::around(const ShadowQuestion& question) const {
    return around(segment(question, band_ulps));
}

std::optional<Shade> ShadowOracle::around(const Segment& way) const {
    bool sure = true;
    for (const BoxedPrimitive& part : parts_) {
        if (!may_hit(way, part)) continue;
        const auto blocked = surely_blocks(way, part.primitive);
        if (blocked == true) return Shade::blocked;
        sure = sure && blocked;
    }
    return sure ? std::optional(Shade::lit) : std::nullopt;
}

Shade ShadowOracle::at(const Segment& segment, const Way& way) const {
    const bool blocked = std::ranges::any_of(parts_, [&](const BoxedPrimitive& part) {
        return may_hit(segment, part) && blocks(segment, way, part.primitive);
    });
    return blocked ? Shade::blocked : Shade::lit;
}

Shade ShadowOracle::at(const ShadowQuestion& question) const {
    const Segment way = segment(question, 0);
    const auto known = around(way);  // nearly always
    return known ? *known : at(way, {way.point, way.light});
}

bool ShadowOracle::edge_passes(const ShadowQuestion& question) const {
    const Segment way = segment(question, band_ulps);
    const Shade here = at(way, {way.point, way.light});
    const auto aside = [&](std::uint64_t sample, std::uint64_t end) {
        const auto coordinate = [&](std::uint64_t i) {
            return 2 * random_number({.sample = sample, .dimension = 3 * end + i}) - 1;
        };
        return Vec3d{coordinate(0), coordinate(1), coordinate(2)} * way.band;
    };
    const double smallest =
        is_flat(scene_.objects[way.from.object].shape) ? 0 : way.band / 8;  // clear of a curved surface
    constexpr std::uint64_t samples = 2000;  // a corner of an edge may fill little of the band
    for (std::uint64_t i = 0; i < samples; ++i) {
        const Vec3d off = aside(i, 0);
        if (dot(off, way.normal) > smallest && at(way, {way.point + off, way.light + aside(i, 1)}) != here) return true;
    }
    return false;
}

}  // namespace raylab
