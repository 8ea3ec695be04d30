#include "raylab/scene/pov/texture.h"

#include "raylab/geometry/dominant_axis.h"
#include "raylab/geometry/predicate/flat_intersection.h"
#include "raylab/scene/mean_of_channels.h"
#include "raylab/scene/pov/words.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace raylab::pov {

namespace {

// POV-Ray's local light is pigment x (ambient + emission + diffuse N.L) x (1 - transmit): the pigment tints terms that
// the lab keeps apart, and a transmitting surface loses local light. The export divides by both, so neither may be zero
// where there is a term to divide.
constexpr double min_pigment = 0x1p-20, min_opacity = 0x1p-10;

bool is_black(const Color& color) { return color == Color{0, 0, 0}; }

std::string plain_texture(const Material& material, const Color& diffuse) {
    const Color own = material.ambient + material.emission;
    Color pigment = diffuse;
    for (int i = 0; i < 3; ++i)
        if (own[i] > 0) pigment[i] = std::max(pigment[i], min_pigment);
    const double opacity = is_black(pigment) ? 1 - material.kt : std::max(1 - material.kt, min_opacity);
    const auto undone = [&](const Color& color) {
        Color result{0, 0, 0};
        for (int i = 0; i < 3; ++i)
            if (color[i] > 0) result[i] = color[i] / (pigment[i] * opacity);
        return vector(result);
    };
    const double highlight = mean_of_channels(material.specular);
    return fmt::format("texture {{\n  pigment {{ color rgbt <{}, {}, {}, {}> }}\n", pigment.x, pigment.y, pigment.z,
                       1 - opacity) +
           fmt::format(
               "  finish {{ ambient rgb {} emission rgb {} diffuse {} phong {} phong_size {} reflection {{ {} }} "
               "}}\n}}",
               undone(material.ambient), undone(material.emission), is_black(pigment) ? 0 : 1 / opacity, highlight,
               material.shininess, material.kr);
}

// POV-Ray's checker has cells in space. A cell this thick contains the whole flat shape, so that only two dimensions
// matter.
constexpr double thickness = 1e7;

std::string cells_across(int axis, double size) {
    Vec3d scale(size), middle(0);
    scale[axis] = thickness;
    middle[axis] = -thickness / 2;
    return "scale " + vector(scale) + " translate " + vector(middle);
}

std::string checker(const std::string& name, const std::string& placed) {
    return "texture { checker texture { " + name + "_a } texture { " + name + "_b } " + placed + " }";
}

// The normal of a flat shape, in its own coordinates.
struct FlatNormal {
    std::optional<Vec3d> operator()(const Plane& plane) const { return convert<double>(plane.normal); }
    std::optional<Vec3d> operator()(const Disk& disk) const { return convert<double>(disk.normal); }
    std::optional<Vec3d> operator()(const Annulus& annulus) const { return convert<double>(annulus.normal); }
    std::optional<Vec3d> operator()(const Polygon& polygon) const { return newell_normal<double>(polygon); }
    std::optional<Vec3d> operator()(const Triangle& t) const {
        const Vec3d a = convert<double>(t.a);
        return cross(convert<double>(t.b) - a, convert<double>(t.c) - a);
    }
    template <class Curved>
    std::optional<Vec3d> operator()(const Curved&) const {
        return std::nullopt;
    }
};

glm::dmat3 linear_part(const Affine& placement) {
    const auto& c = placement.columns;
    return {convert<double>(c[0]), convert<double>(c[1]), convert<double>(c[2])};
}

// The place of an ellipsoid: its points are center + spread x, |x| = 1.
struct Spread {
    glm::dmat3 spread;
    Vec3d center;
};

std::optional<Spread> spread(const Object& object) {
    const glm::dmat3 linear = linear_part(object.placement);
    const auto of = [&](const Vec3f& center, const Vec3d& r) {
        const glm::dmat3 radii(r.x, 0, 0, 0, r.y, 0, 0, 0, r.z);
        return Spread{linear * radii, transform_point(object.placement, convert<double>(center))};
    };
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) return of(sphere->center, Vec3d(sphere->radius));
    if (const auto* e = std::get_if<Ellipsoid>(&object.shape)) return of(e->center, convert<double>(e->radii));
    return std::nullopt;
}

std::string matrix_of(const glm::dmat3& linear, const Vec3d& translation) {
    return matrix({linear[0], linear[1], linear[2]}, translation);
}

// An ellipsoid's normal is (spread spread^T)^-1 (p - center). POV-Ray's `cubic` pattern has one texture for each sign
// of each dominant axis: evaluated in coordinates where the point is the normal, it makes the lab's choice. The
// textures inside it are evaluated in these coordinates too, so their cells are transformed along with it.
std::string checker_around(const Spread& ellipsoid, const std::string& name, double size) {
    const glm::dmat3 from_normal = ellipsoid.spread * glm::transpose(ellipsoid.spread);
    const glm::dmat3 to_normal = glm::inverse(from_normal);
    std::string text = "texture { cubic";
    for (int i = 0; i < 6; ++i)
        text += "\n    " +
                checker(name, cells_across(i % 3, size) + " " + matrix_of(to_normal, -(to_normal * ellipsoid.center)));
    return text + "\n    " + matrix_of(from_normal, ellipsoid.center) + " }";
}

}  // namespace

std::string declared_material(const Material& material, std::size_t index) {
    const auto declare = [&](const char* cell, const Color& diffuse) {
        return fmt::format("#declare Material_{}{} = {}\n", index, cell, plain_texture(material, diffuse));
    };
    if (const auto* plain = std::get_if<Color>(&material.diffuse)) return declare("", *plain);
    const auto& cells = std::get<Checker>(material.diffuse);
    return declare("_a", cells.a) + declare("_b", cells.b);
}

std::string texture_on(const Object& object, const Material& material, std::size_t index) {
    const std::string name = fmt::format("Material_{}", index);
    const auto* cells = std::get_if<Checker>(&material.diffuse);
    if (!cells) return "texture { " + name + " }";
    if (const auto normal = std::visit(FlatNormal{}, object.shape)) {
        const auto placed = glm::transpose(glm::inverse(linear_part(object.placement))) * *normal;
        return checker(name, cells_across(dominant_axis(placed), cells->size));
    }
    if (const auto ellipsoid = spread(object)) return checker_around(*ellipsoid, name, cells->size);
    return checker(name, fmt::format("scale {}", cells->size));
}

bool says_checker_on(const Shape& shape) {
    return std::visit(FlatNormal{}, shape) || std::holds_alternative<Sphere>(shape) ||
           std::holds_alternative<Ellipsoid>(shape);
}

}  // namespace raylab::pov
