#include "solver_cases.h"

#include "cube.h"

#include "raylab/base/error.h"
#include "raylab/base/number_text.h"
#include "raylab/radiosity/scene_radiosity.h"
#include "raylab/radiosity/solve/solver.h"
#include "raylab/radiosity/system/power_balance.h"
#include "raylab/radiosity/system/row_sums.h"
#include "raylab/radiosity/system/symmetric_rows.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>

namespace raylab::cornell {

namespace {

double emitter(const Solution& solution) { return solution.radiosity[0].r; }

std::string brightness(double found, double truth) { return fmt::format("B = {:.5g} for {:.4g}", found, truth); }

// What a direct method, which believes any matrix, says of the emitting face.
CaseRow believed(double reflectance, double row, const std::string& expected,
                 const std::function<bool(double found, double truth)>& is_expected) {
    const Solver& elimination = solver_named("elimination");
    const double found = emitter(elimination.run(cube(reflectance, row), {}));
    const double truth = emitter(elimination.run(cube(reflectance, 1), {}));
    return {fmt::format("elimination, unchecked: rows of {:g}, reflectance {:g}", row, reflectance), expected,
            brightness(found, truth), is_expected(found, truth)};
}

CaseRow diverging() {
    const double found = emitter(solver_named("jacobi").run(cube(.99, 1.02), {.iterations = 2000}));
    const double truth = emitter(solver_named("elimination").run(cube(.99, 1), {}));
    return {"Jacobi, unchecked: rows of 1.02, reflectance 0.99", "fails: grows without end",
            brightness(found, truth) + " after 2 000 sweeps", found > 1000 * truth};
}

CaseRow refused(const std::string& solver, const SolverOptions& options, const std::string& what) {
    std::string observed = "solved";
    try {
        solve(cube(.99, 1.02), solver_named(solver), options);
    } catch (const Error& error) {
        observed =
            std::string(error.what()).find("RADIOSITY-BLOWUP") != std::string::npos ? "refused by name" : error.what();
    }
    return {solver + ", checked: " + what, "holds: refused by name", observed, observed == "refused by name"};
}

CaseRow scaled(double reflectance, double row) {
    RadiositySystem system = cube(reflectance, row);
    system.form_factors = symmetric_rows(std::move(system.form_factors), system.area, 0.03, 1).form_factors;
    const double found = emitter(solve(system, solver_named("auto")));
    const double truth = emitter(solver_named("elimination").run(cube(reflectance, 1), {}));
    return {fmt::format("symmetric rows of {:g}, reflectance {:g}", row, reflectance), "holds: within 1e-9",
            brightness(found, truth), std::abs(found / truth - 1) < 1e-9};
}

// A white furnace is as bright as e / (1 - rho) with any form factors whose rows are 1, and scaled rows are.
CaseRow furnace_of_nonsense() {
    RadiositySystem system = cube(.9, 1);
    system.emission = std::vector<Color>(6, Color(1));
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < i; ++j)
            system.form_factors.at(i, j) = system.form_factors.at(j, i) = 0.1 + 0.01 * static_cast<double>(i + 2 * j);
    system.form_factors = symmetric_rows(std::move(system.form_factors), system.area, 1, 1).form_factors;
    const double found = emitter(solve(system, solver_named("elimination"), {.form_factor_error = 1e-6}));
    return {"white furnace with scaled rows of nonsense", "fails: does not notice", brightness(found, 10),
            std::abs(found / 10 - 1) < 1e-6};
}

std::vector<CaseRow> blowup_rows(const ChapterRun&) {
    return {believed(.99, 1.02, "fails: negative brightness", [](double found, double) { return found < 0; }),
            believed(.98, 1.02, "fails: more than 10 times as bright",
                     [](double found, double truth) { return found > 10 * truth; }),
            believed(.99, 1.005, "fails: more than half too bright",
                     [](double found, double truth) { return found > 1.5 * truth; }),
            diverging(),
            refused("elimination", {}, "rows of 1.02, believed to be exact"),
            refused("gauss_seidel", {.form_factor_error = 0.03},
                    "rows of 1.02 within their stated error, reflectance 0.99"),
            scaled(.99, 1.02),
            scaled(.98, 1.02),
            furnace_of_nonsense()};
}

// The Cornell box has no front wall.
std::vector<CaseRow> open_rows(const ChapterRun& run) {
    const SolverOptions options{.residual = 1e-12, .threads = run.threads};
    const RadiositySystem open = scene_radiosity(read_scene(run.scene), {.patches = run.sized<std::size_t>(400, 150),
                                                                         .form_factors = {.threads = run.threads},
                                                                         .solving = options})
                                     .system;
    const auto power_of = [&](const RadiositySystem& system, const char* solver) {
        return power_balance(system, solve(system, solver_named(solver), options).radiosity, run.threads);
    };
    RadiositySystem closed = open;
    const std::vector<double> sums = each_row_sum(open.form_factors, run.threads);
    for (std::size_t i = 0; i < closed.patches(); ++i)
        for (double& f : closed.form_factors.row(i))
            f /= sums[i] > 0 ? sums[i] : 1;  // under the blocks nothing is seen
    const PowerBalance symmetric = power_of(open, "auto");
    const PowerBalance divided = power_of(closed, "elimination");
    const double brighter = divided.absorbed.r / symmetric.absorbed.r - 1;
    return {{"symmetric rows", "holds: emitted = absorbed + lost",
             fmt::format("{} of the light lost, imbalance {:.0e}", share_text(symmetric.lost.r / symmetric.emitted.r),
                         std::abs(symmetric.imbalance)),
             std::abs(symmetric.imbalance) < 1e-9 && symmetric.lost.r > 0.05 * symmetric.emitted.r},
            {"rows divided by their sums, as if the room were closed", "fails: more than 10 % too bright",
             share_text(brighter) + " too much light on its surfaces", brighter > 0.1}};
}

}  // namespace

std::vector<StabilityCase> solver_cases(const ChapterRun& run) {
    const auto of = [&run](std::vector<CaseRow> (*rows)(const ChapterRun&)) {
        return [run, rows] { return rows(run); };
    };
    return {{"RADIOSITY-BLOWUP",
             "Form factors of a cube that are too large by a little, and reflectances next to 1: each reflection makes "
             "light.",
             of(blowup_rows)},
            {"OPEN-SCENE", "A room without a front wall, through which light leaves.", of(open_rows)}};
}

}  // namespace raylab::cornell
