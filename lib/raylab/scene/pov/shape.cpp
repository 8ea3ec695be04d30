#include "raylab/scene/pov/shape.h"

#include "raylab/geometry/dominant_axis.h"
#include "raylab/geometry/local_frame.h"
#include "raylab/geometry/predicate/flat_intersection.h"
#include "raylab/scene/pov/words.h"

#include <cmath>

namespace raylab::pov {

namespace {

// The box that clips a quadric at its ends must not clip its sides.
constexpr double clear_of_the_side = 1.25;

const char* open_word(Ends ends) { return ends == Ends::open ? " open" : ""; }

// A quadric in coordinates of its own, clipped to |x|, |y| <= reach and bottom <= z <= 1.
std::string cut_quadric(const std::string& coefficients, double bottom, double reach, Ends ends) {
    const double side = clear_of_the_side * reach;
    const std::string box = fmt::format("box {{ <{}, {}, {}>, <{}, {}, 1> }}", -side, -side, bottom, side, side);
    if (ends == Ends::capped) return "intersection { quadric { " + coefficients + " } " + box;
    return "quadric { " + coefficients + " clipped_by { " + box + " }";
}

// POV-Ray computes a polygon's front from its first three vertices, so that corner must be a convex one; the most
// convex one is chosen. The vertices are projected to the polygon's exact plane, because the lab's polygon lies there,
// and because POV-Ray requires planar ones.
std::string flat_vertices(const Polygon& polygon) {
    const Vec3d normal = newell_normal<double>(polygon);
    const int k = dominant_axis(normal);
    const auto [i, j] = other_axes(k);
    std::vector<Vec3d> vertices;
    for (const Vec3f& each : polygon.vertices) vertices.push_back(convert<double>(each));
    const Vec3d first = vertices[0];
    for (Vec3d& v : vertices)
        v[k] = first[k] - (normal[i] * (v[i] - first[i]) + normal[j] * (v[j] - first[j])) / normal[k];

    const std::size_t count = vertices.size();
    const auto turn = [&](std::size_t at) {
        const Vec3d &a = vertices[at], &b = vertices[(at + 1) % count], &c = vertices[(at + 2) % count];
        return dot(cross(b - a, c - a), normal);
    };
    std::size_t start = 0;
    for (std::size_t at = 1; at < count; ++at)
        if (turn(at) > turn(start)) start = at;

    std::string text;
    for (std::size_t at = 0; at <= count; ++at) text += ", " + vector(vertices[(start + at) % count]);
    return text;
}

std::string placement_words(const Affine& placement) {
    if (placement.is_identity()) return "";
    const AffineSteps doubles = AffineSteps::of(placement);
    return "\n  " + matrix(doubles.columns, doubles.translation);
}

// Transforms the triangle's vertices here, in doubles, as POV-Ray would: each coordinate is within 4 * 2^-53 of the sum
// of its terms' magnitudes. POV-Ray must not do it: it reorders the vertices of a triangle when it reads them, and
// again when it transforms them, and the second time the normal becomes that of the reordered ones, so that front and
// back may change places (Compute_Triangle in POV-Ray 3.7's triangle.cpp). A mirror transform reverses the order in
// which they are seen from the front.
TriangleOf<double> image_of(const Triangle& t, const Affine& placement) {
    const auto image = [&](const Vec3f& vertex) { return transform_point(placement, convert<double>(vertex)); };
    const auto [x, y, z] = AffineSteps::of(placement).columns;
    const bool is_mirrored = dot(x, cross(y, z)) < 0;
    return {image(t.a), image(is_mirrored ? t.c : t.b), image(is_mirrored ? t.b : t.c)};
}

struct Words {
    const Affine& placement;
    const std::string& mesh_name;

