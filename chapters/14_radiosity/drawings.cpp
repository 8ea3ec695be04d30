#include "drawings.h"

#include "raylab/report/plane/plane_sketch.h"

#include <cmath>
#include <numbers>

namespace raylab::cornell {

namespace {

using namespace plane_ink;
using Arc = PlaneDrawing::Arc;

double degrees(PlanePoint from, PlanePoint to) {
    return std::atan2(to.y - from.y, to.x - from.x) * 180 / std::numbers::pi;
}

PlanePoint along(PlanePoint from, double angle, double length) {
    const double radians = angle * std::numbers::pi / 180;
    return {from.x + length * std::cos(radians), from.y + length * std::sin(radians)};
}

PlaneWords centred(const std::string& color, Point2 aside) {
    return {.aside = aside, .anchor = Anchor::center, .color = color, .height = 14};
}

// A patch seen from its edge: a line across its normal, and a piece of it that stands out.
void add_patch(PlaneSketch& sketch, PlanePoint at, double normal, const std::string& color, const std::string& name,
               double name_side) {
    sketch.line(along(at, normal + 90, 1.5), along(at, normal - 90, 1.5), stroke(color, 5));
    sketch.line(along(at, normal + 90, 0.22), along(at, normal - 90, 0.22), stroke(black, 7));
    sketch.arrow(at, along(at, normal, 1.7), stroke(color));
    sketch.words(along(at, normal + name_side, 1.5), name, centred(color, {0, 26}));
}

}  // namespace

PlaneDrawing draw_two_patches() {
    const PlanePoint i{0, 0}, j{6.4, 2.6};
    constexpr double normal_i = 68, normal_j = 236;
    PlaneSketch sketch;
    sketch.line(i, j, stroke(grey, 1.8, dashed));
    add_patch(sketch, i, normal_i, blue, "patch *i*", -90);
    add_patch(sketch, j, normal_j, vermilion, "patch *j*", 90);
    const double way = degrees(i, j), back = degrees(j, i) + 360;
    sketch.add(Arc{i, 1.15, way, normal_i, stroke(blue, 2)});
    sketch.add(Arc{j, 1.15, back, normal_j, stroke(vermilion, 2)});
    sketch.words(along(i, (way + normal_i) / 2, 1.5), "*θ*_{i}", centred(blue, {4, 4}));
    sketch.words(along(j, (back + normal_j) / 2, 1.5), "*θ*_{j}", centred(vermilion, {-4, 6}));
    sketch.words({(i.x + j.x) / 2, (i.y + j.y) / 2}, "*r*", centred(grey, {10, 24}));
    sketch.words(along(i, normal_i, 1.7), "**n**_{i}", centred(blue, {0, -10}));
    sketch.words(along(j, normal_j, 1.7), "**n**_{j}", centred(vermilion, {0, 26}));
    sketch.words(i, "d*A*_{i}", centred(black, {-4, 26}));
    sketch.words(j, "d*A*_{j}", centred(black, {4, -16}));
    return sketch.drawing({-2.2, -1.6}, {8.6, 4.2}, 860, 460);
}

PlaneDrawing draw_contour() {
    const PlanePoint eye{0, 0};
    const std::vector<PlanePoint> polygon{{2.2, 3.3}, {5.6, 2.7}, {6.3, 4.1}, {3.2, 4.9}};
    PlaneSketch sketch;
    sketch.polygon({{-2.6, -0.7}, {3.4, -0.7}, {4.6, 0.5}, {-1.4, 0.5}}, {.line = light_grey, .fill = pale_grey});
    sketch.polygon(polygon, {.line = vermilion, .fill = pale_orange, .width = 2.5});
    for (const PlanePoint& corner : polygon) sketch.line(eye, corner, stroke(grey, 1.3, dashed));
    sketch.polygon({eye, polygon[0], polygon[1]}, {.line = blue, .fill = pale_blue, .width = 2});
    sketch.arrow(eye, {0, 2.4}, stroke(black));
    sketch.arrow({2.6, 2.0}, {1.7, 3.05}, stroke(green));
    sketch.add(Arc{eye, 1.5, degrees(eye, polygon[1]), degrees(eye, polygon[0]), stroke(blue)});
    sketch.dot(eye, 6, black);
    sketch.words(eye, "*P*", centred(black, {-14, 20}));
    sketch.words({0, 2.4}, "**n**", centred(black, {-16, 4}));
    sketch.words(along(eye, 41, 1.5), "*β*_{k}", centred(blue, {22, -10}));
    sketch.words({1.7, 3.05}, "**g**_{k}", centred(green, {-14, -6}));
    sketch.words({4.3, 4.0}, "patch *j*", centred(vermilion, {0, 0}));
    sketch.words({3.9, 2.6}, "edge *k*", centred(blue, {6, 20}));
    sketch.words({-1.2, -0.4}, "patch *i*", centred(grey, {0, 0}));
    return sketch.drawing({-2.8, -1}, {7, 5.2}, 760, 480);
}

CurveChart residual_chart(const SceneRadiosity& solved) {
    const auto n = static_cast<int>(solved.system.patches());
    CurveChart chart{.title = "Each sweep leaves a share of the error; Gauss-Seidel's uses what it has just learnt",
                     .x_label = "sweeps (shooting: as many shots as there are patches)",
                     .y_label = "residual, relative to the largest radiosity",
                     .y_axis = AxisKind::logarithmic};
    for (const auto& [name, step] : std::vector<std::pair<std::string, int>>{
             {"jacobi", 1}, {"gauss_seidel", 1}, {"relaxation", 1}, {"shooting", n}}) {
        const Solution solution = solver_named(name).run(solved.system, {.residual = 1e-8});
        Curve curve{.name = name};
        for (std::size_t k = static_cast<std::size_t>(step); k <= solution.residuals.size();
             k += static_cast<std::size_t>(step)) {
            curve.x.push_back(static_cast<double>(k) / step);
            curve.y.push_back(solution.residuals[k - 1]);
        }
        chart.curves.push_back(curve);
    }
    return chart;
}

}  // namespace raylab::cornell
