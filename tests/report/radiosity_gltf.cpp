#include "catch.h"

#include "raylab/radiosity/scene_radiosity.h"
#include "raylab/report/radiosity/patch_table.h"
#include "raylab/report/radiosity/radiosity_gltf.h"

#include <nlohmann/json.hpp>

#include <cstring>
#include <numbers>

using namespace raylab;

namespace {

// A square that glows in three colours, one of them brighter than white.
Scene glowing_square() {
    Scene scene;
    scene.source = "test.toml";
    scene.materials = {{.diffuse = Color(0.5), .emission = Color(0.25, 1, 4)}};
    scene.objects = {{.shape = Polygon{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}},
                      .sides = Sides::front,
                      .path = "a, \"square\""}};
    return scene;
}

std::uint32_t word(const std::string& bytes, std::size_t at) {
    std::uint32_t value;
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
}

float number(const std::string& binary, const nlohmann::json& model, int accessor, std::size_t i) {
    const auto& view = model["bufferViews"][model["accessors"][accessor]["bufferView"].get<std::size_t>()];
    float value;
    std::memcpy(&value, binary.data() + view["byteOffset"].get<std::size_t>() + 4 * i, 4);
    return value;
}

}  // namespace

TEST_CASE("a solved scene as glTF: its chunks, its triangles, clamped colours beside the radiance as it is") {
    const auto solved = scene_radiosity(glowing_square(), {.edge = 1});
    const SolvedScene result{*solved.mesh, solved.system.reflectance, solved.solution.radiosity, solved.vertices};
    const std::string file = radiosity_gltf(result, 0.5);
    REQUIRE(file.substr(0, 4) == "glTF");
    CHECK(word(file, 4) == 2);
    CHECK(word(file, 8) == file.size());
    const std::size_t json_size = word(file, 12), binary_at = 20 + json_size + 8;
    CHECK((json_size % 4 == 0 && file.substr(16, 4) == "JSON"));
    const auto model = nlohmann::json::parse(file.substr(20, json_size));
    const std::string binary = file.substr(binary_at);
    CHECK(word(file, 20 + json_size) == binary.size());
    CHECK(model["buffers"][0]["byteLength"] == binary.size());
    CHECK(model["accessors"][0]["count"] == 6);   // two patches share an edge
    CHECK(model["accessors"][3]["count"] == 12);  // of two triangles each
    CHECK(model["accessors"][0]["max"] == nlohmann::json{2, 1, 0});
    const std::array<float, 3> colors{0.125f, 0.5f, 1}, radiance{0.25f, 1, 4};
    for (std::size_t i = 0; i < 18; ++i) {
        CHECK(number(binary, model, 1, i) == Approx(colors[i % 3]));
        CHECK(number(binary, model, 2, i) == Approx(radiance[i % 3]));
    }
}

TEST_CASE("the table of patches has a row for each, with emission as power per area and the path quoted") {
    const auto solved = scene_radiosity(glowing_square(), {.edge = 1});
    const SolvedScene result{*solved.mesh, solved.system.reflectance, solved.solution.radiosity, solved.vertices};
    const std::string table = patch_table(result);
    CHECK(std::ranges::count(table, '\n') == 3);
    CHECK(table.find("\n\"a, \"\"square\"\"\",0,front,0.5,0.5,0,0,0,1,1,") != table.npos);
    CHECK(table.find(std::to_string(std::numbers::pi).substr(0, 6)) != table.npos);
    CHECK(std::ranges::count(vertex_table(result), '\n') == 7);
}
