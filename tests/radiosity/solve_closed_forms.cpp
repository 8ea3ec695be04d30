#include "raylab/radiosity/solve/solver.h"

#include "catch.h"
#include "systems.h"

using namespace raylab;

namespace {

// The radiosities by every solver, one list after another.
std::vector<Radiosities> by_every_solver(const RadiositySystem& system) {
    std::vector<Radiosities> all;
    for (const Solver& solver : solvers()) all.push_back(solve(system, solver, {.residual = 1e-13}).radiosity);
    return all;
}

}  // namespace

TEST_CASE("in a white furnace everything is as bright as e / (1 - rho), whatever the shape") {
    const double reflectance = 0.8;
    RadiositySystem room = cube(reflectance);
    RadiositySystem bulb = sphere({0.1, 2, 0.7, 1.3, 5, 0.01}, reflectance);
    for (RadiositySystem* system : {&room, &bulb}) {
        system->emission = Radiosities(6, Color(0.3, 1, 2));
        for (const Radiosities& radiosity : by_every_solver(*system))
            for (const Color& b : radiosity)
                for (int channel = 0; channel < 3; ++channel)
                    CHECK_THAT(b[channel], WithinRel(system->emission[0][channel] / (1 - reflectance), 1e-9));
    }
}

// Each patch of a sphere is lit alike: H = sum f_j E_j / (1 - sum f_j rho_j), with f_j its share of the area.
TEST_CASE("a sphere with a bright tenth is lit by one half") {
    RadiositySystem system = sphere({1, 4, 3, 2}, 0.8);
    system.emission[0] = Color(1);
    for (const Radiosities& radiosity : by_every_solver(system)) {
        CHECK_THAT(radiosity[0].r, WithinAbs(1.4, 1e-9));
        for (std::size_t i = 1; i < 4; ++i) CHECK_THAT(radiosity[i].r, WithinAbs(0.4, 1e-9));
    }
}

TEST_CASE("two infinite plates: B1 = (E1 + rho1 E2) / (1 - rho1 rho2)") {
    FormFactors form_factors(2);
    form_factors.at(0, 1) = form_factors.at(1, 0) = 1;
    RadiositySystem system = dark_system({1, 1}, 0, std::move(form_factors));
    system.reflectance = {Color(.5), Color(.8)};
    system.emission[0] = Color(1);
    for (const Radiosities& radiosity : by_every_solver(system)) {
        CHECK_THAT(radiosity[0].r, WithinAbs(5. / 3, 1e-9));
        CHECK_THAT(radiosity[1].r, WithinAbs(4. / 3, 1e-9));
    }
}

// The outer sphere is concave: it sees itself with F_22 = 1 - (r1 / r2)^2.
TEST_CASE("two concentric spheres of radius 1 and 2 are as bright as 4/3 and 2/3") {
    FormFactors form_factors(2);
    form_factors.at(0, 1) = 1;
    form_factors.at(1, 0) = 0.25;
    form_factors.at(1, 1) = 0.75;
    RadiositySystem system = dark_system({1, 4}, 0, std::move(form_factors));
    system.reflectance = {Color(.5), Color(.8)};
    system.emission[0] = Color(1);
    for (const Radiosities& radiosity : by_every_solver(system)) {
        CHECK_THAT(radiosity[0].r, WithinAbs(4. / 3, 1e-9));
        CHECK_THAT(radiosity[1].r, WithinAbs(2. / 3, 1e-9));
    }
}

TEST_CASE("a duct of three equal sides, one of them bright: 1.2, 0.4, 0.4") {
    FormFactors form_factors(3);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) form_factors.at(i, j) = i == j ? 0 : 0.5;
    RadiositySystem system = dark_system({1, 1, 1}, 0.5, std::move(form_factors));
    system.emission[0] = Color(1);
    for (const Radiosities& radiosity : by_every_solver(system)) {
        CHECK_THAT(radiosity[0].r, WithinAbs(1.2, 1e-9));
        CHECK_THAT(radiosity[1].r, WithinAbs(0.4, 1e-9));
        CHECK_THAT(radiosity[2].r, WithinAbs(0.4, 1e-9));
    }
}
