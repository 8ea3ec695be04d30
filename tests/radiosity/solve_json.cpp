#include "raylab/radiosity/solve/solution_json.h"

#include "catch.h"
#include "systems.h"

#include <nlohmann/json.hpp>

using namespace raylab;

TEST_CASE("a solution is told as JSON") {
    const SolverOptions options{.residual = 1e-12};
    const RadiositySystem system = with_form_factors_times(cube(0.5), 0.9);
    const Solution solution = solve(system, solver_named("gauss_seidel"), options);
    const auto json = solution_json(system, solution, options);
    CHECK(json["solver"] == "gauss_seidel");
    CHECK(json["iterations"] == solution.iterations);
    CHECK(json["converged"] == true);
    CHECK(json["residual"] == solution.residual);
    CHECK(json["error_bound"] == solution.error_bound);
    CHECK_THAT(json["row_sums"]["mean"].get<double>(), WithinAbs(0.9, 1e-12));
    CHECK(json["reciprocity_error"] == 0);
    CHECK(json["power"]["emitted"] == nlohmann::ordered_json{1.0, 1.0, 1.0});
    const double spent = json["power"]["absorbed"][1].get<double>() + json["power"]["lost"][1].get<double>();
    CHECK_THAT(spent, WithinAbs(1, 1e-11));
    CHECK(radiosities_json(solution.radiosity).size() == 6);
    CHECK(radiosities_json(solution.radiosity)[0][2] == solution.radiosity[0].b);

    const SolverOptions short_of_it{.residual = 1e-12, .iterations = 2};
    CHECK(solution_json(system, solve(system, solver_named("jacobi"), short_of_it), short_of_it)["converged"] == false);
}
