#include "raylab/radiosity/mesh/polygonal_model.h"

#include "raylab/base/error.h"
#include "raylab/radiosity/mesh/tessellation.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace raylab {

namespace {

constexpr std::size_t most_facets = 1'000'000;

// How much longer a vector can become by a transform; the root of the sum of its squares is a bound.
double stretch(const Affine& placement) {
    double sum = 0;
    for (const Vec3f& column : placement.columns) sum += dot(convert<double>(column), convert<double>(column));
    return placement.is_identity() ? 1 : std::sqrt(sum);
}

bool mirrors(const Affine& placement) {
    const auto& [x, y, z] = placement.columns;
    return dot(cross(convert<double>(x), convert<double>(y)), convert<double>(z)) < 0;
}

// The corners at their place, rounded to floats as rays meet them; a mirrored polygon turns the other way round.
std::vector<Vec3d> placed(const std::vector<Vec3d>& corners, const Affine& placement) {
    std::vector<Vec3d> result;
    for (const Vec3d& corner : corners)
        result.push_back(convert<double>(convert<float>(transform_point(placement, corner))));
    if (mirrors(placement)) std::ranges::reverse(result);
    return result;
}

Shape shape_of(const std::vector<Vec3d>& corners) {
    if (corners.size() == 3)
        return Triangle{convert<float>(corners[0]), convert<float>(corners[1]), convert<float>(corners[2])};
    Polygon polygon;
    for (const Vec3d& corner : corners) polygon.vertices.push_back(convert<float>(corner));
    return polygon;
}

void refuse_plane(const Scene& scene, const Object& object) {
    if (std::holds_alternative<Plane>(object.shape))
        throw Error({scene.source, 0, object.path}, "shapes of finite area, which can be cut into patches",
                    "an infinite plane");
}

}  // namespace

PolygonalModel polygonal_model(const Scene& scene, double edge) {
    PolygonalModel model{.scene = scene, .facets = {}};
    model.scene.objects.clear();
    std::uint32_t smooth_groups = 0;
    for (std::uint32_t number = 0; number < scene.objects.size(); ++number) {
        const Object& object = scene.objects[number];
        refuse_plane(scene, object);
        const double factor = stretch(object.placement);
        if (model.facets.size() + piece_count(object.shape, edge / factor) > most_facets)
            throw Error({scene.source, 0, object.path}, "at most a million flat pieces in all",
                        "more: a larger --edge makes fewer");
        const Tessellation cut = tessellation(object.shape, edge / factor);
        model.error = std::max(model.error, cut.error * factor);
        std::map<std::uint32_t, std::uint32_t> groups;
        for (const FlatPolygon& polygon : cut.polygons) {
            const auto occluder = static_cast<std::uint32_t>(model.scene.objects.size());
            Object flat = object;
            flat.shape = shape_of(placed(polygon.corners, object.placement));
            flat.placement = {};
            model.scene.objects.push_back(std::move(flat));
            for (const FlatPiece& piece : polygon.pieces) {
                const auto [group, is_new] = groups.try_emplace(piece.smooth, smooth_groups);
                if (is_new) ++smooth_groups;
                model.facets.push_back(
                    {placed(piece.corners, object.placement), number, piece.part, occluder, group->second});
            }
        }
    }
    return model;
}

}  // namespace raylab
