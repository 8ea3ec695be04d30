#include "solver_question.h"

#include "raylab/radiosity/scene_radiosity.h"
#include "raylab/radiosity/solve/residual.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace raylab::cornell {

namespace {

struct Subject {
    std::string name;
    RadiositySystem system;
};

// The system of the box, and the same with walls that reflect nearly all: there light is reflected a hundred times.
std::vector<Subject> subjects_of_solvers(const ChapterRun& run) {
    const auto solved = scene_radiosity(read_scene(run.scene), {.patches = run.sized<std::size_t>(1000, 200),
                                                                .form_factors = {.threads = run.threads}});
    RadiositySystem white = solved.system;
    for (Color& reflectance : white.reflectance) reflectance = Color(0.98);
    return {{"Cornell box", solved.system}, {"the same in white, reflectance 0.98", std::move(white)}};
}

// The largest difference, relative to the largest radiosity.
double error_of_solution(const Radiosities& found, const Radiosities& truth) {
    constexpr double digits_of_solution = 1e-14;
    return std::max(relative(largest_change(truth, found), largest_of(truth)), digits_of_solution);
}

// How often a solution has read all form factors; a shot reads one row.
double passes(const Solution& solution, std::size_t patches) {
    const double iterations = solution.iterations;
    return solution.solver == "shooting" ? iterations / static_cast<double>(patches) : iterations;
}

std::string soonest_solver(const Experiment& experiment) {
    std::string text = "A millionth is reached soonest";
    for (const std::string workload : {"Cornell box", "the same in white, reflectance 0.98"}) {
        const Measurement* best = nullptr;
        for (const Measurement& row : experiment.rows)
            if (row.workload == workload && row.error <= 1e-6 &&
                (!best || row.nanoseconds.median < best->nanoseconds.median))
                best = &row;
        if (best)
            text += fmt::format("{} by {} ({:.2g} ms)", text.back() == ')' ? ", in white" : "", best->method,
                                best->nanoseconds.median * 1e-6);
    }
    return text;
}

}  // namespace

Experiment measure_solvers(const ChapterRun& run) {
    Experiment experiment{.question = "solvers",
                          .title = "How soon is a system of radiosities solved?",
                          .error_axis = "error of the worst radiosity, relative to the largest",
                          .rows = {},
                          .answer = soonest_solver};
    for (const auto& [name, system] : subjects_of_solvers(run)) {
        // As far as doubles go. Eigen's elimination, which shares no code with the sweeps, differs by some 1e-15.
        const Solution truth = solver_named("gauss_seidel").run(system, {.residual = 1e-15, .iterations = 3000});
        for (const Solver& solver : solvers()) {
            if (solver.name == "auto") continue;
            const bool is_direct = solver.name == "elimination" || solver.name == "cholesky";
            for (const double residual :
                 is_direct ? std::vector<double>{0} : std::vector<double>{1e-2, 1e-4, 1e-6, 1e-8}) {
                const SolverOptions options{.residual = residual, .threads = run.threads};
                const Solution solution = solver.run(system, options);
                experiment.rows.push_back(
                    {.method = solver.name,
                     .number = "double",
                     .workload = name,
                     .knob = is_direct ? "" : fmt::format("residual {:g}", residual),
                     .source = solver.source,
                     .error = error_of_solution(solution.radiosity, truth.radiosity),
                     .nanoseconds = time_per_query(1, [&] { solver.run(system, options); },
                                                   {.repeats = run.sized(5, 3), .shortest = 0.0005}),
                     .queries = 1,
                     .counts = {{"passes over the form factors", passes(solution, system.patches())}}});
            }
        }
    }
    return experiment;
}

}  // namespace raylab::cornell
