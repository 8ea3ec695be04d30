#include "raylab/transport/light/light_piece.h"

#include "raylab/geometry/local_frame.h"
#include "raylab/geometry/placement_at.h"
#include "raylab/geometry/rectangle.h"
#include "raylab/radiosity/mesh/tessellation.h"
#include "raylab/scene/moving.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

constexpr double rounding = 1e-6;  // what scenes lose as floats, and some

double determinant(const Affine& placement) {
    const auto& [x, y, z] = placement.columns;
    return dot(cross(convert<double>(x), convert<double>(y)), convert<double>(z));
}

// By how much a placement enlarges everything; absent where it deforms.
std::optional<double> enlargement(const Affine& placement) {
    const Vec3d x = convert<double>(placement.columns[0]), y = convert<double>(placement.columns[1]),
                z = convert<double>(placement.columns[2]);
    const double square = dot(x, x);
    const auto differs = [&](double a, double b) { return std::abs(a - b) > rounding * square; };
    if (differs(dot(y, y), square) || differs(dot(z, z), square) || differs(dot(x, y), 0) || differs(dot(y, z), 0) ||
        differs(dot(z, x), 0))
        return std::nullopt;
    return std::sqrt(square);
}

using Shapes = std::vector<LightShape>;

// The shapes of an object's pieces: of a mesh one for each triangle, in their order. Absent: it cannot be sampled.
class LightShapes {
public:
    LightShapes(const Object& object, const Affine& placement)
        : object_(object), placement_(placement), mirrors_(determinant(object.placement) < 0) {}

    std::optional<Shapes> operator()(const Sphere& sphere) const {
        const auto factor = enlargement(placement_);
        const double radius = sphere.radius;
        // Where only the inner side is seen, rays pass the near side and meet the far one: no cone tells where.
        if (factor && object_.sides != Sides::back)
            return Shapes{SphereLight{placed(convert<double>(sphere.center)), radius * *factor}};
        return (*this)(Ellipsoid{sphere.center, {sphere.radius, sphere.radius, sphere.radius}});
    }

    std::optional<Shapes> operator()(const Ellipsoid& e) const {
        const Vec3d radii = convert<double>(e.radii);
        return Shapes{EllipsoidLight{placed(convert<double>(e.center)),
                                     {turned({radii.x, 0, 0}), turned({0, radii.y, 0}), turned({0, 0, radii.z})}}};
    }

    std::optional<Shapes> operator()(const Disk& disk) const { return ring(disk.center, disk.normal, disk.radius, 0); }
    std::optional<Shapes> operator()(const Annulus& annulus) const {
        return ring(annulus.center, annulus.normal, annulus.outer_radius, annulus.inner_radius);
    }

    std::optional<Shapes> operator()(const Triangle& triangle) const { return Shapes{triangle_light(triangle)}; }

    std::optional<Shapes> operator()(const Polygon& polygon) const {
        std::vector<Vec3d> corners;
        for (const Vec3f& vertex : polygon.vertices) corners.push_back(placed(convert<double>(vertex)));
        if (mirrors_) std::ranges::reverse(corners);
        if (is_rectangle(corners))
            return Shapes{RectangleLight{corners[0], corners[1] - corners[0], corners[3] - corners[0]}};
        Shapes parts;
        for (const auto& triangle : triangulated(corners)) {
            const PolygonLight part{triangle[0], triangle[1], triangle[2]};
            if (part.area() > 0) parts.push_back(part);
        }
        return parts;
    }

    std::optional<Shapes> operator()(const std::shared_ptr<const Mesh>& mesh) const {
        Shapes parts;
        for (std::size_t face = 0; face < mesh->faces.size(); ++face)
            parts.push_back(triangle_light(mesh->triangle(face)));
        return parts;
    }

