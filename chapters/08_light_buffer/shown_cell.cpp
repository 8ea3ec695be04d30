#include "shown_cell.h"

#include <fmt/format.h>

namespace raylab::lantern {

Vec3d light_of(const Scene& scene) { return std::get<PointLight>(scene.lights.front().kind).position; }

LightBuffer buffer_of(const Scene& scene, int resolution) {
    return LightBuffer(scene, light_of(scene), {.resolution = resolution});
}

LightCell shown_cell(const Scene& scene) { return light_cell(shown_point - light_of(scene), coarse); }

LightPyramid shown_pyramid(const Scene& scene) {
    const LightCell cell = shown_cell(scene);
    const auto border = [](int cells) { return 2.0 * cells / coarse - 1; };
    return {cell.face, border(cell.column), border(cell.column + 1), border(cell.row), border(cell.row + 1)};
}

std::string plain_name(const Scene& scene, const LightBuffer& buffer, std::uint32_t place) {
    const std::string path = scene.objects[buffer.primitive(place).object].path;
    if (path.starts_with("side") && path.find("cylinder") != path.npos) return "bar of the cage";
    return path == "sphere 0" ? "red ball" : path == "polygon 0" ? "floor" : path == "polygon 2" ? "wall" : path;
}

std::vector<std::string> cell_header() { return {"place in the list", "primitive", "depth at least [m]"}; }

std::vector<std::vector<std::string>> cell_rows(const Scene& scene) {
    const LightBuffer buffer = buffer_of(scene, coarse);
    std::vector<std::vector<std::string>> rows;
    for (const auto& [primitive, depth] : buffer.list(shown_cell(scene)))
        rows.push_back(
            {std::to_string(rows.size() + 1), plain_name(scene, buffer, primitive), fmt::format("{:.3f}", depth)});
    return rows;
}

}  // namespace raylab::lantern