    std::string operator()(const Sphere& s) const {
        return fmt::format("sphere {{ {}, {}", vector(s.center), double(s.radius));
    }
    std::string operator()(const Ellipsoid& e) const {
        return fmt::format("sphere {{ <0, 0, 0>, 1 scale {} translate {}", vector(e.radii), vector(e.center));
    }
    std::string operator()(const Cylinder& c) const {
        return fmt::format("cylinder {{ {}, {}, {}{}", vector(c.base), vector(c.top), double(c.radius),
                           open_word(c.ends));
    }
    std::string operator()(const Cone& c) const {
        return fmt::format("cone {{ {}, {}, {}, {}{}", vector(c.base), double(c.base_radius), vector(c.top),
                           double(c.top_radius), open_word(c.ends));
    }
    // x^2 + y^2 = z in units of the radius across the axis, and of the length along it.
    std::string operator()(const Paraboloid& p) const {
        const Vec3d base = convert<double>(p.base), axis = convert<double>(p.top) - base;
        const auto [x, y, z] = frame_around(glm::normalize(axis));
        return cut_quadric("<1, 1, 0>, <0, 0, 0>, <0, 0, -1>, 0", -1, 1, p.ends) + " " +
               matrix({double(p.radius) * x, double(p.radius) * y, axis}, base);
    }
    // x^2 + y^2 = 1 + k z^2 in units of the waist across the axis, and of half its length along it, from its middle.
    std::string operator()(const Hyperboloid& h) const {
        const Vec3d base = convert<double>(h.base), half_axis = 0.5 * (convert<double>(h.top) - base);
        const auto [x, y, z] = frame_around(glm::normalize(half_axis));
        const double waist = h.waist, width = h.radius / waist;
        return cut_quadric(fmt::format("<1, 1, {}>, <0, 0, 0>, <0, 0, 0>, -1", -(width - 1) * (width + 1)), -1, width,
                           h.ends) +
               " " + matrix({waist * x, waist * y, half_axis}, base + half_axis);
    }
    std::string operator()(const Plane& p) const {
        return fmt::format("plane {{ {}, 0 translate {}", vector(p.normal), vector(p.point));
    }
    std::string operator()(const Disk& d) const {
        return fmt::format("disc {{ {}, {}, {}", vector(d.center), vector(d.normal), double(d.radius));
    }
    std::string operator()(const Annulus& a) const {
        return fmt::format("disc {{ {}, {}, {}, {}", vector(a.center), vector(a.normal), double(a.outer_radius),
                           double(a.inner_radius));
    }
    std::string operator()(const Polygon& p) const {
        return fmt::format("polygon {{ {}{}", p.vertices.size() + 1, flat_vertices(p));
    }
    // POV-Ray is left-handed: the front is where the vertices run clockwise.
    std::string operator()(const Triangle& t) const {
        const auto [a, b, c] = image_of(t, placement);
        return fmt::format("triangle {{ {}, {}, {}", vector(a), vector(c), vector(b));
    }
    std::string operator()(const std::shared_ptr<const Mesh>&) const { return "object { " + mesh_name; }
};

}  // namespace

std::string placed_shape(const Shape& shape, const Affine& placement, const std::string& mesh_name) {
    const std::string words = std::visit(Words{placement, mesh_name}, shape);
    return std::holds_alternative<Triangle>(shape) ? words : words + placement_words(placement);
}

// POV-Ray decides whether a mesh is opaque by its texture and its texture list, whatever interior_texture says (its
// Test_Mesh_Opacity). So that light passes where the mesh is invisible, the list names a clear texture that no face
// uses.
std::string mesh(const Mesh& mesh, MeshShadow shadow) {
    const auto vectors = [](const char* word, const std::vector<Vec3f>& all) {
        std::string text = fmt::format("  {} {{ {}", word, all.size());
        for (const Vec3f& each : all) text += ",\n    " + vector(each);
        return text + " }\n";
    };
    std::string text = "mesh2 {\n" + vectors("vertex_vectors", mesh.vertices);
    if (!mesh.normals.empty()) text += vectors("normal_vectors", mesh.normals);
    if (shadow == MeshShadow::by_texture) text += "  texture_list { 1, texture { Unseen } }\n";
    text += fmt::format("  face_indices {{ {}", mesh.faces.size());
    for (const auto& face : mesh.faces) text += fmt::format(",\n    <{}, {}, {}>", face.a, face.c, face.b);
    return text + " }\n}";
}

}  // namespace raylab::pov
