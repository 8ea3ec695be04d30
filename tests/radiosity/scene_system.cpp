#include "catch.h"
#include "rooms.h"

#include "raylab/radiosity/scene_system.h"

using namespace raylab;

TEST_CASE("radiosity says before it begins what it would refuse") {
    Scene scene = cube_room(0.5);
    CHECK(refused_by_radiosity(scene).value() == "nothing that emits light");
    scene.background.zenith = Color(0.1);
    CHECK(!refused_by_radiosity(scene));
    scene.materials[0].diffuse = Color(0.5, 1, 0.5);
    CHECK_THAT(refused_by_radiosity(scene).value(), Catch::Contains("less than 1 in each channel"));
    scene.materials[0].diffuse = Color(0.5);
    scene.objects.push_back({.shape = Plane{{0, 0, 0}, {0, 1, 0}}});
    CHECK_THAT(refused_by_radiosity(scene).value(), Catch::Contains("an infinite plane"));
}

TEST_CASE("radiosity says what it leaves out: mirrors, glass, highlights") {
    Scene scene = cube_room(0.5);
    CHECK(beyond_radiosity(scene).empty());
    scene.materials[0].name = "silver";
    scene.materials[0].kr = 0.5;
    scene.materials[1].kt = 0.9;
    scene.materials[2].specular = Color(0.1);
    const auto words = beyond_radiosity(scene);
    REQUIRE(words.size() == 3);
    CHECK(words[0] == "the mirror of material silver (kr = 0.5)");
    CHECK_THAT(words[1], Catch::Contains("the transparency"));
    CHECK_THAT(words[2], Catch::Contains("the highlight"));
}
