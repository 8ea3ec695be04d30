#include "sight_cases.h"

#include "squares.h"

#include "raylab/radiosity/form_factor/contour_form_factor.h"
#include "raylab/radiosity/form_factor/hemicube.h"
#include "raylab/radiosity/scene_radiosity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>

namespace raylab::cornell {

namespace {

constexpr double distance = 5, screen_height = 0.5, screen_side = 0.3;

// The same for a square whose middle is elsewhere, in a plane z = height.
Quadrilateral square_at(double x, double y, double height, double side) {
    Quadrilateral square = upper_square(height, side);
    for (Vec3d& corner : square) corner += Vec3d{x - 0.5, y - 0.5, 0};
    return square;
}

// What a point of the lower square sees of the upper one, past a screen between them. Projected from the point, the
// screen is a square in the upper one's plane, and what both have in common is a rectangle, so this is Lambert's
// formula twice.
double seen_past_screen(double x, double y) {
    const auto shadow = [&](double middle, double eye) { return eye + (middle - eye) * distance / screen_height; };
    const double half = screen_side / 2 * distance / screen_height;
    const double left = std::max(0.0, shadow(0.5, x) - half), right = std::min(1.0, shadow(0.5, x) + half),
                 low = std::max(0.0, shadow(0.5, y) - half), high = std::min(1.0, shadow(0.5, y) + half);
    const Vec3d eye{x, y, 0}, up{0, 0, 1};
    const double all = contour_form_factor(eye, up, upper_square(distance));
    if (left >= right || low >= high) return all;
    const Quadrilateral hidden{Vec3d{left, low, distance}, Vec3d{left, high, distance}, Vec3d{right, high, distance},
                               Vec3d{right, low, distance}};
    return all - contour_form_factor(eye, up, hidden);
}

// The mean over points of the lower square, n x n of them in the middles of equal cells.
double mean_over_square(int n, const std::function<double(double x, double y)>& value) {
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) sum += value((i + 0.5) / n, (j + 0.5) / n);
    return sum / (n * n);
}

double hemicube_past_screen(double x, double y) {
    Quadrilateral screen = square_at(0.5, 0.5, screen_height, screen_side), target = upper_square(distance);
    const std::array<std::span<const Vec3d>, 2> polygons{target, screen};
    const Hemicube cube = hemicube({x, y, 0}, {0, 0, 1}, {1, 0, 0}, polygons, 512);
    return form_factor_row(cube, polygons.size(), DeltaFactors::normalised)[0];
}

Object front_of(const Quadrilateral& corners, std::size_t material) {
    Polygon polygon;
    for (const Vec3d& corner : corners) polygon.vertices.push_back(convert<float>(corner));
    return {.shape = polygon, .front = material, .back = material, .sides = Sides::front};
}

// By the lab's own way: the factor in full view, times the share of shadow rays that pass.
double shadow_rays_past_screen(const ChapterRun& run) {
    Scene scene;
    scene.source = "a screen before a square";
    scene.materials = {{.diffuse = Color(0.5), .emission = Color(1)}};
    scene.objects = {front_of(lower_square(), 0), front_of(upper_square(distance), 0),
                     front_of(square_at(0.5, 0.5, screen_height, screen_side), 0)};
    return scene_radiosity(scene, {.edge = 1, .form_factors = {.rays = 4096, .threads = run.threads}})
        .system.form_factors.at(0, 1);
}

std::vector<CaseRow> hemicube_visibility(const ChapterRun& run) {
    const double truth = mean_over_square(400, seen_past_screen);
    const auto row = [&](const std::string& method, double value, double least, double most) {
        const double error = std::abs(value / truth - 1);
        return CaseRow{method,
                       least > 0 ? fmt::format("fails: wrong by at least {:g} %", 100 * least)
                                 : fmt::format("holds: wrong by at most {:g} %", 100 * most),
                       fmt::format("{:.5g} for {:.5g}, wrong by {:.3g} %", value, truth, 100 * error),
                       error >= least && error <= most};
    };
    constexpr double any = std::numeric_limits<double>::infinity();
    return {row("hemicube at the centre, 512 pixels", hemicube_past_screen(0.5, 0.5), 0.99, any),
            row("hemicubes at the centres of 16 x 16 pieces", mean_over_square(16, hemicube_past_screen), 0, 0.03),
            row("contour, 4096 shadow rays between all points of both", shadow_rays_past_screen(run), 0, 0.03)};
}

// A floor below a light of a tenth of its size: seen from above, its brightness is a smooth hill.
Scene floor_under_light() {
    Scene scene;
    scene.source = "a floor under a light";
    scene.materials = {{.name = "floor", .diffuse = Color(0.5)},
                       {.name = "light", .diffuse = Color(0), .emission = Color(10)}};
    scene.objects = {front_of(lower_square(), 0), front_of(upper_square(0.35, 0.1), 1)};
    scene.camera = {
        .position = {0.5, 0.5, 0.3}, .target = {0.5, 0.5, 0}, .up = {0, 1, 0}, .projection = Orthographic{0.9 / 900}};
    scene.image = {900, 1};  // one row of pixels through the floor's middle, a thousandth of its side each
    return scene;
}

// The largest bend between pixels that are two steps apart: what an eye sees as a bright or dark line, a Mach band.
double largest_bend(const std::function<double(int x)>& brightness, int width) {
    constexpr int step = 4;
    double largest = 0, brightest = 0;
    for (int x = step; x + step < width; ++x) {
        largest = std::max(largest, std::abs(brightness(x - step) - 2 * brightness(x) + brightness(x + step)));
        brightest = std::max(brightest, brightness(x));
    }
    return largest / brightest;
}

std::vector<CaseRow> mach_gouraud(const ChapterRun& run) {
    const Scene scene = floor_under_light();
    const CameraFrame frame = camera_frame(scene.camera, scene.image);
    const double truth = largest_bend(
        [&](int x) {
            const auto at = convert<double>(eye_ray(frame, x + 0.5, 0.5).origin);
            return contour_form_factor({at.x, at.y, 0}, {0, 0, 1}, upper_square(0.35, 0.1));
        },
        scene.image.width);
    const auto row = [&](const std::string& method, double edge, RadiosityShading shading, double least, double most) {
        const auto solved = scene_radiosity(scene, {.edge = edge, .form_factors = {.rays = 0, .threads = run.threads}});
        const Image picture = radiosity_picture(solved.view(), frame, shading, {.threads = run.threads});
        const double bend = largest_bend([&](int x) { return picture.at(x, 0).g; }, picture.width());
        return CaseRow{method,
                       least > 0 ? fmt::format("fails: bends over {:g} times as sharp as the truth's", least)
                                 : fmt::format("holds: at most {:g} times", most),
                       fmt::format("{:.3g} times", bend / truth), bend / truth > least && bend / truth <= most};
    };
    constexpr double any = std::numeric_limits<double>::infinity();
    using Shading = RadiosityShading;
    return {row("patches of 1/12, each in its own brightness", 1.0 / 12, Shading::patches, 50, any),
            row("patches of 1/12, interpolated (Gouraud)", 1.0 / 12, Shading::vertices, 5, any),
            row("patches of 1/48, interpolated", 1.0 / 48, Shading::vertices, 1.5, any),
            row("patches of 1/12, a final gather", 1.0 / 12, Shading::gather, 0, 1.05)};
}

}  // namespace

std::vector<StabilityCase> sight_cases(const ChapterRun& run) {
    const auto of = [&run](std::vector<CaseRow> (*rows)(const ChapterRun&)) {
        return [run, rows] { return rows(run); };
    };
    return {{"HEMICUBE-VISIBILITY",
             "a small screen before a patch's centre: it hides all from the centre, and little from the patch",
             of(hemicube_visibility)},
            {"MACH-GOURAUD", "interpolated patches where the light is smooth: at their borders the slope jumps",
             of(mach_gouraud)}};
}

}  // namespace raylab::cornell
