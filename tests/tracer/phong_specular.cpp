#include "catch.h"

#include "raylab/sampling/sequence.h"
#include "raylab/tracer/phong_specular.h"
#include "raylab/tracer/shading/power.h"

#include <cmath>
#include <numbers>

using namespace raylab;

namespace {

// A unit vector `degrees` from the z axis, towards x.
Vec3d leaning(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {std::sin(angle), 0, std::cos(angle)};
}

constexpr Vec3d up{0, 0, 1};

}  // namespace

TEST_CASE("the highlight is cos^n of the angle between the viewer and the light's mirror direction") {
    for (const double light : {-80.0, -30.0, 0.0, 45.0})
        for (const double off : {-60.0, -10.0, 0.0, 25.0})
            for (const double shininess : {0.0, 1.0, 2.0, 30.5, 1000.0})
                CHECK_THAT(phong_specular(up, leaning(light), leaning(-light + off), shininess),
                           WithinRel(std::pow(std::cos(off * std::numbers::pi / 180), shininess), 1e-11) ||
                               WithinAbs(0, 1e-300));
}

TEST_CASE("it is one where the viewer stands in the mirror direction, however narrow the highlight") {
    CHECK_THAT(phong_specular(up, leaning(40), leaning(-40), 1e6), WithinAbs(1, 1e-9));
}

TEST_CASE("vectors count by their directions only") {
    RandomSequence random(5, 1);
    for (int i = 0; i < 200; ++i) {
        const Vec3d n = random.unit_vector(), l = random.unit_vector(), v = random.unit_vector();
        const double unit = phong_specular(n, l, v, 5);
        CHECK_THAT(phong_specular(n * 3.0, l * 0.2, v * 70.0, 5), WithinRel(unit, 1e-10) || WithinAbs(unit, 1e-12));
    }
}

TEST_CASE("light and viewer may change places where both are before the surface") {
    RandomSequence random(5, 2);
    for (int i = 0; i < 200; ++i) {
        Vec3d l = random.unit_vector(), v = random.unit_vector();
        l.z = std::abs(l.z);
        v.z = std::abs(v.z);
        CHECK_THAT(phong_specular(up, l, v, 3), WithinAbs(phong_specular(up, v, l, 3), 1e-14));
    }
}

TEST_CASE("there is none from a light behind the surface, nor where the mirror direction points away") {
    CHECK(phong_specular(up, leaning(90.001), leaning(-89), 1) == 0);
    CHECK(phong_specular(up, leaning(180), leaning(0), 2) == 0);
    CHECK(phong_specular(up, leaning(80), leaning(80), 2) == 0);  // 160 degrees off: cos^2 would be 0.88
}

TEST_CASE("a power is what the standard library says, whole or not") {
    for (const double n : {0.0, 1.0, 2.0, 3.0, 0.5, 7.25, 40.0, 200.0, 1023.0, 1024.0, 1025.0, 1e6})
        for (const double x : {0.0, 0.1, 0.5, 0.9, 0.999, 1.0, 1 + 0x1p-52})
            CHECK_THAT(power(x, n), WithinRel(std::pow(x, n), 1024 * 0x1p-53) || WithinAbs(std::pow(x, n), 1e-300));
}
