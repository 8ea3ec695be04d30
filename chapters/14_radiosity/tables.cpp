#include "tables.h"

#include "cube.h"
#include "squares.h"

#include "raylab/radiosity/form_factor/form_factor_methods.h"
#include "raylab/radiosity/solve/solver.h"

#include <fmt/format.h>

namespace raylab::cornell {

namespace {

std::string iterations(const RadiositySystem& system, const std::string& solver) {
    return std::to_string(solve(system, solver_named(solver), {.residual = 1e-10}).iterations);
}

}  // namespace

std::vector<std::string> square_header() { return {"method", "1 apart", "wrong by", "0.1 apart", "wrong by"}; }

std::vector<std::vector<std::string>> square_rows() {
    std::vector<std::vector<std::string>> rows;
    for (const FormFactorMethod& method : form_factor_methods()) {
        const int effort = method.efforts[method.efforts.size() / 2];
        std::vector<std::string> row{method.title(effort)};
        for (const KnownPair& pair : {facing_1_apart(), facing_tenth_apart()}) {
            const double value = method.answer(pair.from, pair.to, effort)->value;
            const double error = std::abs(value / pair.form_factor - 1);
            row.push_back(fmt::format("{:.6f}", value));
            row.push_back(error < 1e-9 ? "less than 1e-9" : fmt::format("{:.2g} %", 100 * error));
        }
        rows.push_back(row);
    }
    return rows;
}

std::vector<std::string> cube_header() {
    return {"reflectance", "ceiling", "floor", "walls", "Jacobi", "Gauss-Seidel", "shots"};
}

std::vector<std::vector<std::string>> cube_rows() {
    std::vector<std::vector<std::string>> rows;
    for (const double reflectance : {0.5, 0.8, 0.9, 0.99}) {
        const RadiositySystem system = cube(reflectance);
        const Radiosities b = solve(system, solver_named("elimination")).radiosity;
        rows.push_back({fmt::format("{}", reflectance), fmt::format("{:.6f}", b[0].r), fmt::format("{:.6f}", b[1].r),
                        fmt::format("{:.6f}", b[2].r), iterations(system, "jacobi"), iterations(system, "gauss_seidel"),
                        iterations(system, "shooting")});
    }
    return rows;
}

}  // namespace raylab::cornell