    // Planes have no area, and the others' sides no map of their own yet.
    template <class Shape>
    std::optional<Shapes> operator()(const Shape&) const {
        return std::nullopt;
    }

private:
    Vec3d placed(const Vec3d& point) const { return transform_point(placement_, point); }
    Vec3d turned(const Vec3d& vector) const { return transform_vector(placement_, vector); }

    TriangleLight triangle_light(const Triangle& triangle) const {
        auto [a, b, c] = in<double>(triangle);
        if (mirrors_) std::swap(b, c);
        return {placed(a), placed(b), placed(c)};
    }

    Shapes ring(const Vec3f& center, const Vec3f& normal, double radius, double inner_radius) const {
        const LocalFrame frame = frame_around(glm::normalize(convert<double>(normal)));
        Vec3d first = turned(radius * frame.x), second = turned(radius * frame.y);
        if (mirrors_) std::swap(first, second);
        return {DiskLight{placed(convert<double>(center)), first, second, inner_radius / radius}};
    }

    const Object& object_;
    const Affine& placement_;  // to where the shapes are wanted
    const bool mirrors_;       // the object's own placement does: outside is on the other side
};

// A shape in the object's coordinates, carried to the object's place at a moment.
class AtMoment {
public:
    explicit AtMoment(const PlacementAt<double>& placement) : placement_(placement) {}

    LightShape operator()(const SphereLight& s) const {
        return (*this)(EllipsoidLight{s.center, {Vec3d{s.radius, 0, 0}, {0, s.radius, 0}, {0, 0, s.radius}}});
    }
    LightShape operator()(const EllipsoidLight& e) const {
        return EllipsoidLight{placed(e.center), {turned(e.axes[0]), turned(e.axes[1]), turned(e.axes[2])}};
    }
    LightShape operator()(const TriangleLight& t) const { return TriangleLight{placed(t.a), placed(t.b), placed(t.c)}; }
    LightShape operator()(const PolygonLight& p) const { return PolygonLight{placed(p.a), placed(p.b), placed(p.c)}; }
    LightShape operator()(const RectangleLight& r) const {
        return RectangleLight{placed(r.corner), turned(r.first), turned(r.second)};
    }
    LightShape operator()(const DiskLight& d) const {
        return DiskLight{placed(d.center), turned(d.first), turned(d.second), d.inner};
    }

private:
    Vec3d turned(const Vec3d& v) const {
        const auto& [x, y, z] = placement_.columns;
        return v.x * x + v.y * y + v.z * z;
    }
    Vec3d placed(const Vec3d& point) const { return turned(point) + placement_.translation; }

    PlacementAt<double> placement_;
};

}  // namespace

LightShape turned_shape(const LightPiece& piece, float time) {
    const auto& [placement, motion] = *piece.turning;
    return std::visit(AtMoment(placement_at<double>(placement, motion, time)), piece.shape);
}

std::optional<std::vector<LightPiece>> light_pieces(const Scene& scene, std::uint32_t number) {
    const Object& object = scene.objects[number];
    const Motion* motion = motion_of(scene, object);
    const bool turns = motion && !only_translates(*motion);
    const auto shapes = std::visit(LightShapes(object, turns ? Affine{} : object.placement), object.shape);
    if (!shapes) return std::nullopt;
    const Color dark(0);
    const Color& front = object.sides == Sides::back ? dark : scene.materials[object.front].emission;
    const Color& back = object.sides == Sides::front ? dark : scene.materials[object.back].emission;
    const bool is_mesh = std::holds_alternative<std::shared_ptr<const Mesh>>(object.shape);
    std::vector<LightPiece> pieces;
    for (std::uint32_t part = 0; part < shapes->size(); ++part) {
        LightPiece piece{(*shapes)[part], {number, is_mesh ? part : 0}, front, back};
        if (turns) piece.turning = TurningLight{object.placement, *motion};
        if (motion && !turns) piece.velocity = convert<double>(motion->translation);
        pieces.push_back(piece);
    }
    return pieces;
}

}  // namespace raylab
