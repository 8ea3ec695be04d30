#include "evidence.h"

#include "judge.h"

#include "raylab/experiment/measure/quantile.h"
#include "raylab/experiment/ray_quadric/ray_quadric.h"
#include "raylab/experiment/ray_sphere/ray_sphere.h"
#include "raylab/geometry/surface/gradient.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace raylab {

namespace {

// The methods of the table, and their names in its columns.
constexpr std::array<std::pair<const char*, const char*>, 8> columns = {
    {{"textbook, float", "textbook float"},
     {"stable, float", "stable float"},
     {"reformulated, float", "reform. float"},
     {"factored, float", "factored float"},
     {"textbook, double", "textbook double"},
     {"reformulated, double", "reform. double"},
     {"factored, double", "factored double"},
     {"filtered exact, double + exact", "filtered exact"}}};

std::string cell(const WrongDecisions& wrong) {
    return wrong.all() == 0 ? "0" : fmt::format("{:.0f} / {:.0f}", wrong.misses, wrong.false_hits);
}

template <Real T>
std::vector<std::string> cancellation_row(double offset, const std::string& number) {
    const Quadratic<T> q = along<T>({{cast<T>(offset), 0, 4096}, {0, 0, -1}, {0, 1e9f}}, {{0, 0, 0}, 1});
    return {fmt::format("{} radii", offset), number, fmt::format("{:.10g}", q.half_b * q.half_b),
            fmt::format("{:.10g}", q.a * q.c), fmt::format("{:.3g}", q.discriminant())};
}

// One Newton step from t towards the root of the surface's equation: t is right to a double's last place, so the result
// is right to a long double's.
long double polished(const Quadratic<long double>& q, double t) {
    const long double x = t;
    return x - ((q.a * x + 2 * q.half_b) * x + q.c) / (2 * (q.a * x + q.half_b));
}

/// The errors of gradients of one kind of quadric.
struct NormalErrors {
    std::vector<double> in_float, in_double;  // angles to the exact normal, in radians, sorted
    double shortest = 1e300, longest = 0;     // lengths of gradients
};

template <Real T>
Vec3<T> point_at(const RayOf<T>& ray, T t) {
    return ray.origin + ray.direction * t;
}

template <Real T>
double angle_to(const Vec3<long double>& exact, const RayOf<T>& ray, const QuadricHit<T>& hit, const Quadric& quadric) {
    const Vec3<T> normal = gradient_normal<T>(quadric, point_at(ray, hit.t), hit.part);
    // The sine, which equals so small an angle.
    return cast<double>(glm::length(cross(convert<long double>(normal), exact)));
}

NormalErrors normal_errors(QuadricKind kind, WorkloadSize draw, int threads) {
    const QuadricWorkload workload = quadrics_at(4, kind, draw);
    const Truth truth = truth_of(workload, threads);
    NormalErrors errors;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const Quadric& quadric = workload.data[workload.queries[i].quadric];
        const auto in_float = nearest_quadric_hit(in<float>(workload.queries[i].ray), quadric);
        const auto in_double = nearest_quadric_hit(in<double>(workload.queries[i].ray), quadric);
        if (!truth[i].hit() || !in_float || !in_double || in_float->part != Part::side || in_double->part != Part::side)
            continue;
        const auto ray = in<long double>(workload.queries[i].ray);
        const auto equation =
            std::visit([&](const auto& shape) { return along(ray, in<long double>(shape)); }, quadric);
        const auto point = point_at(ray, polished(equation, truth[i].t->nearest()));
        const auto exact = gradient_normal<long double>(quadric, point, Part::side);
        errors.in_float.push_back(angle_to(exact, in<float>(workload.queries[i].ray), *in_float, quadric));
        errors.in_double.push_back(angle_to(exact, in<double>(workload.queries[i].ray), *in_double, quadric));
        const double length = cast<double>(glm::length(gradient<long double>(quadric, point, Part::side)));
        errors.shortest = std::min(errors.shortest, length);
        errors.longest = std::max(errors.longest, length);
    }
    std::ranges::sort(errors.in_float);
    std::ranges::sort(errors.in_double);
    return errors;
}

}  // namespace

