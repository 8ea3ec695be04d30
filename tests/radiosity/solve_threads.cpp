#include "raylab/radiosity/solve/solver.h"

#include "catch.h"
#include "systems.h"

#include "raylab/radiosity/system/symmetric_rows.h"

using namespace raylab;

TEST_CASE("solvers give the same bits on any number of threads", "[threads]") {
    const RadiositySystem system = any_system(200, 1, 3);
    for (const Solver& solver : solvers()) {
        CAPTURE(solver.name);
        const Solution by_one = solve(system, solver, {.residual = 1e-6, .threads = 1});
        for (const int threads : {2, 3, 0}) {
            const Solution by_several = solve(system, solver, {.residual = 1e-6, .threads = threads});
            CHECK(by_several.radiosity == by_one.radiosity);
            CHECK(by_several.residuals == by_one.residuals);
            CHECK(by_several.error_bound == by_one.error_bound);
        }
    }
}

TEST_CASE("symmetric rows have the same bits on any number of threads", "[threads]") {
    const RadiositySystem system = any_system(200, 1.1, 4);
    const SymmetricRows by_one = symmetric_rows(system.form_factors, system.area, 0.01, 1);
    const SymmetricRows by_two = symmetric_rows(system.form_factors, system.area, 0.01, 2);
    bool same = true;
    for (std::size_t i = 0; i < 200; ++i)
        for (std::size_t j = 0; j < 200; ++j)
            same = same && by_one.form_factors.at(i, j) == by_two.form_factors.at(i, j);
    CHECK(same);
    CHECK(by_one.after.largest == by_two.after.largest);
}
