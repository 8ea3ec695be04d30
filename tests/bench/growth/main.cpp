// bench_growth [FOLDER] [LEAVES] [PATCHES]: the Cornell box by links, the error of a link held and the smallest element
// made smaller until there are so many leaves, beside the whole matrix of up to so many patches: processor seconds of
// one thread, links, form factors, and by which powers of the patches they grow. FOLDER gets the chart. Beside it, for
// two spheres around one centre, seconds and the error, since their radiosities are known.

#include "bench/line_through.h"
#include "bench/seconds_of.h"
#include "raylab/radiosity/hierarchical_scene.h"
#include "raylab/radiosity/scene_radiosity.h"
#include "raylab/report/chart/chart.h"
#include "raylab/scene/read_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

using namespace raylab;

namespace {

double processor_seconds(const std::function<void()>& work) {
    return bench::seconds_of(CLOCK_PROCESS_CPUTIME_ID, work);
}

/// Of one way: patches, and what so many took.
struct Growth {
    std::vector<double> patches = {}, numbers = {}, seconds = {};
};

// By which power of x the last `count` values of y grow: the slope of the line through their logarithms.
double power(const std::vector<double>& x, const std::vector<double>& y, std::size_t count) {
    std::vector<double> log_x, log_y;
    for (std::size_t i = x.size() - count; i < x.size(); ++i) {
        log_x.push_back(std::log(x[i]));
        log_y.push_back(std::log(y[i]));
    }
    return bench::line_through(log_x, log_y).b;
}

void say(const char* way, const Growth& growth) {
    fmt::print("{:12} {:8.0f} patches {:10.0f} numbers {:8.2f} s\n", way, growth.patches.back(), growth.numbers.back(),
               growth.seconds.back());
    std::fflush(stdout);
}

Growth of_links(const Scene& scene, double leaves) {
    Growth growth;
    for (double edge = 0.028; growth.patches.empty() || growth.patches.back() < leaves; edge /= std::sqrt(2)) {
        std::size_t patches = 0;
        double links = 0;
        growth.seconds.push_back(processor_seconds([&] {
            const auto solved =
                scene_hierarchy(scene, {.edge = edge, .solving = {.error = 0.05, .residual = 1e-4, .threads = 1}});
            patches = solved.mesh->patches.size();
            links = static_cast<double>(solved.solution.work.links);
        }));
        // A smaller limit that makes no new leaf says nothing of growth.
        if (!growth.patches.empty() && static_cast<double>(patches) < 1.05 * growth.patches.back()) {
            growth.seconds.pop_back();
            if (edge < 1e-6) break;
            continue;
        }
        growth.patches.push_back(static_cast<double>(patches));
        growth.numbers.push_back(links);
        say("links", growth);
    }
    return growth;
}

Growth of_matrix(const Scene& scene, std::size_t most) {
    Growth growth;
    for (std::size_t patches = 1000; patches <= most; patches *= 2) {
        std::size_t made = 0;
        double factors = 0;
        growth.seconds.push_back(processor_seconds([&] {
            SceneRadiosityOptions options{.patches = patches, .solving = {.residual = 1e-4}};
            options.form_factors.threads = 1;
            const auto solved = scene_radiosity(scene, options);
            made = solved.mesh->patches.size();
            factors = static_cast<double>(solved.work.links);
        }));
        growth.patches.push_back(static_cast<double>(made));
        growth.numbers.push_back(factors);
        say("matrix", growth);
    }
    return growth;
}

// An inner sphere that shines, and an outer one: B1 = pi + r1 B2 and B2 = r2 (a B1 + (1 - a) B2), where a is the ratio
// of the areas, the share of the outer sphere's view that the inner one fills. As polyhedra they are this but for their
// pieces' errors.
struct ConcentricSpheres {
    static constexpr double r1 = 0.3, r2 = 0.6, a = 0.25, b2_of_b1 = r2 * a / (1 - r2 * (1 - a));
    static constexpr double outer = b2_of_b1 * std::numbers::pi / (1 - r1 * b2_of_b1);

