#include "pictures.h"

#include "raylab/image/color_map.h"
#include "raylab/image/draw.h"
#include "raylab/tracer/picture/whitted_picture.h"
#include "raylab/tracer/refracted_direction.h"
#include "raylab/tracer/shading/fresnel.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace raylab::recursion {

namespace {

constexpr double degree = std::numbers::pi / 180;

// A picture whose pixels are computed from their ray trees.
template <class ColorOf>
Image of_trees(const Scene& scene, const WhittedOptions& options, ImageSize size, const ChapterRun& run,
               const ColorOf& color) {
    const auto accelerator = make_accelerator("auto", scene);
    return eye_picture(camera_frame(scene.camera, size, scene.source), {.threads = run.threads},
                       [&](const Ray& ray) { return color(ray_tree(scene, *accelerator, options, ray)); });
}

// For each node, the kind of the first hit's child through which it was reached; the eye ray's own is `eye`.
std::vector<RayKind> first_branches(const RayTree& tree) {
    std::vector<RayKind> branches{RayKind::eye};
    for (std::size_t i = 1; i < tree.nodes.size(); ++i)
        branches.push_back(tree.nodes[i].parent == 0 ? tree.nodes[i].kind : branches[tree.nodes[i].parent]);
    return branches;
}

Color sum_through(const RayTree& tree, RayKind first_branch) {
    const auto branches = first_branches(tree);
    Color sum{0, 0, 0};
    for (std::size_t i = 0; i < tree.nodes.size(); ++i)
        if (branches[i] == first_branch && tree.nodes[i].kind != RayKind::shadow) sum += tree.nodes[i].contribution;
    return sum;
}

// A water surface from the side: x to the right, y up, in metres.
class Aquarium {
public:
    Aquarium() : image_(width, height, {1, 1, 1}) {
        for (int y = surface; y < height; ++y)
            for (int x = 0; x < width; ++x) image_.at(x, y) = {0.80f, 0.90f, 0.97f};
        draw_line(image_, {0, surface}, {width, surface}, 2, ink::blue);
    }

    // Draws a ray from the light at the bottom, and its continuations at the surface.
    void split(double angle, const Pixel& color) {
        const Vec3d direction{std::sin(angle), std::cos(angle), 0};
        const Vec3d at = light + direction * (-light.y / direction.y);
        const double share = fresnel(direction.y, ior, 1);
        line(light, at, 1, color);
        line(at, at + 2.0 * Vec3d{direction.x, -direction.y, 0}, share, color);
        if (const auto refracted = refracted_direction(direction, {0, -1, 0}, ior, 1))
            line(at, at + 2.0 * *refracted, 1 - share, color);
    }

    void text(double x, double y, const std::string& words) { draw_text(image_, at({x, y, 0}), 10, words, ink::black); }
    const Image& image() const { return image_; }

private:
    static constexpr int width = 640, height = 300, surface = 130;
    static constexpr double scale = 130, ior = 1.33;
    const Vec3d light{-1.6, -1, 0};

    static Point2 at(const Vec3d& p) { return {width / 2.0 + scale * p.x, surface - scale * p.y}; }
    void line(const Vec3d& from, const Vec3d& to, double share, const Pixel& color) {
        draw_line(image_, at(from), at(to), 0.4 + 4 * share, color);
    }

    Image image_;
};

double schlick(double cosine, double ior) {
    const double r = std::pow((1 - ior) / (1 + ior), 2);
    return r + (1 - r) * std::pow(1 - cosine, 5);
}

}  // namespace

Image seen(const Scene& scene, const WhittedOptions& options, ImageSize size, int per_side, const ChapterRun& run) {
    const auto accelerator = make_accelerator("auto", scene);
    return whitted_picture(
        scene, *accelerator, camera_frame(scene.camera, size, scene.source), options,
        {.samples = {SamplePattern::jittered, per_side, run.seed}, .threads = run.threads, .label = "rays"});
}

Terms terms(const Scene& scene, const WhittedOptions& options, ImageSize size, const ChapterRun& run) {
    const auto through = [&](RayKind kind) {
        return of_trees(scene, options, size, run, [kind](const RayTree& tree) { return sum_through(tree, kind); });
    };
    return {through(RayKind::eye), through(RayKind::reflected), through(RayKind::transmitted)};
}

Image rays_picture(const Scene& scene, const WhittedOptions& options, ImageSize size, const ChapterRun& run) {
    return of_trees(scene, options, size, run, [](const RayTree& tree) {
        double rays = 0;
        for (const auto& node : tree.nodes)
            rays += node.kind != RayKind::shadow && node.ended != Ending::depth && node.ended != Ending::threshold &&
                    node.ended != Ending::total_internal_reflection;
        const Pixel heat = heat_color(std::log2(rays) / 8);
        return Color{heat.r, heat.g, heat.b};
    });
}

Image draw_snell() {
    Aquarium aquarium;
    const Pixel colors[] = {ink::black, ink::blue, ink::sky_blue, ink::green, ink::orange, ink::vermilion, ink::purple};
    const double angles[] = {0, 15, 30, 42, 47.5, 55, 65};
    for (std::size_t i = 0; i < std::size(angles); ++i) aquarium.split(angles[i] * degree, colors[i]);
    aquarium.text(-2.4, 0.85, "air, n = 1");
    aquarium.text(-2.4, -1.2, "water, n = 1.33: beyond 48.75 degrees all is reflected");
    return aquarium.image();
}

CurveChart fresnel_chart() {
    CurveChart chart{.title = "What a smooth surface of glass reflects",
                     .x_label = "angle of incidence [degrees]",
                     .y_label = "share of the light",
                     .x_axis = AxisKind::linear,
                     .y_axis = AxisKind::linear,
                     .curves = {{"from air", {}, {}}, {"from glass", {}, {}}, {"Schlick, either way", {}, {}}}};
    for (int tenths = 0; tenths <= 900; ++tenths) {
        const double angle = tenths / 10.0, cosine = tenths == 900 ? 0 : std::cos(angle * degree);
        const double shares[] = {fresnel(cosine, 1, 1.5), fresnel(cosine, 1.5, 1), schlick(cosine, 1.5)};
        for (std::size_t i = 0; i < 3; ++i) {
            chart.curves[i].x.push_back(angle);
            chart.curves[i].y.push_back(shares[i]);
        }
    }
    return chart;
}

}  // namespace raylab::recursion
