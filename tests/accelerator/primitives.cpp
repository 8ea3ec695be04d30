#include "raylab/accelerator/primitives.h"

#include "catch.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"

using namespace raylab;

TEST_CASE("the triangles of a mesh share what is prepared for it, in whichever order they come") {
    Scene scene = adversarial::scene_of(adversarial::floor_of(3));
    scene.objects.push_back(scene.objects[0]);
    for (Object& object : scene.objects) object.placement.translation.x += 1;
    std::vector<Primitive> mixed;  // one of each mesh in turn
    for (std::uint32_t part = 0; part < 18; ++part)
        for (std::uint32_t number = 0; number < 2; ++number) mixed.push_back({number, part});
    std::vector<std::uint32_t> places;
    for (const Primitive& primitive : mixed) places.push_back(primitive.object * 18 + primitive.part);

    const Primitives in_order(scene);
    REQUIRE(in_order.size() == mixed.size());
    const std::size_t first_two = Primitives(scene, std::span(mixed).first(2)).bytes();
    CHECK(in_order.bytes() < 18 * first_two);
    CHECK(Primitives(scene, mixed).bytes() == in_order.bytes());
    CHECK(Primitives(in_order, places).bytes() == in_order.bytes());
}