    Scene scene = {.source = "two spheres",
                   .materials = {{.diffuse = Color(r1), .emission = Color(1)}, {.diffuse = Color(r2)}},
                   .objects = {{.shape = Sphere{{0, 0, 0}, 0.5f}, .front = 0, .back = 0, .sides = Sides::front},
                               {.shape = Sphere{{0, 0, 0}, 1}, .front = 1, .back = 1, .sides = Sides::back}}};

    /// The root mean square of the outer sphere's error, relative to its radiosity.
    static double error(const PatchMesh& mesh, const Radiosities& radiosity) {
        double sum = 0, area = 0;
        for (std::size_t i = 0; i < mesh.patches.size(); ++i) {
            if (mesh.material(mesh.patches[i]).emission != Color(0)) continue;
            sum += mesh.patches[i].area * std::pow(radiosity[i].g / outer - 1, 2);
            area += mesh.patches[i].area;
        }
        return std::sqrt(sum / area);
    }
};

void say_errors() {
    const ConcentricSpheres spheres;
    const auto say_error = [](const char* way, const auto& solve) {
        std::size_t patches = 0;
        double error = 0;
        const double seconds = processor_seconds([&] {
            const auto [count, found] = solve();
            patches = count;
            error = found;
        });
        fmt::print("two spheres: {:8} {:6} patches, wrong by {:.2g} % after {:.2g} s\n", way, patches, 100 * error,
                   seconds);
        std::fflush(stdout);
    };
    for (const std::size_t patches : {200u, 800u, 3200u})
        say_error("matrix", [&] {
            SceneRadiosityOptions options{.patches = patches};
            options.form_factors.threads = 1;
            const auto solved = scene_radiosity(spheres.scene, options);
            return std::pair(solved.mesh->patches.size(), spheres.error(*solved.mesh, solved.solution.radiosity));
        });
    // Once: the roots of a curved shape's links are its pieces, as many whatever is asked.
    say_error("links", [&] {
        const auto solved = scene_hierarchy(spheres.scene, {.edge = 0.1, .solving = {.error = 0.03, .threads = 1}});
        return std::pair(solved.mesh->patches.size(), spheres.error(*solved.mesh, solved.patches));
    });
}

void say_powers(const char* way, const Growth& growth) {
    const std::size_t all = growth.patches.size(), last = std::min<std::size_t>(6, all);
    fmt::print("{:12} grow with the power {:.2f} of the patches, seconds with {:.2f}; the last {}: {:.2f}, {:.2f}\n",
               way, power(growth.patches, growth.numbers, all), power(growth.patches, growth.seconds, all), last,
               power(growth.patches, growth.numbers, last), power(growth.patches, growth.seconds, last));
}

}  // namespace

int main(int count, char** words) {
    say_errors();
    const std::string folder = count > 1 ? words[1] : ".";
    const double leaves = count > 2 ? std::atof(words[2]) : 300'000;
    const auto most = static_cast<std::size_t>(count > 3 ? std::atol(words[3]) : 16'000);
    const Scene scene = read_scene(RAYLAB_SOURCE "/chapters/14_radiosity/scene.toml", {});
    const Growth links = of_links(scene, leaves), matrix = of_matrix(scene, most);
    say_powers("links", links);
    if (matrix.patches.empty()) return 0;
    say_powers("matrix", matrix);

    // Beyond what was measured the matrix goes on as the square of its patches.
    Curve of_all{.name = "matrix", .x = matrix.patches, .y = matrix.seconds, .measured_to = matrix.patches.back()};
    for (const double patches : links.patches) {
        if (patches <= matrix.patches.back()) continue;
        of_all.x.push_back(patches);
        of_all.y.push_back(matrix.seconds.back() * std::pow(patches / matrix.patches.back(), 2));
    }
    write_chart({.title = "The Cornell box: links, and the matrix (dashed: as its square goes on)",
                 .x_label = "patches",
                 .y_label = "processor seconds",
                 .x_axis = AxisKind::logarithmic,
                 .y_axis = AxisKind::logarithmic,
                 .curves = {{.name = "links", .x = links.patches, .y = links.seconds}, of_all}},
                folder, "growth");
}
