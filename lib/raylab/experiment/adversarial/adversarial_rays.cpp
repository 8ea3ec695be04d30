#include "raylab/experiment/adversarial/adversarial_rays.h"

#include "raylab/geometry/largest_coordinate.h"
#include "raylab/geometry/placement_at.h"
#include "raylab/geometry/shape_parts.h"
#include "raylab/scene/moving.h"

#include <algorithm>
#include <cmath>

namespace raylab::adversarial {

namespace {

constexpr float largest = 0x1p110f;  // keeps origins and directions that are computed from boxes finite

Vec3f within_floats(const Vec3f& v) {
    return {std::clamp(v.x, -largest, largest), std::clamp(v.y, -largest, largest), std::clamp(v.z, -largest, largest)};
}

template <class Points>
const auto& any_of(Draw& draw, const Points& points) {
    return points[static_cast<std::size_t>(draw.integer(0, static_cast<int>(points.size()) - 1))];
}

Triangle placed_triangle(const Triangle& t, const Affine& placement) {
    const auto at = [&](const Vec3f& v) {
        return within_floats(convert<float>(transform_point(placement, convert<double>(v))));
    };
    return {at(t.a), at(t.b), at(t.c)};
}

Vec3f axis_direction(Draw& draw) {  // an axis; its zero components have either sign
    Vec3f direction;
    const int along = draw.integer(0, 2);
    for (int axis = 0; axis < 3; ++axis) direction[axis] = draw.one_in(2) ? 0.0f : -0.0f;
    direction[along] = draw.one_in(2) ? 1.0f : -1.0f;
    return direction;
}

// Sets one or two components to zero, so that the ray does not move along those axes.
Vec3f with_still_axes(Draw& draw, Vec3f direction) {
    const int kept = draw.integer(0, 2);
    for (int axis = 0; axis < 3; ++axis)
        if (axis != kept && draw.one_in(2)) direction[axis] = draw.one_in(2) ? 0.0f : -0.0f;
    return direction;
}

// Scales the direction by any power of two that leaves the longest component a float no larger than 2^60, subnormal
// floats included.
Vec3f of_any_length(Draw& draw, const Vec3f& direction) {
    int exponent = 0;
    std::frexp(largest_coordinate(convert<double>(direction)), &exponent);
    const int by = draw.integer(-148, 60) - exponent;
    return {std::ldexp(direction.x, by), std::ldexp(direction.y, by), std::ldexp(direction.z, by)};
}

bool is_finite(const Vec3f& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

SceneRays::SceneRays(const Scene& scene, float time)
    : time_(time), moves_(anything_moves(scene)), times_(ray_times(scene)) {
    const auto add = [&](const Triangle& triangle, const Box& box) {
        triangles_.push_back(triangle);
        boxes_.push_back({within_floats(box.min), within_floats(box.max)});
        bounds_ = unite(bounds_, boxes_.back());
    };
    for (const Object& object : scene.objects) {
        const Motion* motion = motion_of(scene, object);
        const Affine placement = motion ? rounded_placement(object.placement, *motion, time) : object.placement;
        if (const Mesh* mesh = as_mesh(object.shape)) {
            for (std::size_t face = 0; face < mesh->faces.size(); ++face) {
                const Triangle triangle = mesh->triangle(face);
                add(placed_triangle(triangle, placement), bounds(triangle, placement));
            }
        } else if (const auto box = bounds(object.shape, placement)) {
            const Vec3f middle = within_floats(convert<float>(box->center()));
            add({within_floats(box->min), within_floats(box->max), middle}, *box);
        }
    }
    if (boxes_.empty()) add({Vec3f(0), Vec3f(1, 0, 0), Vec3f(0, 1, 0)}, {Vec3f(-1), Vec3f(1)});
}

const std::vector<std::string>& SceneRays::kinds() {
    static const std::vector<std::string> kinds{
        "random",  "axis-aligned", "in a plane", "at a vertex", "at an edge", "from a vertex",   "grazing",
        "outside", "behind",       "on a box",   "on integers", "any floats", "at its own scale"};
    return kinds;
}

Vec3f SceneRays::vertex(Draw& draw) const {
    const Triangle& t = any_of(draw, triangles_);
    const int which = draw.integer(0, 2);
    return which == 0 ? t.a : which == 1 ? t.b : t.c;
}

Vec3f SceneRays::beside_an_edge(Draw& draw) const {
    const Triangle& t = any_of(draw, triangles_);
    return convert<float>((convert<double>(t.a) + convert<double>(t.b)) / 2.0);
}

// A corner, a point on an edge, or a point in a face of a box.
Vec3f SceneRays::on_a_box(Draw& draw) const {
    const Box& box = draw.one_in(3) ? bounds_ : any_of(draw, boxes_);
    Vec3f point;
    const int inside = draw.integer(-1, 2);  // the coordinate that may lie between the two faces
    for (int axis = 0; axis < 3; ++axis) {
        point[axis] = draw.one_in(2) ? box.min[axis] : box.max[axis];
        if (axis == inside)
            point[axis] = cast<float>(std::lerp(double{box.min[axis]}, double{box.max[axis]}, draw.number(0, 1)));
    }
    return point;
}

Vec3f SceneRays::somewhere(Draw& draw, double reach) const {
    const Vec3d half = (convert<double>(bounds_.max) - convert<double>(bounds_.min)) * 0.5;
    // `bvh8` gives a flat scene some thickness, so that points also lie outside its plane.
    const Vec3d wide = glm::max(half, Vec3d(0.3 * std::max({half.x, half.y, half.z})));
    return convert<float>(bounds_.center() + wide * reach * convert<double>(draw.in_cube(1)));
}

// Aims at a corner, an edge, a face or the inside of the box of one primitive, from a distance in proportion to its
// size: so every primitive is hit, in a scene of many sizes too. The direction has any length.
Ray SceneRays::at_its_own_scale(Draw& draw) const {
    const auto which = static_cast<std::size_t>(draw.integer(0, static_cast<int>(triangles_.size()) - 1));
    const auto [a, b, c] = in<double>(triangles_[which]);
    const auto weight = [&] { return draw.one_in(2) ? draw.integer(0, 2) / 2.0 : draw.number(0, 1); };
    const double u = weight(), v = weight();
    const Vec3f target = convert<float>(a + (b - a) * u + (c - a) * ((1 - u) * v));
    const Vec3d spread = glm::abs(b - a) + glm::abs(c - a);
    const double size = std::max({spread.x, spread.y, spread.z, double{std::numeric_limits<float>::denorm_min()}});
    Vec3f direction = draw.one_in(2) ? draw.lattice_direction(2) : draw.in_cube(1);
    if (draw.one_in(2)) direction = with_still_axes(draw, direction);
    const double distance = std::ldexp(size, draw.one_in(4) ? draw.integer(0, 60) : draw.integer(-3, 3));
    const Vec3f origin = within_floats(convert<float>(convert<double>(target) - convert<double>(direction) * distance));
    return {origin, draw.one_in(3) ? direction : of_any_length(draw, direction)};
}

Ray SceneRays::of_kind(Draw& draw, std::size_t kind) const {
    const auto to = [](const Vec3f& origin, const Vec3f& target) { return through(origin, convert<double>(target)); };
    const Vec3f from = somewhere(draw, 3);
    switch (kind) {
        case 0:
            return to(from, somewhere(draw, 1));
        case 1: {  // through a vertex or anywhere, from outside the scene
            const Vec3f direction = axis_direction(draw), target = draw.one_in(2) ? vertex(draw) : somewhere(draw, 1);
            Vec3f origin = from;
            for (int axis = 0; axis < 3; ++axis)
                if (direction[axis] == 0) origin[axis] = target[axis];
            return {origin, direction};
        }
        case 2: {  // in the plane of a box's face
            Ray ray = to(from, somewhere(draw, 1));
            const int axis = draw.integer(0, 2);
            ray.origin[axis] = on_a_box(draw)[axis];
            ray.direction[axis] = draw.one_in(2) ? 0.0f : -0.0f;
            return ray;
        }
        case 3:
            return to(from, vertex(draw));
        case 4:
            return to(from, beside_an_edge(draw));
        case 5:
            return {vertex(draw), draw.one_in(2) ? draw.lattice_direction(1) : draw.in_cube(1)};
        case 6: {
            const Vec3f target = on_a_box(draw);
            return to(on_a_box(draw), target);
        }
        case 7: {  // away from the scene
            const Vec3f origin = somewhere(draw, 3);
            return {origin, convert<float>(convert<double>(origin) - bounds_.center())};
        }
        case 8: {  // what the ray's line crosses lies at negative t
            Ray ray = to(from, vertex(draw));
            return {
                ray.origin, -ray.direction, {-std::numeric_limits<float>::infinity(), draw.one_in(2) ? 0.0f : 1.0f}};
        }
        case 9: {
            const Vec3f target = somewhere(draw, 2);
            return to(on_a_box(draw), target);
        }
        case 10:
            return {draw.on_lattice(-5, 5), draw.lattice_direction(draw.integer(1, 3))};
        case 11:
            return {draw.one_in(2) ? vertex(draw) : draw.anywhere(), draw.any_direction()};
        default:
            return at_its_own_scale(draw);
    }
}

Ray SceneRays::draw(Draw& draw, std::size_t kind) const {
    Ray ray = of_kind(draw, kind);
    if (moves_) ray.time = draw.one_in(2) ? time_ : any_time(draw, times_);
    // Some rays start far away.
    if (draw.one_in(8)) ray.origin = convert<float>(convert<double>(ray.origin) - convert<double>(ray.direction) * 1e3);
    if (draw.one_in(8)) ray.direction[draw.integer(0, 2)] = draw.one_in(2) ? 0.0f : -0.0f;
    if (!is_finite(ray.origin)) ray.origin = Vec3f(0);
    if (!is_finite(ray.direction) || ray.direction == Vec3f(0)) ray.direction = {0, 0, 1};
    return ray;
}

}  // namespace raylab::adversarial
