#include "raylab/report/radiosity/radiosity_gltf.h"

#include "raylab/base/bytes.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

namespace raylab {

namespace {

constexpr int array_buffer = 34962, element_array_buffer = 34963, floats = 5126, unsigned_ints = 5125, triangles = 4;

/// The binary part of the file, and where its pieces stand.
class Buffer {
public:
    template <Number T>
    int add(const std::vector<T>& numbers, int target) {
        const std::size_t begin = bytes_.size();
        for (const T number : numbers) append_number(bytes_, number, std::endian::little);
        views_.push_back(
            {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes_.size() - begin}, {"target", target}});
        return static_cast<int>(views_.size()) - 1;
    }
    const nlohmann::ordered_json& views() const { return views_; }
    const std::string& bytes() const { return bytes_; }

private:
    nlohmann::ordered_json views_ = nlohmann::ordered_json::array();
    std::string bytes_;
};

std::vector<float> coordinates(const std::vector<Vec3d>& points, double factor) {
    std::vector<float> numbers;
    for (const Vec3d& p : points)
        for (int axis = 0; axis < 3; ++axis) numbers.push_back(static_cast<float>(factor * p[axis]));
    return numbers;
}

nlohmann::ordered_json accessor(int view, std::size_t count, int type, const char* shape) {
    return {{"bufferView", view}, {"componentType", type}, {"count", count}, {"type", shape}};
}

// The format asks for the least and largest coordinates of positions.
nlohmann::ordered_json positions(int view, const std::vector<float>& numbers) {
    auto result = accessor(view, numbers.size() / 3, floats, "VEC3");
    std::array<float, 3> least, largest;
    least.fill(std::numeric_limits<float>::infinity());
    largest.fill(-std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        least[i % 3] = std::min(least[i % 3], numbers[i]);
        largest[i % 3] = std::max(largest[i % 3], numbers[i]);
    }
    result["min"] = least;
    result["max"] = largest;
    return result;
}

std::vector<std::uint32_t> triangle_indices(const PatchMesh& mesh) {
    std::vector<std::uint32_t> indices;
    for (const Patch& patch : mesh.patches)
        for (std::uint32_t i = 2; i < patch.corner_count; ++i)
            for (const auto corner : {patch.vertices[0], patch.vertices[i - 1], patch.vertices[i]})
                indices.push_back(corner);
    return indices;
}

void append_size(std::string& bytes, std::size_t size) {
    append_number(bytes, static_cast<std::uint32_t>(size), std::endian::little);
}

// A chunk is filled up to a multiple of four bytes.
std::string chunk(std::string bytes, const char* kind, char filler) {
    bytes.resize((bytes.size() + 3) / 4 * 4, filler);
    std::string head;
    append_size(head, bytes.size());
    return head + std::string(kind, 4) + bytes;
}

}  // namespace

std::string radiosity_gltf(const SolvedScene& solved, double exposure) {
    Buffer buffer;
    const auto places = coordinates(solved.mesh.vertices, 1);
    const auto radiance = coordinates(solved.vertices, 1 / std::numbers::pi);
    auto colors = coordinates(solved.vertices, exposure / std::numbers::pi);
    for (float& color : colors) color = std::clamp(color, 0.0f, 1.0f);
    const auto indices = triangle_indices(solved.mesh);
    const int place_view = buffer.add(places, array_buffer), color_view = buffer.add(colors, array_buffer),
              radiance_view = buffer.add(radiance, array_buffer),
              index_view = buffer.add(indices, element_array_buffer);
    const std::size_t count = solved.mesh.vertices.size();
    const nlohmann::ordered_json model = {
        {"asset", {{"version", "2.0"}, {"generator", "raylab radiosity"}}},
        {"extensionsUsed", {"KHR_materials_unlit"}},
        {"scene", 0},
        {"scenes", {{{"nodes", {0}}}}},
        {"nodes", {{{"mesh", 0}}}},
        {"meshes",
         {{{"primitives",
            {{{"attributes", {{"POSITION", 0}, {"COLOR_0", 1}, {"_RADIANCE", 2}}},
              {"indices", 3},
              {"material", 0},
              {"mode", triangles}}}}}}},
        {"materials", {{{"extensions", {{"KHR_materials_unlit", nlohmann::ordered_json::object()}}}}}},
        {"accessors",
         {positions(place_view, places), accessor(color_view, count, floats, "VEC3"),
          accessor(radiance_view, count, floats, "VEC3"),
          accessor(index_view, indices.size(), unsigned_ints, "SCALAR")}},
        {"bufferViews", buffer.views()},
        {"buffers", {{{"byteLength", buffer.bytes().size()}}}}};
    const std::string chunks = chunk(model.dump(), "JSON", ' ') + chunk(buffer.bytes(), "BIN\0", '\0');
    std::string file = "glTF";
    append_size(file, 2);  // the format's version
    append_size(file, 12 + chunks.size());
    return file + chunks;
}

double exposure_for(const SolvedScene& solved) {
    std::vector<std::pair<double, double>> brightness;  // and area
    double all = 0;
    for (std::size_t i = 0; i < solved.patches.size(); ++i) {
        const Color& b = solved.patches[i];
        brightness.emplace_back(std::max({b.r, b.g, b.b}) / std::numbers::pi, solved.mesh.patches[i].area);
        all += solved.mesh.patches[i].area;
    }
    std::ranges::sort(brightness);
    double below = 0;
    for (const auto& [radiance, area] : brightness)
        if ((below += area) >= 0.95 * all && radiance > 0) return 1 / radiance;
    return 1;
}

}  // namespace raylab
