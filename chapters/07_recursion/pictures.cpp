#include "pictures.h"

#include "raylab/geometry/degree.h"
#include "raylab/image/color_map.h"
#include "raylab/report/chapter_picture.h"
#include "raylab/tracer/picture/whitted_picture.h"
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

namespace raylab::recursion {

namespace {

// The colour that the reflected ray of a first hit brings, times its share. The eye is outside of all glass, and so is
// that ray.
Color reflected_part(const Scene& scene, const Accelerator& accelerator, const WhittedOptions& options,
                     const Ray& eye_ray) {
    const RayTree first = ray_tree(scene, accelerator, {.depth = 2, .shadows = WhittedOptions::Shadows::none}, eye_ray);
    WhittedOptions deeper = options;
    deeper.depth = options.depth - 1;
    for (const auto& node : first.nodes) {
        if (node.kind != RayKind::reflected) continue;
        Traversal traversal;
        return node.throughput * whitted_color(scene, accelerator, deeper, node.ray, traversal);
    }
    return {0, 0, 0};
}

Image difference(const Image& whole, const Image& one, const Image& other) {
    Image rest(whole.width(), whole.height());
    for (int y = 0; y < whole.height(); ++y)
        for (int x = 0; x < whole.width(); ++x) {
            const Pixel &all = whole.at(x, y), &a = one.at(x, y), &b = other.at(x, y);
            rest.at(x, y) = {all.r - a.r - b.r, all.g - a.g - b.g, all.b - a.b - b.b};
        }
    return rest;
}

double schlick(double cosine, double ior) {
    const double r = std::pow((1 - ior) / (1 + ior), 2);
    return r + (1 - r) * std::pow(1 - cosine, 5);
}

}  // namespace

Terms terms(const Scene& scene, const WhittedOptions& options, ImageSize size, const ChapterRun& run) {
    const auto accelerator = make_accelerator("auto", scene);
    WhittedOptions eye_rays_only = options;
    eye_rays_only.depth = 1;
    Terms terms{.local = chapter_picture(scene, size, run, eye_rays_only),
                .reflected = {},
                .transmitted = {},
                .sum = chapter_picture(scene, size, run, options)};
    terms.reflected = eye_picture(camera_frame(scene.camera, size, scene.source), chapter_rays(run),
                                  [&](const Ray& ray) { return reflected_part(scene, *accelerator, options, ray); });
    terms.transmitted = difference(terms.sum, terms.local, terms.reflected);
    return terms;
}

Image rays_picture(const Scene& scene, const WhittedOptions& options, ImageSize size, const ChapterRun& run) {
    const auto accelerator = make_accelerator("auto", scene);
    return eye_picture(camera_frame(scene.camera, size, scene.source), {.threads = run.threads}, [&](const Ray& ray) {
        Traversal traversal;
        RayCounts counts;
        whitted_color(scene, *accelerator, options, ray, traversal, counts);
        const auto rays = static_cast<double>(counts.primary.cast + counts.secondary.cast);
        const Pixel heat = heat_color(std::log2(rays) / 8);
        return Color{heat.r, heat.g, heat.b};
    });
}

CurveChart fresnel_chart() {
    CurveChart chart{.title = "What a smooth surface of glass reflects",
                     .x_label = "angle of incidence [degrees]",
                     .y_label = "share of the light",
                     .x_axis = AxisKind::linear,
                     .y_axis = AxisKind::linear,
                     .curves = {{"from air", {}, {}},
                                {"from glass", {}, {}},
                                {"Schlick, by the angle of incidence", {}, {}},
                                {"Schlick from glass, by the angle in air", {}, {}}}};
    for (int tenths = 0; tenths <= 900; ++tenths) {
        const double angle = tenths / 10.0, cosine = tenths == 900 ? 0 : std::cos(angle * degree);
        const double sine_in_air = 1.5 * std::sin(angle * degree),
                     cosine_in_air = sine_in_air < 1 ? std::sqrt(1 - sine_in_air * sine_in_air) : 0;
        const double shares[] = {fresnel(cosine, 1, 1.5), fresnel(cosine, 1.5, 1), schlick(cosine, 1.5),
                                 schlick(cosine_in_air, 1.5)};
        for (std::size_t i = 0; i < std::size(shares); ++i) {
            chart.curves[i].x.push_back(angle);
            chart.curves[i].y.push_back(shares[i]);
        }
    }
    return chart;
}

}  // namespace raylab::recursion
