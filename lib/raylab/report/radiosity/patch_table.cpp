#include "raylab/report/radiosity/patch_table.h"

#include "raylab/report/table.h"

#include <fmt/format.h>

#include <initializer_list>
#include <numbers>
#include <vector>

namespace raylab {

namespace {

// Appends the numbers of some vectors, each so that reading it gives the same bits.
void append(std::vector<std::string>& cells, std::initializer_list<Vec3d> vectors) {
    for (const Vec3d& v : vectors)
        for (int axis = 0; axis < 3; ++axis) cells.push_back(fmt::format("{}", v[axis]));
}

}  // namespace

std::string patch_table(const SolvedScene& solved) {
    std::string text = csv_record({"path", "part", "side", "cx", "cy", "cz", "nx", "ny", "nz", "area", "emission_r",
                                   "emission_g", "emission_b", "reflectance_r", "reflectance_g", "reflectance_b",
                                   "radiosity_r", "radiosity_g", "radiosity_b"});
    for (std::size_t i = 0; i < solved.mesh.patches.size(); ++i) {
        const Patch& patch = solved.mesh.patches[i];
        std::vector<std::string> cells{solved.mesh.object(patch).path,
                                       std::to_string(solved.mesh.model.facets[patch.facet].part),
                                       patch.side == FacetSide::front ? "front" : "back"};
        append(cells, {patch.center, patch.normal});
        cells.push_back(fmt::format("{}", patch.area));
        append(cells,
               {std::numbers::pi * solved.mesh.material(patch).emission, solved.reflectance[i], solved.patches[i]});
        text += csv_record(cells);
    }
    return text;
}

std::string vertex_table(const SolvedScene& solved) {
    std::string text = csv_record({"x", "y", "z", "radiosity_r", "radiosity_g", "radiosity_b"});
    for (std::size_t i = 0; i < solved.mesh.vertices.size(); ++i) {
        std::vector<std::string> cells;
        append(cells, {solved.mesh.vertices[i], solved.vertices[i]});
        text += csv_record(cells);
    }
    return text;
}

}  // namespace raylab
