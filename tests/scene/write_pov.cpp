#include "catch.h"

#include "raylab/scene/pov/write_pov.h"
#include "raylab/scene/read_scene.h"

#include <string_view>

// Tests of the text; that POV-Ray understands it in the same sense is tested in tests/render_peer.

using namespace raylab;
using Catch::Contains;

namespace {

Scene scene_of(const std::string& text) {
    return read_scene_text("raylab = 1\n" + text, RAYLAB_SOURCE "/tests/scene/a.toml");
}

int count(const std::string& text, std::string_view word) {
    int found = 0;
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
    return found;
}

const std::string glass = "[material.glass]\ndiffuse = [0.1, 0.1, 0.1]\nkr = 0.1\nkt = 0.75\nior = 1.5\n";
const std::string sphere = "[[shape]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\n";

}  // namespace

TEST_CASE("a mesh that two shapes share is declared once") {
    const std::string mesh = "[[shape]]\ntype = \"mesh\"\nfile = \"meshes/pyramid.off\"\n";
    const auto text = to_pov(scene_of(mesh + mesh));
    CHECK(count(text, "= mesh2 {") == 1);
    CHECK(count(text, "object { Mesh_0") == 2);
}

TEST_CASE("a mesh that some shape shows from one side is not opaque to POV-Ray; another is, which is faster") {
    const std::string mesh = "[[shape]]\ntype = \"mesh\"\nfile = \"meshes/pyramid.off\"\n";
    CHECK(count(to_pov(scene_of(mesh + mesh)), "texture_list") == 0);
    CHECK(count(to_pov(scene_of(mesh + mesh + "sides = \"front\"\n")), "texture_list { 1, texture { Unseen } }") == 1);
}

TEST_CASE("a placed triangle is written where it is, its front clockwise, under a mirror too") {
    const auto triangle = [](const std::string& transform) {
        const std::string shape = "[[shape]]\ntype = \"triangle\"\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\n";
        return to_pov(scene_of(shape + "transform = [" + transform + "]"));
    };
    CHECK_THAT(triangle("{ translate = [0.5, 0, 2] }"), Contains("triangle { <0.5, 0, 2>, <0.5, 1, 2>, <1.5, 0, 2>\n"));
    CHECK_THAT(triangle("{ scale = [-2, 1, 1] }"), Contains("triangle { <0, 0, 0>, <-2, 0, 0>, <0, 1, 0>\n"));
    CHECK(count(triangle("{ scale = [-2, 1, 1] }"), "matrix") == 0);
}

TEST_CASE("a surface that transmits gives its own light undiminished, and throws an opaque shadow") {
    const auto text = to_pov(scene_of(glass + sphere + "material = \"glass\""));
    CHECK_THAT(text, Contains("color rgbt <0.1, 0.1, 0.1, 0.75>") && Contains("diffuse 4 "));
    CHECK_THAT(text, Contains("interior { ior 1.5 }") && Contains("no_shadow") && Contains("no_image no_reflection"));
    CHECK(count(text, "sphere {") == 2);
}

TEST_CASE("a surface whose whole light is transmitted keeps a sliver to shine with") {
    auto scene = scene_of(glass + sphere + "material = \"glass\"");
    scene.materials[scene.objects[0].front].kt = 1;
    CHECK_THAT(to_pov(scene), Contains(", 0.9990234375>") && Contains("diffuse 1024 "));
}

TEST_CASE("emission is no light that the diffuse colour tints") {
    const auto text = to_pov(
        scene_of("[material.light]\ndiffuse = [0.5, 0, 0]\nemission = [2, 0, 3]\n" + sphere + "material = \"light\""));
    CHECK_THAT(text, Contains("emission rgb <4, 0, 3145728>"));
}

TEST_CASE("attenuation is said where POV-Ray can say it: 2 / (1 + (d / fade_distance)^fade_power)") {
    const auto light = [](const std::string& attenuation) {
        return to_pov(scene_of("[[light]]\ntype = \"point\"\nposition = [0, 1, 0]\nattenuation = " + attenuation));
    };
    CHECK_THAT(light("[1, 0, 0]"), Contains("color rgb <1, 1, 1> }"));
    CHECK_THAT(light("[2, 0, 0]"), Contains("color rgb <0.5, 0.5, 0.5> }"));
    CHECK_THAT(light("[4, 0, 1]"), Contains("color rgb <0.125, 0.125, 0.125> fade_distance 2 fade_power 2 }"));
    CHECK_THAT(light("[4, 2, 0]"), Contains("color rgb <0.125, 0.125, 0.125> fade_distance 2 fade_power 1 }"));
}

