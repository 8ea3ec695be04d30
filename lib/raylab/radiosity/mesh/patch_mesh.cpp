#include "raylab/radiosity/mesh/patch_mesh.h"

#include "raylab/base/error.h"
#include "raylab/radiosity/form_factor/convex_polygon.h"
#include "raylab/radiosity/mesh/facet_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>

namespace raylab {

namespace {

bool shows(const Object& object, FacetSide side) {
    return object.sides == Sides::both || (object.sides == Sides::front) == (side == FacetSide::front);
}

// The centroid: where half-spheres stand and rays start.
Vec3d center_of(std::span<const Vec3d> polygon, const Vec3d& normal) {
    Vec3d sum{0, 0, 0};
    double all = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const double area = dot(cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]), normal);
        sum += area / 3 * (polygon[0] + polygon[i - 1] + polygon[i]);
        all += area;
    }
    return sum / all;
}

// Vertices of one smooth group and side that stand at one place are one. Places are compared as floats: two facets
// compute a shared corner by different sums.
class SharedVertices {
public:
    explicit SharedVertices(std::vector<Vec3d>& vertices) : vertices_(vertices) {}

    std::uint32_t number(std::uint32_t group, FacetSide side, const Vec3d& at) {
        const auto rounded = [](double x) { return static_cast<float>(x) + 0.0f; };  // no negative zero
        const Key key{group, side, rounded(at.x), rounded(at.y), rounded(at.z)};
        const auto [found, is_new] = numbers_.try_emplace(key, static_cast<std::uint32_t>(vertices_.size()));
        if (is_new) vertices_.push_back(at);
        return found->second;
    }

private:
    using Key = std::tuple<std::uint32_t, FacetSide, float, float, float>;
    std::vector<Vec3d>& vertices_;
    std::map<Key, std::uint32_t> numbers_;
};

std::optional<Patch> patch_of(const std::vector<Vec3d>& front_corners, std::uint32_t facet, FacetSide side) {
    Patch patch{.corner_count = static_cast<std::uint32_t>(front_corners.size()), .facet = facet, .side = side};
    std::ranges::copy(front_corners, patch.corners.begin());
    if (side == FacetSide::back) std::reverse(patch.corners.begin() + 1, patch.corners.begin() + patch.corner_count);
    const Vec3d area = area_vector(patch.polygon());
    patch.area = glm::length(area);
    if (!(patch.area > 0)) return std::nullopt;
    patch.normal = area / patch.area;
    patch.center = center_of(patch.polygon(), patch.normal);
    return patch;
}

Error too_many(const Scene& scene, std::size_t found, std::size_t most) {
    return {{scene.source},
            fmt::format("at most {} patches", most),
            fmt::format("more than {}; a larger --edge, or --patches N, makes fewer", found)};
}

// The number of patches that a mesh with this edge would have, without making it.
std::size_t patch_count(const PolygonalModel& model, double edge) {
    std::size_t count = 0;
    for (const Facet& facet : model.facets) {
        const Object& object = model.scene.objects[facet.occluder];
        count += cell_count(facet_cells(facet, edge)) * (object.sides == Sides::both ? 2 : 1);
    }
    return count;
}

}  // namespace

const Material& PatchMesh::material(const Patch& patch) const {
    const Object& of = object(patch);
    return model.scene.materials[patch.side == FacetSide::front ? of.front : of.back];
}

namespace {

void check_edge(double edge) {
    if (!(edge > 0 && edge < std::numeric_limits<double>::infinity()))
        throw Error(fmt::format("expected a length over 0 for the edge of patches, found {}", edge));
}

// Cuts the facets of a model into patches of this edge.
PatchMesh cut(const Scene& scene, PolygonalModel model, double edge, std::size_t most) {
    PatchMesh mesh{.model = std::move(model)};
    if (const auto count = patch_count(mesh.model, edge); count > most) throw too_many(scene, count - 1, most);
    mesh.facets_of_occluder.resize(mesh.model.scene.objects.size());
    SharedVertices shared(mesh.vertices);
    for (std::uint32_t number = 0; number < mesh.model.facets.size(); ++number) {
        const Facet& facet = mesh.model.facets[number];
        mesh.facets_of_occluder[facet.occluder].push_back(number);
        const FacetCells cells = facet_cells(facet, edge);
        std::array<PatchGrid, 2> grids{};
        for (const FacetSide side : {FacetSide::front, FacetSide::back}) {
            if (!shows(mesh.model.scene.objects[facet.occluder], side)) continue;
            grids[static_cast<std::size_t>(side)] = {static_cast<std::uint32_t>(mesh.patches.size()), cells.columns,
                                                     cells.rows, true};
            for (std::size_t cell = 0; cell < cell_count(cells); ++cell) {
                auto patch = patch_of(cell_corners(facet, cells, cell), number, side);
                if (!patch)
                    throw Error({scene.source, 0, scene.objects[facet.object].path}, "a surface with an area",
                                "a piece without one");
                for (std::size_t i = 0; i < patch->corner_count; ++i)
                    patch->vertices[i] = shared.number(facet.smooth, side, patch->corners[i]);
                mesh.patches.push_back(*patch);
            }
        }
        mesh.grids.push_back(grids);
    }
    return mesh;
}

}  // namespace

PatchMesh patch_mesh(const Scene& scene, const MeshOptions& options, std::size_t most) {
    check_edge(options.edge);
    return cut(scene, polygonal_model(scene, options.edge), options.edge, most);
}

PatchMesh pieces_of(const Scene& scene, double edge) {
    check_edge(edge);
    return cut(scene, polygonal_model(scene, edge), std::numeric_limits<double>::infinity(), 1'000'000);
}

double edge_for_patches(const Scene& scene, std::size_t patches) {
    double low = 0, high = 1;  // of log2: the counts fall from low to high
    const auto count = [&](double exponent) {
        const double edge = std::exp2(exponent);
        return patch_count(polygonal_model(scene, edge), edge);
    };
    while (count(high) > patches && high < 40) high += 1;
    low = high - 1;
    while (count(low) <= patches && low > -40) low -= 1;
    if (low > high - 1) low = high - 1;
    for (int i = 0; i < 30; ++i) {
        const double middle = (low + high) / 2;
        (count(middle) <= patches ? high : low) = middle;
    }
    return std::exp2(high);
}

PatchPlace patch_at(const PatchMesh& mesh, std::uint32_t occluder, FacetSide side, const Vec3d& point) {
    const auto& facets = mesh.facets_of_occluder[occluder];
    const auto nearest = [&] {
        if (facets.size() == 1) return FacetPlace{facets[0], facet_parameters(mesh.model.facets[facets[0]], point)};
        FacetPlace best{facets[0], {}};
        double least = std::numeric_limits<double>::infinity();
        for (const std::uint32_t facet : facets) {
            const FacetParameters at = facet_parameters(mesh.model.facets[facet], point);
            if (const double out = distance_outside(at, mesh.model.facets[facet]); out < least) {
                least = out;
                best = {facet, at};
            }
        }
        return best;
    }();
    const Facet& facet = mesh.model.facets[nearest.facet];
    const PatchGrid& grid = mesh.grids[nearest.facet][static_cast<std::size_t>(side)];
    auto [cell, weights] = cell_at(facet, {grid.columns, grid.rows}, nearest.at);
    if (side == FacetSide::back)
        std::reverse(weights.begin() + 1, weights.begin() + static_cast<std::ptrdiff_t>(facet.corners.size()));
    return {grid.first + cell, weights};
}

}  // namespace raylab
