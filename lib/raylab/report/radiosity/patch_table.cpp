#include "raylab/report/radiosity/patch_table.h"

#include <fmt/format.h>

#include <iterator>
#include <numbers>

namespace raylab {

namespace {

// A path of the scene is quoted: it may hold a comma.
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

std::string three(const Vec3d& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

}  // namespace

std::string patch_table(const SolvedScene& solved) {
    std::string text =
        "path,part,side,cx,cy,cz,nx,ny,nz,area,emission_r,emission_g,emission_b,reflectance_r,reflectance_g,"
        "reflectance_b,radiosity_r,radiosity_g,radiosity_b\n";
    for (std::size_t i = 0; i < solved.mesh.patches.size(); ++i) {
        const Patch& patch = solved.mesh.patches[i];
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{}\n", quoted(solved.mesh.object(patch).path),
                       solved.mesh.model.facets[patch.facet].part, patch.side == FacetSide::front ? "front" : "back",
                       three(patch.center), three(patch.normal), patch.area,
                       three(std::numbers::pi * solved.mesh.material(patch).emission),
                       three(solved.system.reflectance[i]), three(solved.patches[i]));
    }
    return text;
}

std::string vertex_table(const SolvedScene& solved) {
    std::string text = "x,y,z,radiosity_r,radiosity_g,radiosity_b\n";
    for (std::size_t i = 0; i < solved.mesh.vertices.size(); ++i)
        text += three(solved.mesh.vertices[i]) + "," + three(solved.vertices[i]) + "\n";
    return text;
}

}  // namespace raylab