TEST_CASE("a name with a line break stays inside its comment") {
    const auto text = to_pov(scene_of("[group.\"a\\n#error \\\"b\\\"\"]\nshapes = [{ type = \"sphere\", center = "
                                      "[0, 0, 0], radius = 1 }]\n[[instance]]\nof = \"a\\n#error \\\"b\\\"\""));
    CHECK_THAT(text, Contains("// a #error"));
    CHECK(count(text, "\n#error") == 0);
}

TEST_CASE("depth and adc_bailout are what the options say") {
    CHECK_THAT(to_pov({}, {.depth = 7, .adc_bailout = 0.25}), Contains("max_trace_level 7 adc_bailout 0.25"));
}

TEST_CASE("a scene that POV-Ray can show has no differences; one that it cannot has them, in the text too") {
    CHECK(pov_differences(scene_of(sphere)).empty());
    auto scene = scene_of(glass + sphere + "material = \"glass\"\nmotion = [1, 0, 0]");
    scene.materials[0].specular = {0, 0.5, 1};
    const auto differences = pov_differences(scene);
    REQUIRE(differences.size() == 3);
    CHECK_THAT(differences[0], Contains("motion"));
    CHECK_THAT(differences[1], Contains("coloured `specular`"));
    CHECK_THAT(differences[2], Contains("all light is reflected inside"));  // kr + kt of the glass is 0.85
    for (const auto& difference : differences) CHECK_THAT(to_pov(scene), Contains("// " + difference + "\n"));
}

TEST_CASE("what spread rays show, and POV-Ray's scene does not, is said") {
    auto scene = scene_of(glass + sphere + "material = \"glass\"\n");
    scene.materials[0].polish = Gloss{50};
    scene.materials[0].emission = {1, 1, 1};
    scene.model = RenderModel::path;
    const std::string text = to_pov(scene);
    CHECK_THAT(text, Contains("no gloss and no roughness"));
    CHECK_THAT(text, Contains("Area lights are grids of points, moved at random; what emits throws no shadow."));
    CHECK_THAT(text, Contains("No light goes from one diffuse surface to another."));
    scene.model = RenderModel::whitted;
    CHECK(to_pov(scene).find("what emits") == std::string::npos);
    CHECK(to_pov(scene).find("area_light") == std::string::npos);
}

TEST_CASE("a lens is POV-Ray's focal blur, whose aperture is four times its radius") {
    const auto text = to_pov(scene_of("[camera]\nposition = [0, 0, 5]\ntarget = [0, 0, 0]\nlens = { radius = 0.125, "
                                      "focus = 2 }\n" +
                                      sphere),
                             {.samples = 100});
    CHECK_THAT(text, Contains("aperture 0.5 blur_samples 100 confidence 0.999 variance 0\n  focal_point <0, 0, 3>"));
}

TEST_CASE("what emits is an area light: a grid of points on each side that shines") {
    const auto lit = [](const std::string& shape) {
        return to_pov(scene_of("[material.bright]\nemission = [3, 3, 3]\n[[shape]]\nmaterial = \"bright\"\n" + shape),
                      {.samples = 16});
    };
    const std::string square = lit("type = \"polygon\"\nvertices = [[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0]]\n");
    CHECK_THAT(square, Contains("light_source { <1, 0.5, 0>"));
    CHECK_THAT(square, Contains("tightness 1 point_at <1, 0.5, 1> area_light <1.5, 0, 0>, <0, 0.75, 0>, 4, 4 jitter"));
    CHECK_THAT(square, Contains("point_at <1, 0.5, -1>") && Contains("no_shadow"));
    CHECK(count(lit("type = \"disk\"\ncenter = [0, 0, 0]\nnormal = [0, 0, 1]\nradius = 2\nsides = \"front\"\n"),
                "area_light <") == 1);
    CHECK_THAT(lit("type = \"sphere\"\ncenter = [0, 0, 0]\nradius = 2\n"), Contains("jitter circular orient"));
    const std::string cylinder = lit("type = \"cylinder\"\nbase = [0, 0, 0]\ntop = [0, 1, 0]\nradius = 2\n");
    CHECK_THAT(cylinder, Contains("What emits and is no rectangle, disk or sphere is seen, and lights nothing."));
    CHECK(cylinder.find("area_light") == std::string::npos);
}
