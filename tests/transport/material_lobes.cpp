#include "catch.h"

#include "raylab/transport/lobe/material_lobes.h"

using namespace raylab;

namespace {

Material glass(const Polish& polish) {
    Material material;
    material.kr = 0.3;
    material.kt = 0.6;
    material.polish = polish;
    return material;
}

const Vec3d straight{0, 0, 1}, flat{0.8, 0, 0.6};
constexpr Interface into_glass{1, 1.5}, out_of_glass{1.5, 1}, none{1, 1};

template <class Kind>
Kind only(const MaterialLobes& lobes) {
    REQUIRE(lobes.spread.size() == 1);
    return std::get<Kind>(lobes.spread[0]);
}

}  // namespace

TEST_CASE("a sharp material has no lobes but the diffuse one; what is totally reflected adds to the mirror") {
    const auto in = material_lobes(glass(Sharp{}), Color(0.1), flat, into_glass);
    CHECK(only<DiffuseLobe>(in).albedo == Color(0.1));
    CHECK((in.mirrored == 0.3 && in.refracted == 0.6));
    const auto out = material_lobes(glass(Sharp{}), Color(0), flat, out_of_glass);
    CHECK(out.spread.empty());
    CHECK_THAT(out.mirrored, WithinRel(0.9, 1e-15));
    CHECK(out.refracted == 0);
}

TEST_CASE("a glossy material has a lobe around each of its sharp directions") {
    const auto lobes = material_lobes(glass(Gloss{40}), Color(0), flat, into_glass);
    REQUIRE(lobes.spread.size() == 2);
    const auto mirrored = std::get<GlossLobe>(lobes.spread[0]), refracted = std::get<GlossLobe>(lobes.spread[1]);
    CHECK((mirrored.k == 0.3 && mirrored.axis == Vec3d{-0.8, 0, 0.6} && mirrored.exponent == 40));
    CHECK(refracted.k == 0.6);
    CHECK_THAT(refracted.axis.x, WithinRel(-0.8 / 1.5, 1e-12));
    CHECK(lobes.mirrored == 0);
    CHECK(only<GlossLobe>(material_lobes(glass(Gloss{40}), Color(0), flat, out_of_glass)).k == 0.3 + 0.6);
}

TEST_CASE("a rough material is one lobe; between equal indices what passes, passes sharply") {
    const auto rough = only<RoughLobe>(material_lobes(glass(Roughness{0.5}), Color(0), flat, into_glass));
    CHECK((rough.alpha == 0.25 && rough.kr == 0.3 && rough.kt == 0.6 && rough.ior_behind == 1.5));
    const auto film = material_lobes(glass(Roughness{0.5}), Color(0), flat, none);
    CHECK(only<RoughLobe>(film).kt == 0);
    CHECK(film.refracted == 0.6);
}

TEST_CASE("by Fresnel's equations glass mirrors 4 % of what falls straight on it") {
    const auto lobes = material_lobes(glass(Sharp{}), Color(0), straight, into_glass, FacetShares::fresnel);
    CHECK_THAT(lobes.mirrored, WithinRel(0.9 * 0.04, 1e-12));
    CHECK_THAT(lobes.refracted, WithinRel(0.9 * 0.96, 1e-12));
}