std::vector<std::string> cancellation_header() { return {"the line passes at", "computed in", "b^2", "a c", "D"}; }

Rows cancellation_rows() {
    Rows rows;
    for (const double offset : {0.4, 1.1}) {
        rows.push_back(cancellation_row<float>(offset, "float"));
        rows.push_back(cancellation_row<double>(offset, "double"));
    }
    return rows;
}

std::vector<std::string> normal_header() {
    return {"quadric",          "gradients' lengths",   "float: median [rad]",
            "float: max [rad]", "double: median [rad]", "double: max [rad]"};
}

Rows normal_rows(const ChapterRun& run) {
    const std::array<std::pair<const char*, QuadricKind>, 5> kinds = {{{"ellipsoid", QuadricKind::ellipsoid},
                                                                       {"cylinder", QuadricKind::cylinder},
                                                                       {"cone", QuadricKind::cone},
                                                                       {"paraboloid", QuadricKind::paraboloid},
                                                                       {"hyperboloid", QuadricKind::hyperboloid}}};
    const WorkloadSize draw{run.sized<std::size_t>(2'000, 500), run.seed};
    Rows rows;
    for (const auto& [name, kind] : kinds) {
        const NormalErrors errors = normal_errors(kind, draw, run.threads);
        rows.push_back({name, fmt::format("{:.2g} to {:.2g}", errors.shortest, errors.longest),
                        fmt::format("{:.1e}", quantile(errors.in_float, 0.5)),
                        fmt::format("{:.1e}", quantile(errors.in_float, 1)),
                        fmt::format("{:.1e}", quantile(errors.in_double, 0.5)),
                        fmt::format("{:.1e}", quantile(errors.in_double, 1))});
    }
    return rows;
}

std::vector<std::string> decisions_header(const ChapterRun& run) {
    std::vector<std::string> header = {"workload"};
    for (const auto& [title, name] : columns) header.push_back(name);
    if (run.is_yours("nearest_sphere_hit")) header.push_back("yours");
    return header;
}

Rows decisions_rows(const ChapterRun& run) {
    const std::vector<SphereMethod> methods = ray_sphere_methods();
    Rows rows;
    for (const SphereWorkload& workload : ray_sphere_workloads({run.sized<std::size_t>(20'000, 1'000), run.seed})) {
        const Truth truth = truth_of(workload, run.threads);
        std::vector<std::string> row = {workload.name};
        for (const auto& [title, name] : columns)
            row.push_back(cell(wrong_decisions(answers_of(find_method(methods, title), workload), truth)));
        if (run.is_yours("nearest_sphere_hit"))
            row.push_back(cell(wrong_decisions(answers_of(your_sphere_method(), workload), truth)));
        rows.push_back(row);
    }
    return rows;
}

CurveChart wrong_by_distance(const ChapterRun& run) {
    // `stable` decides like `textbook`, and `factored` nearly like `reformulated`, so they are left out.
    const std::vector<std::string> titles = {"textbook, float", "reformulated, float", "textbook, double",
                                             "reformulated, double"};
    std::vector<Curve> curves;
    for (const std::string& title : titles) curves.push_back({.name = title, .x = {}, .y = {}});
    const std::vector<SphereMethod> methods = ray_sphere_methods();
    for (double distance = 2; distance < 3e8; distance *= run.sized(2, 8)) {
        const SphereWorkload workload = spheres_at(distance, {run.sized<std::size_t>(5'000, 500), run.seed});
        const Truth truth = truth_of(workload, run.threads);
        for (Curve& curve : curves) {
            const auto answers = answers_of(find_method(methods, curve.name), workload);
            const double wrong = wrong_decisions(answers, truth).all();
            if (wrong == 0) continue;  // a logarithmic axis has no zero
            curve.x.push_back(distance);
            curve.y.push_back(wrong);
        }
    }
    std::erase_if(curves, [](const Curve& curve) { return curve.x.empty(); });
    return {.title = "The further a sphere, the fewer digits are left",
            .x_label = "distance / radius",
            .y_label = "wrong decisions [ppm]",
            .x_axis = AxisKind::logarithmic,
            .y_axis = AxisKind::logarithmic,
            .curves = curves};
}

}  // namespace raylab
