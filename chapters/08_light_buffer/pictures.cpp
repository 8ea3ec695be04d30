#include "pictures.h"

#include "light_methods.h"
#include "shown_cell.h"

#include "raylab/image/draw.h"
#include "raylab/report/chapter_picture.h"
#include "raylab/report/structure/structure_heat_map.h"
#include "raylab/tracer/picture/whitted_picture.h"
#include "raylab/tracer/shading/ray_start.h"

#include <fmt/format.h>

#include <array>

namespace raylab::lantern {

namespace {

// The cube unfolded to a cross: the back wall's face in the middle of a row of four, the upper and the lower one above
// and below it.
struct Cross {
    static constexpr int side = 160;  // pixels of a face
    static constexpr int width = 4 * side, height = 3 * side;

    // The direction from inside the cube to a pixel's center; absent beside the cross.
    static std::optional<Vec3d> direction(double x, double y) {
        const int column = static_cast<int>(x) / side, row = static_cast<int>(y) / side;
        const double right = 2 * (x / side - column) - 1, up = 1 - 2 * (y / side - row);
        if (row == 0 && column == 1) return Vec3d{right, 1, up};
        if (row == 2 && column == 1) return Vec3d{right, -1, -up};
        if (row != 1) return std::nullopt;
        const std::array<Vec3d, 4> around{Vec3d{-1, up, -right}, Vec3d{right, up, -1}, Vec3d{1, up, right},
                                          Vec3d{-right, up, 1}};
        return around[static_cast<std::size_t>(column)];
    }

    // Adds white beside the cross, lines between the faces, and the faces' names.
    static Image framed(Image image) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                if (!direction(x + 0.5, y + 0.5)) image.at(x, y) = ink::white;
        const auto face = [&](int column, int row, const std::string& name) {
            const Point2 corner{1.0 * column * side, 1.0 * row * side};
            draw_rectangle(image, corner, {corner.x + side, corner.y + side}, 1.5, ink::sky_blue);
            const double left = corner.x + 3, top = corner.y + side - 18;
            fill_convex(image, {{left, top}, {left + 22, top}, {left + 22, top + 15}, {left, top + 15}}, ink::white);
            draw_text(image, {left + 11, top + 12}, 9, name, ink::black, Anchor::center);
        };
        face(1, 0, "+y");
        face(0, 1, "-x");
        face(1, 1, "-z");
        face(2, 1, "+x");
        face(3, 1, "+z");
        face(1, 2, "-y");
        return image;
    }
};

}  // namespace

ImageSize beside(const ChapterRun& run) { return run.sized(ImageSize{640, 440}, ImageSize{320, 220}); }

Image shaded(const Scene& scene, ImageSize size, const LightBufferOptions& options, const ChapterRun& run) {
    const LightBuffered structure(make_accelerator("auto", scene), scene, options);
    return whitted_picture(scene, structure, camera_frame(scene.camera, size, scene.source), {}, chapter_rays(run));
}

Image seen_by_light(const Scene& scene, const ChapterRun& run) {
    const auto accelerator = make_accelerator("auto", scene);
    const int per_side = run.sized(3, 1);
    Image image(Cross::width, Cross::height);
    for_each_tile(image.width(), image.height(), run.threads, "", [&](Tile tile) {
        Traversal traversal;
        const auto seen = [&](double x, double y) -> Color {
            const auto direction = Cross::direction(x, y);
            if (!direction) return {0, 0, 0};
            return whitted_color(scene, *accelerator, {}, {convert<float>(light_of(scene)), convert<float>(*direction)},
                                 traversal);
        };
        fill(image, tile, [&](int x, int y) -> Color {
            Color sum{0, 0, 0};
            for (int i = 0; i < per_side; ++i)
                for (int j = 0; j < per_side; ++j) sum += seen(x + (i + 0.5) / per_side, y + (j + 0.5) / per_side);
            return sum / static_cast<double>(per_side * per_side);
        });
    });
    return Cross::framed(std::move(image));
}

Image cell_lists(const Scene& scene, int resolution, const ChapterRun&) {
    const LightBuffer buffer = buffer_of(scene, resolution);
    CostMap map{Cross::width, Cross::height,
                std::vector<double>(static_cast<std::size_t>(Cross::width * Cross::height))};
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            if (const auto direction = Cross::direction(x + 0.5, y + 0.5))
                map.at(x, y) = static_cast<double>(buffer.list(light_cell(*direction, resolution)).size());
    return Cross::framed(heat_map(map, fmt::format("primitives listed, 6 x {0} x {0} cells", resolution)));
}

std::array<Image, 2> shadow_ray_costs(const Scene& scene, const ChapterRun& run) {
    const auto eye = make_accelerator("auto", scene);
    const CameraFrame frame = camera_frame(scene.camera, beside(run), scene.source);
    const auto map = [&](const Accelerator& structure) {
        return cost_map(frame, run.threads, [&](const Ray& ray) {
            Traversal traversal, uncounted;
            const auto hit = eye->closest(ray, uncounted);
            if (!hit) return 0.0;
            const SurfacePoint at = surface_point(scene, ray, *hit);
            const auto light = illumination(scene.lights.front(), at.position);
            if (!light || !(dot(facing(at.normal, convert<double>(ray.direction)), light->to_light) > 0)) return 0.0;
            structure.occluded(shadow_ray(at, *light, {}, ray, hit->t), traversal);
            return static_cast<double>(traversal.primitive_tests + traversal.box_tests);
        });
    };
    const std::vector<CostMap> maps{map(*make_accelerator("bvh", scene)),
                                    map(*light_buffer(Listing::conservative, 64, run).make(scene))};
    const double top = common_top(maps);
    return {heat_map(maps[0], "boxes and tests a shadow ray, tree", top),
            heat_map(maps[1], "tests a shadow ray, 64 x 64 cells", top)};
}

}  // namespace raylab::lantern
