#include "raylab/radiosity/solve/ambient_estimate.h"
#include "raylab/radiosity/solve/shooting_step.h"
#include "raylab/radiosity/solve/solver.h"

#include "catch.h"
#include "systems.h"

using namespace raylab;

TEST_CASE("the patch with the most unshot power shoots: not the brightest, but area times brightness") {
    RadiositySystem system = sphere({1, 10, 2}, 0.5);
    system.emission = {Color(5), Color(1, 2, 3), Color(1)};
    Radiosities radiosity = system.emission;
    Radiosities unshot = system.emission;
    CHECK(shooting_step(system, radiosity, unshot) == 1);
    CHECK(unshot[1] == 0.5 * (10. / 13) * Color(1, 2, 3));  // the patch sees itself
    // Patch 0 receives 10/13 of the other's light, though it is a tenth of its size.
    CHECK_THAT(radiosity[0].b, WithinRel(5 + 0.5 * (10. / 13) * 3, 1e-15));
    CHECK_THAT(unshot[0].b, WithinRel(5 + 0.5 * (10. / 13) * 3, 1e-15));
}

TEST_CASE("of patches with equal power the first shoots") {
    RadiositySystem system = cube(0.5);
    system.emission = Radiosities(6, Color(0.25));
    Radiosities radiosity = system.emission;
    Radiosities unshot = system.emission;
    CHECK(shooting_step(system, radiosity, unshot) == 0);
    CHECK(shooting_step(system, radiosity, unshot) == 2);  // a side, which received a little more than face 1
}

// The estimate distributes what is unshot as a closed room of one reflectance does, on the whole.
TEST_CASE("with the ambient estimate, a closed room of one reflectance has its final power after every shot") {
    RadiositySystem system = sphere({0.5, 4, 3, 2}, 0.8);
    system.emission[2] = Color(1, 0.5, 2);
    const auto power = [&](const Radiosities& radiosity) {
        double sum = 0;
        for (std::size_t i = 0; i < radiosity.size(); ++i) sum += system.area[i] * radiosity[i].b;
        return sum;
    };
    const double final_power = power(true_radiosities(system));
    std::vector<double> shown;
    std::vector<double> solved;
    const Solution solution =
        solve(system, solver_named("shooting"), {.watch = [&](const SolverStep& step) {
                  shown.push_back(power(with_ambient_estimate(system, step.radiosity, step.unshot)));
                  solved.push_back(power({step.radiosity.begin(), step.radiosity.end()}));
              }});
    REQUIRE(static_cast<int>(shown.size()) == solution.iterations);
    for (const double value : shown) CHECK_THAT(value, WithinRel(final_power, 1e-12));
    CHECK(solved.front() < 0.7 * final_power);
    for (std::size_t i = 1; i < solved.size(); ++i) CHECK(solved[i] > solved[i - 1]);
}

TEST_CASE("what has been shot and what has not are told apart in the solution") {
    const RadiositySystem system = any_system(9, 0.9, 5);
    const Solution solution = solve(system, solver_named("shooting"), {.iterations = 7});
    // B - unshot = E + rho F (B - unshot) - unshot
    for (std::size_t i = 0; i < 9; ++i) {
        Color arrived(0);
        for (std::size_t j = 0; j < 9; ++j)
            arrived += system.form_factors.at(i, j) * (solution.radiosity[j] - solution.unshot[j]);
        const Color expected = system.emission[i] + system.reflectance[i] * arrived;
        for (int channel = 0; channel < 3; ++channel)
            CHECK_THAT(solution.radiosity[i][channel], WithinAbs(expected[channel], 1e-12));
    }
}
