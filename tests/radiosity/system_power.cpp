#include "raylab/radiosity/system/power_balance.h"

#include "catch.h"
#include "systems.h"

using namespace raylab;

TEST_CASE("in a closed room all that is emitted is absorbed") {
    const RadiositySystem system = cube(0.8);
    const Radiosities radiosity = true_radiosities(system);
    const PowerBalance power = power_balance(system, radiosity, 1);
    double absorbed = 0;  // sum A B (1 - rho) - the part that was emitted and never arrived
    for (const Color& b : radiosity) absorbed += b.r * (1 - 0.8);
    CHECK_THAT(absorbed, WithinAbs(1, 1e-12));  // = sum A E
    CHECK(power.emitted == Color(1));
    CHECK_THAT(power.absorbed.r, WithinAbs(1, 1e-12));
    CHECK_THAT(power.lost.r, WithinAbs(0, 1e-12));
    CHECK(std::abs(power.imbalance) < 1e-12);
}

TEST_CASE("what is emitted is absorbed or lost to the void, in each channel") {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const RadiositySystem system = any_system(15, 0.7, seed);
        const PowerBalance power = power_balance(system, true_radiosities(system), 1);
        CHECK(power.lost.r > 0);
        for (int channel = 0; channel < 3; ++channel)
            CHECK_THAT(power.absorbed[channel] + power.lost[channel], WithinRel(power.emitted[channel], 1e-12));
        CHECK(std::abs(power.imbalance) < 1e-12);
    }
}

TEST_CASE("an unfinished solution has an imbalance with its sign") {
    const RadiositySystem system = cube(0.5);
    CHECK_THAT(power_balance(system, system.emission, 1).imbalance, WithinAbs(0.5, 1e-12));
    Radiosities too_bright = true_radiosities(system);
    for (Color& b : too_bright) b *= 2.0;
    CHECK_THAT(power_balance(system, too_bright, 1).imbalance, WithinAbs(-1, 1e-12));
    CHECK(power_balance(dark_system({1}, 0.5, FormFactors(1)), {{Color(0)}}, 1).imbalance == 0);
}
