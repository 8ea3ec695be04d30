#include "raylab/radiosity/mesh/patch_mesh.h"

#include "raylab/base/error.h"
#include "raylab/radiosity/form_factor/convex_polygon.h"
#include "raylab/radiosity/mesh/contact_lines.h"
#include "raylab/radiosity/mesh/facet_grid.h"
#include "raylab/radiosity/mesh/shared_vertices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace raylab {

namespace {

bool shows(const Object& object, FacetSide side) {
    return object.sides == Sides::both || (object.sides == Sides::front) == (side == FacetSide::front);
}

// The patch of a cell, whose corners are counter-clockwise seen from the front.
std::optional<Patch> patch_of_cell(std::vector<Vec3d> corners, std::uint32_t facet, FacetSide side) {
    if (side == FacetSide::back) std::reverse(corners.begin() + 1, corners.end());
    return patch_of(corners, facet, side);
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

bool PatchMesh::has_patches(std::uint32_t occluder, FacetSide side) const {
    return shows(model.scene.objects[occluder], side);
}

FacetSide PatchMesh::side_towards(std::uint32_t occluder, const Vec3d& direction) const {
    const auto& corners = model.facets[facets_of_occluder[occluder].front()].corners;
    return dot(area_vector(corners), direction) > 0 ? FacetSide::front : FacetSide::back;
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
            grids[static_cast<std::size_t>(side)] = {static_cast<std::uint32_t>(mesh.cells.size()), cells.columns,
                                                     cells.rows, true};
            for (std::size_t cell = 0; cell < cell_count(cells); ++cell) {
                auto patch = patch_of_cell(cell_corners(facet, cells, cell), number, side);
                if (!patch)
                    throw Error({scene.source, 0, scene.objects[facet.object].path}, "a surface with an area",
                                "a piece without one");
                for (std::size_t i = 0; i < patch->corner_count; ++i)
                    patch->vertices[i] = shared.number(facet.smooth, side, patch->corners[i]);
                mesh.cells.push_back({PatchCell::Kind::patch, static_cast<std::uint32_t>(mesh.patches.size())});
                mesh.patches.push_back(*patch);
            }
        }
        mesh.grids.push_back(grids);
    }
    return mesh;
}

// A scene's flat pieces, cut along the lines that are asked for.
PolygonalModel cut_model(const Scene& scene, const MeshOptions& options) {
    check_edge(options.edge);
    PolygonalModel model = polygonal_model(scene, options.edge);
    return options.lines == MeshLines::contact ? with_contact_lines(std::move(model)) : model;
}

}  // namespace

PatchMesh patch_mesh(const Scene& scene, const MeshOptions& options, std::size_t most) {
    return cut(scene, cut_model(scene, options), options.edge, most);
}

PatchMesh pieces_of(const Scene& scene, const MeshOptions& options) {
    return cut(scene, cut_model(scene, options), std::numeric_limits<double>::infinity(), 1'000'000);
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
    auto [number, weights] = cell_at(facet, {grid.columns, grid.rows}, nearest.at);
    if (side == FacetSide::back)
        std::reverse(weights.begin() + 1, weights.begin() + static_cast<std::ptrdiff_t>(facet.corners.size()));
    PatchCell cell = mesh.cells[grid.first + number];
    while (cell.kind == PatchCell::Kind::quartered) {
        const QuarterPlace place = quarter_at(static_cast<std::uint32_t>(facet.corners.size()), weights);
        cell = mesh.cells[cell.number + place.quarter];
        weights = place.weights;
    }
    return {cell.number, weights};
}

}  // namespace raylab
