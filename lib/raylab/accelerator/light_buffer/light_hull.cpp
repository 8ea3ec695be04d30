#include "raylab/accelerator/light_buffer/light_hull.h"

#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/predicate/flat_intersection.h"
#include "raylab/number/enclosure.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

using SeenHull = Silhouette::Hull;

Vec3<Enclosure> placed(const Affine& m, const Vec3f& p) {
    const auto along = [&](int i) {
        return Enclosure(m.columns[0][i]) * Enclosure(p.x) + Enclosure(m.columns[1][i]) * Enclosure(p.y) +
               Enclosure(m.columns[2][i]) * Enclosure(p.z) + Enclosure(m.translation[i]);
    };
    return {along(0), along(1), along(2)};
}

/// Collects corners, and how far the exact ones may be off.
class Corners {
public:
    Corners(const Vec3d& light, const Affine& placement, SeenHull& hull)
        : light_(convert<Enclosure>(light)), placement_(placement), hull_(hull) {}

    void add(const Vec3f& corner) { add(placed(placement_, corner)); }
    void add(const Vec3<Enclosure>& corner) {
        const Vec3<Enclosure> seen = corner - light_;
        hull_.corners.push_back({seen.x.middle(), seen.y.middle(), seen.z.middle()});
        error_ = std::max(error_, seen.x.radius() + seen.y.radius() + seen.z.radius());
    }
    double error() const { return error_; }

private:
    Vec3<Enclosure> light_;
    Affine placement_;
    SeenHull& hull_;
    double error_ = 0;
};

void close_round(SeenHull& hull) {
    const std::size_t count = hull.corners.size();
    for (std::size_t i = 0; i < count; ++i) hull.edges.push_back({i, (i + 1) % count});
    Vec3d normal{0};
    for (std::size_t i = 1; i + 1 < count; ++i)
        normal += cross(hull.corners[i] - hull.corners[0], hull.corners[i + 1] - hull.corners[0]);
    hull.face_normals.push_back(normal);
}

Silhouette::Hull::Covers covers(Sides sides, std::size_t corners) {
    // A polygon of more corners may wind about its inside twice, which leaves it out (the even-odd rule).
    return sides == Sides::both && corners <= 4 ? Silhouette::Hull::Covers::perhaps : Silhouette::Hull::Covers::never;
}

// The distance by which a polygon's exact surface may lie beside its float vertices: each is moved into the exact plane
// along the normal's dominant axis (shapes.h), and no farther along any other.
double warp(const Polygon& polygon, const Affine& placement) {
    const Vec3<Enclosure> normal = newell_normal<Enclosure>(polygon),
                          first = convert<Enclosure>(polygon.vertices.front());
    const double dominant =
        std::max({std::abs(normal.x.middle()) - normal.x.radius(), std::abs(normal.y.middle()) - normal.y.radius(),
                  std::abs(normal.z.middle()) - normal.z.radius()});
    double height = 0;
    for (const Vec3f& vertex : polygon.vertices) {
        const Enclosure above = dot(normal, convert<Enclosure>(vertex) - first);
        height = std::max(height, std::abs(above.middle()) + above.radius());
    }
    double stretch = 0;  // by the placement, at most: the sum of its columns' lengths
    for (const Vec3f& column : placement.columns) stretch += glm::length(convert<double>(column));
    return height == 0 ? 0
                       : height / dominant * stretch * (1 + 0x1p-40);  // dominant <= 0: infinite or negative, see below
}

struct HullOf {
    const Vec3d& light;
    const Target& target;
    double blur;

    SeenHull triangle(const Triangle& t) const {
        SeenHull hull;
        Corners corners(light, *target.placement, hull);
        for (const Vec3f& corner : {t.a, t.b, t.c}) corners.add(corner);
        hull.blur = blur + corners.error();
        hull.covers = covers(target.sides, 3);
        close_round(hull);
        return hull;
    }

    std::optional<SeenHull> box() const {
        const auto found = bounds(*target.shape, *target.placement);
        if (!found) return std::nullopt;
        SeenHull hull;
        Corners corners(light, {}, hull);
        for (std::size_t i = 0; i < 8; ++i) {
            const auto pick = [&](int axis) { return (i >> axis & 1) ? found->max[axis] : found->min[axis]; };
            corners.add(Vec3f(pick(0), pick(1), pick(2)));
            for (const std::size_t bit : {1u, 2u, 4u})
                if (!(i & bit)) hull.edges.push_back({i, i | bit});
        }
        hull.face_normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        hull.blur = blur + corners.error();
        return hull;
    }

    std::optional<SeenHull> operator()(const Triangle& t) const { return triangle(t); }
    std::optional<SeenHull> operator()(const std::shared_ptr<const Mesh>& mesh) const {
        return triangle(mesh->triangle(target.part));
    }
    std::optional<SeenHull> operator()(const Polygon& polygon) const {
        const double off = warp(polygon, *target.placement);
        if (!(off >= 0 && std::isfinite(off))) return box();
        SeenHull hull;
        Corners corners(light, *target.placement, hull);
        for (const Vec3f& vertex : polygon.vertices) corners.add(vertex);
        hull.blur = blur + corners.error() + off;
        hull.covers = covers(target.sides, polygon.vertices.size());
        close_round(hull);
        return hull;
    }
    std::optional<SeenHull> operator()(const Sphere& sphere) const {
        if (!target.placement->is_identity()) return box();
        SeenHull hull;
        Corners corners(light, {}, hull);
        corners.add(sphere.center);
        hull.blur = blur + corners.error();
        hull.ball = sphere.radius;
        hull.covers = target.sides == Sides::both ? Silhouette::Hull::Covers::perhaps : Silhouette::Hull::Covers::never;
        return hull;
    }
    template <class S>
    std::optional<SeenHull> operator()(const S&) const {
        return box();
    }
};

}  // namespace

std::optional<SeenHull> hull_from(const Vec3d& light, const Target& target, double blur) {
    if (target.motion) return std::nullopt;  // rays of each time see it elsewhere
    const auto hull = std::visit(HullOf{light, target, blur}, *target.shape);
    const auto finite = [](const Vec3d& p) { return std::isfinite(dot(p, p)); };
    if (!hull || !std::ranges::all_of(hull->corners, finite)) return std::nullopt;
    return hull;
}

}  // namespace raylab
