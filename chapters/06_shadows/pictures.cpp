#include "pictures.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/image/draw.h"
#include "raylab/tracer/picture/whitted_picture.h"

#include <cmath>

namespace raylab::shadows {

namespace {

Image traced(const Scene& scene, const WhittedOptions& options, const ChapterRun& run, ImageSize size) {
    const auto accelerator = make_accelerator("auto", scene);
    return whitted_picture(
        scene, *accelerator, camera_frame(scene.camera, size, scene.source), options,
        {.samples = {SamplePattern::jittered, run.sized(3, 2), run.seed}, .threads = run.threads, .label = "rays"});
}

constexpr ImageSize small{300, 188};

}  // namespace

Image shaded(const Scene& scene, const ChapterRun& run) { return traced(scene, {}, run, scene.image); }

Image lights_apart(const Scene& scene, const ChapterRun& run) {
    std::vector<Image> images;
    Scene part = scene;
    part.lights.clear();
    images.push_back(with_caption(traced(part, {}, run, small), "ambient light alone"));
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        part = scene;
        part.lights = {scene.lights[i]};
        part.background.ambient = {0, 0, 0};
        images.push_back(with_caption(traced(part, {}, run, small), i == 0 ? "the warm light" : "the cool light"));
    }
    return side_by_side(images);
}

Scene elsewhere(const Scene& scene, double scale, const Vec3d& by) {
    Scene moved = scene;
    const auto steps = AffineSteps::scale(Vec3d(scale)).then(AffineSteps::translate(by));
    for (Object& object : moved.objects) object.placement = AffineSteps::of(object.placement).then(steps).rounded();
    const auto carried = [&](const Vec3d& p) { return p * scale + by; };
    moved.camera.position = carried(scene.camera.position);
    moved.camera.target = carried(scene.camera.target);
    for (Light& light : moved.lights)
        if (auto* point = std::get_if<PointLight>(&light.kind)) point->position = carried(point->position);
    for (Material& material : moved.materials)
        if (auto* checker = std::get_if<Checker>(&material.diffuse)) checker->size *= scale;
    return moved;
}

Image with_shadows(const Scene& scene, const RayStart& start, const ChapterRun& run) {
    return traced(scene, {.start = start}, run, {400, 250});
}

namespace {

// A slanted surface among the floats of two axes, and the starts of a ray that leaves it at the hit point.
struct Microscope {
    static constexpr int width = 620, height = 350;
    static constexpr double unit = 62;  // pixels from float to float
    Image image{width, height, {1, 1, 1}};

    static Point2 at(double x, double y) { return {60 + unit * x, height - 60 - unit * y}; }
    void dot(double x, double y, double radius, const Pixel& color) { draw_disk(image, at(x, y), radius, color); }
    void line(double x0, double y0, double x1, double y1, double width_, const Pixel& color) {
        draw_line(image, at(x0, y0), at(x1, y1), width_, color);
    }
    void words(double x, double y, const std::string& text, const Pixel& color) {
        draw_text(image, at(x, y), 9, text, color);
    }
};

}  // namespace

Image draw_starts() {
    Microscope view;
    for (int x = -1; x <= 9; ++x)
        for (int y = -1; y <= 3; ++y) view.dot(x, y, 2.2, ink::grey);
    const auto surface = [](double x) { return 0.35 + 0.28 * x; };
    view.line(-0.8, surface(-0.8), 8.9, surface(8.9), 3, ink::blue);
    view.words(6.0, surface(6.0) - 0.55, "surface", ink::blue);
    const double x = 3.62, y = surface(x);
    view.dot(x, y, 5, ink::black);
    view.words(x - 2.35, y + 0.12, "exact hit point", ink::black);
    view.dot(4, 1, 5.5, ink::vermilion);
    view.words(4.15, 0.62, "rounded: below", ink::vermilion);
    view.line(4, 1, 5.75, 3.85, 1.4, ink::vermilion);
    view.dot(3, 2, 5.5, ink::green);
    view.words(0.55, 2.15, "next floats beyond", ink::green);
    draw_arrow(view.image, Microscope::at(3, 2), Microscope::at(4.75, 3.85), 2, ink::green);
    view.words(6.0, 3.75, "to the light", ink::black);
    return view.image;
}

}  // namespace raylab::shadows
