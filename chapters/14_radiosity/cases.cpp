#include "cases.h"

#include "mesh_cases.h"
#include "sight_cases.h"
#include "solver_cases.h"
#include "squares.h"

#include "raylab/radiosity/form_factor/closed_forms.h"
#include "raylab/radiosity/form_factor/form_factor_methods.h"
#include "raylab/radiosity/form_factor/polygon_form_factor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace raylab::cornell {

namespace {

const FormFactorMethod& method_named(const std::string& name) {
    return *std::ranges::find(form_factor_methods(), name, &FormFactorMethod::name);
}

// One answer of a method, which should be wrong by at least or at most this relative error.
struct Expected {
    enum class Kind { fails, holds } kind;
    double error;
};
constexpr auto fails_by = [](double error) { return Expected{Expected::Kind::fails, error}; };
constexpr auto within = [](double error) { return Expected{Expected::Kind::holds, error}; };

std::string share(double error) {
    return error >= 1e-4 ? fmt::format("{:.3g} %", 100 * error) : fmt::format("{:.2g}", error);
}

CaseRow row(const std::string& method, double value, double truth, Expected expected) {
    const double error = std::abs(value / truth - 1);
    const bool should_fail = expected.kind == Expected::Kind::fails;
    return {.method = method,
            .expected = should_fail ? "fails: wrong by at least " + share(expected.error)
                                    : "holds: wrong by at most " + share(expected.error),
            .observed = fmt::format("{:.7g}, wrong by {}", value, share(error)),
            .as_expected = should_fail ? error >= expected.error : error <= expected.error};
}

CaseRow answer(const std::string& name, const KnownPair& pair, int effort, Expected expected) {
    const FormFactorMethod& method = method_named(name);
    return row(method.title(effort), method.answer(pair.from, pair.to, effort)->value, pair.form_factor, expected);
}

std::vector<CaseRow> hemicube_near() {
    return {answer("hemicube", facing_half_apart(), 512, fails_by(0.33)),
            answer("hemicube", facing_5_apart(), 2048, within(0.025)),
            answer("contour", facing_half_apart(), 8, within(1e-4)),
            answer("polygon", facing_half_apart(), 0, within(1e-12))};
}

std::vector<CaseRow> hemicube_alias() {
    // Beside the middle of the view, so that the small square does not lie evenly on pixels.
    KnownPair pair{lower_square(), upper_square(1, 0.02), 0};
    for (Vec3d& corner : pair.to) corner += Vec3d{0.013, 0.021, 0};
    pair.form_factor = method_named("closed").answer(pair.from, pair.to, 0)->value;
    return {answer("hemicube", pair, 32, fails_by(0.5)), answer("hemicube", pair, 512, within(0.3)),
            answer("polygon", pair, 0, within(1e-12))};
}

std::vector<CaseRow> disk_near() {
    return {answer("disk", facing_half_apart(), 0, fails_by(0.34)), answer("disk", facing_5_apart(), 0, within(0.014)),
            answer("polygon", facing_half_apart(), 0, within(1e-12))};
}

std::vector<CaseRow> cancellation() {
    constexpr double x = 1e-4, truth = x * x / std::numbers::pi;  // but for 1e-8 of it
    return {row("C-11 as printed", parallel_rectangles_textbook(x, x), truth, fails_by(1)),
            row("C-11 with Gauss points", parallel_rectangles(x, x), truth, within(1e-7)),
            row("polygon", polygon_form_factor(lower_square(), upper_square(1 / x)), truth, within(1e-7))};
}

std::vector<CaseRow> touching() {
    const KnownPair pair = sharing_an_edge();
    return {answer("area, random", pair, 256, fails_by(0.02)), answer("hemicube", pair, 512, fails_by(0.04)),
            answer("contour", pair, 4, within(1e-5)), answer("polygon", pair, 0, within(1e-12)),
            answer("closed", pair, 0, within(1e-12))};
}

}  // namespace

std::vector<StabilityCase> cases(const ChapterRun& run) {
    std::vector<StabilityCase> all{
        {"HEMICUBE-NEAR", "two squares half a side apart: the centre's view is not that of the whole patch",
         hemicube_near},
        {"HEMICUBE-ALIAS", "a square of the size of a hemicube's pixel", hemicube_alias},
        {"DISK-NEAR", "a patch replaced by a disk of its area, from near", disk_near},
        {"FF-CANCEL", "the closed form of two small squares far apart", cancellation},
        {"FF-TOUCH", "two squares that share an edge, where the density has no bound", touching}};
    for (StabilityCase& one : sight_cases(run)) all.push_back(std::move(one));
    for (StabilityCase& one : solver_cases(run)) all.push_back(std::move(one));
    for (StabilityCase& one : mesh_cases(run)) all.push_back(std::move(one));
    return all;
}

}  // namespace raylab::cornell
