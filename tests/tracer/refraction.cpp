#include "catch.h"

#include "raylab/sampling/sequence.h"
#include "raylab/tracer/refracted_direction.h"
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>
#include <numbers>

using namespace raylab;

namespace {

constexpr double degree = std::numbers::pi / 180;

// Comes down on a floor at this angle from its normal.
Vec3d coming(double angle) { return {std::sin(angle), -std::cos(angle), 0}; }

const Vec3d up{0, 1, 0};

}  // namespace

TEST_CASE("the sines are as the indices of refraction, and the refracted ray stays in the plane of incidence") {
    RandomSequence random(1, 0);
    for (int i = 0; i < 1000; ++i) {
        const Vec3d n = random.unit_vector(), d = random.unit_vector();
        const Vec3d normal = dot(d, n) > 0 ? -n : n;
        const double before = random.between(0.5, 3), behind = random.between(0.5, 3);
        const auto refracted = refracted_direction(d, normal, before, behind);
        const double sine = glm::length(cross(d, normal));
        REQUIRE(refracted.has_value() == (before * sine <= behind));
        if (!refracted) continue;
        CHECK_THAT(behind * glm::length(cross(*refracted, normal)), WithinAbs(before * sine, 1e-14));
        CHECK_THAT(glm::length(*refracted), WithinAbs(1, 1e-15));
        CHECK_THAT(dot(*refracted, cross(d, normal)), WithinAbs(0, 1e-14));
        CHECK(dot(*refracted, normal) <= 0);
    }
}

TEST_CASE("a ray goes back the way it came") {
    for (const double angle : {0.0, 10.0, 45.0, 80.0, 89.99}) {
        const auto there = refracted_direction(coming(angle * degree), up, 1, 1.5);
        const auto back = refracted_direction(-*there, -up, 1.5, 1);
        REQUIRE(back);
        CHECK(glm::length(*back + coming(angle * degree)) < 1e-12);
    }
}

TEST_CASE("total internal reflection begins at the critical angle") {
    const auto [ior, critical] = GENERATE(std::pair{1.5, 41.8103148957786}, std::pair{1.33, 48.7534666313272});
    CHECK(refracted_direction(coming((critical - 1e-11) * degree), up, ior, 1));
    CHECK_FALSE(refracted_direction(coming((critical + 1e-11) * degree), up, ior, 1));
    CHECK(fresnel(std::cos((critical - 1e-6) * degree), ior, 1) < 1);
    CHECK(fresnel(std::cos((critical + 1e-6) * degree), ior, 1) == 1);
}

TEST_CASE("equal indices leave a ray as it is") {
    CHECK(glm::length(*refracted_direction(coming(1.2), up, 1.7, 1.7) - coming(1.2)) < 1e-15);
    CHECK(fresnel(std::cos(1.2), 1.7, 1.7) < 1e-30);
}

TEST_CASE("Fresnel's share from air to glass, and from glass to air") {
    struct Row {
        double degrees, share;
    };
    for (const auto& [degrees, share] : {Row{0, .04}, Row{45, .0502399110122}, Row{60, .0891867128022},
                                         Row{80, .387704354691}, Row{89, .904184949780}, Row{89.9, .989911876919}})
        CHECK_THAT(fresnel(std::cos(degrees * degree), 1, 1.5), WithinRel(share, 1e-11));
    for (const auto& [degrees, share] : {Row{30, .0551901672954}, Row{41, .379751265962}, Row{41.8, .890771921500}})
        CHECK_THAT(fresnel(std::cos(degrees * degree), 1.5, 1), WithinRel(share, 1e-11));
    CHECK(fresnel(std::cos(42 * degree), 1.5, 1) == 1);
}

TEST_CASE("Fresnel's share straight against the normal does not mind a cosine that was rounded to above 1") {
    CHECK_THAT(fresnel(1 + 0x1p-52, 1, 1.5), WithinRel(.04, 1e-11));
    CHECK_THAT(fresnel(1 + 0x1p-51, 1.5, 1), WithinRel(.04, 1e-11));
}

TEST_CASE("Fresnel's share is the same from either end of a ray") {
    for (int degrees = 0; degrees < 90; ++degrees) {
        const auto refracted = refracted_direction(coming(degrees * degree), up, 1, 1.5);
        CHECK_THAT(fresnel(-refracted->y, 1.5, 1), WithinRel(fresnel(std::cos(degrees * degree), 1, 1.5), 1e-12));
    }
}

TEST_CASE("Fresnel's share rises to 1 at grazing incidence, and to the critical angle from inside") {
    for (const auto& [before, behind] : {std::pair{1.0, 1.5}, std::pair{1.5, 1.0}}) {
        double last = 0;
        const double first_angle = before < behind ? 57 : 34;  // behind Brewster's angle
        for (double angle = first_angle; angle <= 90; angle += 0.01) {
            const double share = fresnel(std::cos(angle * degree), before, behind);
            CHECK(share >= last);
            CHECK(share <= 1);
            last = share;
        }
        CHECK(fresnel(0, before, behind) == 1);
    }
}

TEST_CASE("no index of refraction, however small or large, makes a direction or a share that is not a number") {
    RandomSequence random(2, 0);
    const auto ior = [&] { return std::pow(10.0, random.between(-320, 308)); };
    for (int i = 0; i < 2000; ++i) {
        const Vec3d n = random.unit_vector(), d = i % 4 == 0 ? -n : random.unit_vector();
        const Vec3d normal = dot(d, n) > 0 ? -n : n;
        const double before = i % 3 == 0 ? 1 : ior(), behind = ior();
        const double share = fresnel(-dot(d, normal), before, behind);
        CHECK((share >= 0 && share <= 1));
        if (const auto refracted = refracted_direction(d, normal, before, behind))
            CHECK_THAT(glm::length(*refracted), WithinAbs(1, 1e-12));
    }
}
