#include "catch.h"

#include "raylab/radiosity/scene_radiosity.h"
#include "raylab/report/radiosity/walk_through.h"

#include <nlohmann/json.hpp>

using namespace raylab;

TEST_CASE("a page of a walk is complete in itself, with its licence, and shows a title harmlessly") {
    Scene scene;
    scene.source = "square.toml";
    scene.materials = {{.diffuse = Color(0.5), .emission = Color(1, 2, 3)}};
    scene.objects = {{.shape = Polygon{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}}, .sides = Sides::front},
                     {.shape = Polygon{{{0, 0, 1}, {2, 0, 1}, {2, 1, 1}}}, .sides = Sides::front}};
    const auto solved = scene_radiosity(scene, {.edge = 3, .form_factors = {.rays = 0}});
    const std::string page =
        walk_through_page({*solved.mesh, solved.system.reflectance, solved.solution.radiosity, solved.vertices},
                          scene.camera, "<b>mine</b>", 0.5);
    CHECK_THAT(page, Catch::Contains("The above copyright notice and this permission notice shall be included"));
    CHECK_THAT(page, Catch::Contains("&lt;b&gt;mine&lt;/b&gt;") && !Catch::Contains("<b>mine"));
    CHECK_THAT(page, !Catch::Contains("<script src") && !Catch::Contains("<link rel"));
    const std::string opening = "id=\"solution\">";
    const auto begin = page.find(opening) + opening.size();
    const auto solution = nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
    CHECK(solution["exposure"] == 0.5);
    CHECK(solution["camera"]["fov_y"] == 40);
    // Four bytes a number, and four letters for three bytes: two patches of four corners and of three.
    CHECK(solution["corners"].get<std::string>().size() == 44);
    CHECK(solution["ofPatches"].get<std::string>().size() == 32);
    CHECK(solution["vertices"].get<std::string>().size() == 4 * 28);
    CHECK(solution["atVertices"].get<std::string>().size() == 4 * 28);
    // The triangle's fourth corner is none: its last two bytes are 0xff.
    CHECK_THAT(solution["corners"].get<std::string>(), Catch::EndsWith("//8="));
}
