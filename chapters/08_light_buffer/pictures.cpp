#include "pictures.h"

#include "light_methods.h"

#include "raylab/accelerator/light_buffer/light_pyramid.h"
#include "raylab/image/draw.h"
#include "raylab/report/plane/plane_view.h"
#include "raylab/report/structure/structure_drawing.h"
#include "raylab/report/structure/structure_heat_map.h"
#include "raylab/tracer/picture/whitted_picture.h"
#include "raylab/tracer/shading/ray_start.h"

#include <fmt/format.h>

#include <array>
#include <numbers>

namespace raylab::lantern {

namespace {

constexpr ImageSize small{320, 220};  // of pictures that stand side by side

Vec3d light_of(const Scene& scene) { return std::get<PointLight>(scene.lights.front().kind).position; }

Image traced(const Scene& scene, const LightBufferOptions& options, const ChapterRun& run, int per_side) {
    const LightBuffered structure(make_accelerator("auto", scene), scene, options);
    return whitted_picture(
        scene, structure, camera_frame(scene.camera, scene.image, scene.source), {},
        {.samples = {SamplePattern::jittered, per_side, run.seed}, .threads = run.threads, .label = "rays"});
}

// The cube unfolded to a cross: the back wall's face in the middle of a row of four, the upper and the lower one above
// and below it.
struct Cross {
    static constexpr int side = 128;  // pixels of a face
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

LightBuffer buffer_of(const Scene& scene, int resolution) {
    return LightBuffer(scene, light_of(scene), {.resolution = resolution});
}

// The cell that draw_cell() shows: of a coarse cube, from the foot of the wall past the sphere and a bar of the cage.
constexpr int coarse = 8;
const Vec3d shown_point{-2, 0.25, -1.22};

}  // namespace

Image shaded(const Scene& scene, const ChapterRun& run) {
    return traced(scene, {.resolution = 64}, run, run.sized(2, 1));
}

Image shaded_by_centers(const Scene& scene, int resolution, const ChapterRun& run) {
    Scene smaller = scene;
    smaller.image = small;
    return with_caption(traced(smaller, {resolution, Listing::centers}, run, run.sized(2, 1)),
                        fmt::format("6 x {0} x {0} cells by their centres", resolution));
}

Image seen_by_light(const Scene& scene, const ChapterRun& run) {
    const auto accelerator = make_accelerator("auto", scene);
    Image image(Cross::width, Cross::height);
    for_each_tile(image.width(), image.height(), run.threads, "", [&](Tile tile) {
        Traversal traversal;
        fill(image, tile, [&](int x, int y) -> Color {
            const auto direction = Cross::direction(x + 0.5, y + 0.5);
            if (!direction) return {0, 0, 0};
            return whitted_color(scene, *accelerator, {}, {convert<float>(light_of(scene)), convert<float>(*direction)},
                                 traversal);
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

PlaneDrawing draw_cell(const Scene& scene) {
    const Vec3d light = light_of(scene);
    const Box shown{{-2.15f, 0, -2.15f}, {1.2f, 3, 1.2f}};
    PlaneDrawing drawing =
        draw_structure(scene, {}, {.title = "", .along = 1, .shown = shown, .width = 640, .height = 640});
    const PlaneView view(1, {}, shown);
    const LightCell cell = light_cell(shown_point - light, coarse);
    const int across = cell.face / 2 == 0 ? cell.row : cell.column;  // not along y, the direction of the view
    // A point of that border of the cell, at this depth from the light.
    const auto at = [&](double border, double depth) {
        const double s = 2 * border / coarse - 1;
        return view.at(light + (cell.face / 2 == 0 ? LightPyramid{cell.face}.vector(0, s, 1)
                                                   : LightPyramid{cell.face}.vector(s, 0, 1)) *
                                   depth);
    };
    drawing.notes.clear();
    std::vector<PlaneDrawing::Mark> below;
    below.push_back(PlaneDrawing::Figure{PlanePolygon{{view.at(light), at(across, 2), at(across + 1.0, 2)}},
                                         {.line = "#e69f00", .fill = "#fdecc8", .width = 1.5}});
    for (int face : {0, 1, 4, 5})
        for (int line = 0; line <= coarse; ++line) {
            const double s = 2.0 * line / coarse - 1;
            const bool along_x = face < 2;
            const Vec3d way = along_x ? Vec3d{face == 0 ? 1 : -1, 0, s} : Vec3d{s, 0, face == 4 ? 1 : -1};
            below.push_back(PlaneDrawing::Figure{PlanePolygon{{view.at(light), view.at(light + way * 2.3)}},
                                                 {.line = "#c8c8d0", .width = 0.7}});
        }
    drawing.marks.insert(drawing.marks.begin(), below.begin(), below.end());
    drawing.marks.push_back(
        PlaneDrawing::Figure{PlanePolygon{{at(0, 0.6), at(coarse, 0.6)}}, {.line = "#0072b2", .width = 2}});
    drawing.marks.push_back(PlaneDrawing::Arrow{view.at(shown_point), view.at(light), {.line = "#d55e00", .width = 2}});
    drawing.marks.push_back(PlaneDrawing::Dot{view.at(light), 5, "#d55e00"});
    drawing.marks.push_back(PlaneDrawing::Text{.at = view.at(light), .words = "L", .height = 14, .aside = {10, 28}});
    drawing.marks.push_back(
        PlaneDrawing::Text{.at = view.at(shown_point), .words = "P", .height = 14, .aside = {-22, 7}});
    return drawing;
}

std::vector<std::string> cell_header() { return {"primitive", "depth at least [m]"}; }

std::vector<std::vector<std::string>> cell_rows(const Scene& scene) {
    const LightBuffer buffer = buffer_of(scene, coarse);
    std::vector<std::vector<std::string>> rows;
    const LightCell cell = light_cell(shown_point - light_of(scene), coarse);
    for (const auto& [primitive, depth] : buffer.list(cell))
        rows.push_back({scene.objects[buffer.primitive(primitive).object].path, fmt::format("{:.3f}", depth)});
    const auto& cover = buffer.cover(cell);
    if (cover.primitive != LightLists::Cover::none)
        rows.push_back(
            {fmt::format("(behind {}: shadow)", scene.objects[buffer.primitive(cover.primitive).object].path),
             fmt::format("{:.3f}", cover.depth)});
    return rows;
}

Image shadow_ray_costs(const Scene& scene, const ChapterRun& run) {
    const auto eye = make_accelerator("auto", scene);
    const CameraFrame frame = camera_frame(scene.camera, small, scene.source);
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
    return side_by_side({heat_map(maps[0], "boxes and tests a shadow ray, tree", top),
                         heat_map(maps[1], "tests a shadow ray, 64 x 64 cells", top)});
}

}  // namespace raylab::lantern
