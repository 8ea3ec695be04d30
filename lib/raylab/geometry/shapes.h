#pragma once

#include "raylab/geometry/vector.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

// The shapes of a scene, as the floats they are stored in. All are closed sets: edges, vertices, rims and cap edges
// belong to them. A tangent ray hits; a ray lying in a surface (coplanar, along a generator) misses it.
//
// The cases that this leaves open are decided so:
// - A shape of several parts (side and caps) is their union, and each part is asked alone: a ray along a cylinder's
//   generator misses the side and hits the caps on their rims; a ray in a cap's plane misses the cap and hits the rim,
//   which the side owns too. A cap of radius zero is no cap: an apex belongs to the side.
// - One side only is seen where the ray goes against the outward normal (front) or along it (back); a tangent ray and a
//   ray through an apex see both. A transform carries the normal by its inverse transpose.
// - A negative radius, an ellipsoid with a zero radius, a zero normal, an axis of length zero: readers refuse these,
//   and to the oracle they are no surface. A triangle or polygon without area is no surface to anybody: every ray
//   misses.
// - Elsewhere a zero radius leaves what the equation leaves, the center of a sphere or disk and the axis of a cylinder,
//   and a ray across that hits.

namespace raylab {

template <Scalar T>
struct SphereOf {
    Vec3<T> center;
    T radius;
};
using Sphere = SphereOf<float>;

/// ((x-cx)/rx)^2 + ((y-cy)/ry)^2 + ((z-cz)/rz)^2 = 1: a primitive of its own, not a scaled sphere.
struct Ellipsoid {
    Vec3f center, radii;
};

enum class Ends { open, capped };  // whether disks close a surface of revolution where its axis ends

// The surfaces of revolution share a frame: s = (P - base).(top - base) / |top - base|^2 runs from 0 at base to 1 at
// top, rho is the distance from the axis, and the surface is rho^2 = q(s), 0 <= s <= 1, with a quadratic q:

/// q(s) = radius^2.
struct Cylinder {
    Vec3f base, top;
    float radius;
    Ends ends = Ends::open;
};

/// q(s) = (base_radius + (top_radius - base_radius) s)^2. A zero radius is an apex.
struct Cone {
    Vec3f base, top;
    float base_radius, top_radius;
    Ends ends = Ends::open;
};

/// q(s) = radius^2 s: vertex at base, radius at top; its one cap is at top.
struct Paraboloid {
    Vec3f base, top;
    float radius;
    Ends ends = Ends::open;
};

/// q(s) = waist^2 + (radius^2 - waist^2) (2s - 1)^2: one sheet, `waist` in the middle, `radius` at both ends.
struct Hyperboloid {
    Vec3f base, top;
    float waist, radius;
    Ends ends = Ends::open;
};

struct Plane {
    Vec3f point, normal;  // the normal need not be unit
};

struct Disk {
    Vec3f center, normal;  // the normal need not be unit
    float radius;
};

/// A disk with a hole, 0 < inner_radius < outer_radius: inner_radius <= |P - center| <= outer_radius. Both rims belong
/// to it.
struct Annulus {
    Vec3f center, normal;  // the normal need not be unit
    float inner_radius, outer_radius;
};

/// Its plane is the one through the first vertex whose normal is the polygon's exact Newell normal
/// sum v_i x v_{i+1}; its inside is decided after projection along the normal's dominant axis (x before y before z
/// where equal) by the even-odd rule, boundary included. So a polygon whose float vertices are not quite in one plane
/// is still one exact set.
struct Polygon {
    std::vector<Vec3f> vertices;
};

template <Scalar T>
struct TriangleOf {
    Vec3<T> a, b, c;
};
using Triangle = TriangleOf<float>;

/// The triangle as a method computes with it.
template <Scalar T>
TriangleOf<T> in(const Triangle& triangle) {
    return {convert<T>(triangle.a), convert<T>(triangle.b), convert<T>(triangle.c)};
}

/// Triangles that share vertices, in file order, polygons fanned from their first vertex.
struct Mesh {
    struct Face {
        std::uint32_t a, b, c;
    };
    std::vector<Vec3f> vertices;
    std::vector<Face> faces;
    std::vector<Vec3f> normals = {};  // per vertex, or empty

    Triangle triangle(std::size_t face) const {
        return {vertices[faces[face].a], vertices[faces[face].b], vertices[faces[face].c]};
    }
};

/// One-sided shapes (NFF's rule) are seen only from where their normal points.
enum class Sides { both, front, back };

// To add a shape (the annulus is the latest):
// 1. Write its struct above, defined as a set of points, and enter it below. Say which side its normal points to.
// 2. The compiler asks for one overload in each of these:
//    - geometry: `intersect` in predicate/*_intersection.h is the decision, written once for all number types;
//      `Preparation` in intersect/prepared_shape.cpp names its filter in doubles (of a flat shape: an extent in
//      filter/prepared_flat.h) or Unprepared, which is right but slower; `OnShape` in surface/surface_position.cpp (of
//      a flat shape: by a constructor in surface/surface_plane.h); bounds/box.cpp and bounds/hull.cpp; `LiesInPlane` in
//      containment.cpp; `intersect_line`, declared in oracle/oracle_cgal.h and defined in oracle/oracle_flat.cpp or
//      oracle/oracle_quadrics.cpp, which shares no formula with `intersect`;
//    - scene: check_shape.cpp refuses bad values; pov/shape.cpp has its words for POV-Ray;
//    - experiment: adversarial/adversarial_exponents.cpp multiplies it by a power of two;
//    - report: structure/structure_replay_json.cpp has its fields, name and reader; plane/plane_wires.cpp draws it.
// 3. Nothing asks for these: its keys in scene/toml/shape_format.cpp and scene/toml/read_shape.cpp (test_scene then
//    says how to renew scene.schema.json and scene/FORMAT.md); of a flat shape `FlatNormal` in scene/pov/texture.cpp;
//    of a closed one `is_closed` and `where` in containment.cpp.
// 4. Tests: a generator in tests/geometry/every_shape.h; `SideOf` in tests/geometry/surface_position.cpp, for which the
//    compiler asks; the shape in the scene of tests/tracer/any_surface.cpp, which fails until every shape was seen at
//    rest and transformed; an example of each key in tests/scene/files/every_key.toml.
using Shape = std::variant<Sphere, Ellipsoid, Cylinder, Cone, Paraboloid, Hyperboloid, Plane, Disk, Annulus, Polygon,
                           Triangle, std::shared_ptr<const Mesh>>;

}  // namespace raylab
