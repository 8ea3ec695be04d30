#include "painting.h"

#include "raylab/accelerator/split_tree/kd_tree.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/structure/structure_workload.h"
#include "raylab/image/draw.h"
#include "raylab/image/to_pixel.h"
#include "raylab/report/plane/plane_perspective.h"
#include "raylab/tracer/shading/surface_point.h"

#include <fmt/format.h>

#include <array>

namespace raylab::split {

namespace {

// From a to b, as wide as `across`: two triangles.
Mesh beam(const Vec3f& a, const Vec3f& b, const Vec3f& across) {
    return {.vertices = {a - across, b - across, b + across, a + across}, .faces = {{0, 1, 2}, {0, 2, 3}}};
}

constexpr std::array colors{"#0072b2", "#e69f00", "#009e73"};

}  // namespace

Scene beams() {
    Scene scene;
    scene.source = "beams";
    scene.image = {640, 480};
    scene.camera = {.position = {0.2, 0.1, 5}, .target = {0, 0.05, 0}, .up = {0, 1, 0}, .projection = Perspective{40}};
    scene.background.color = {0.93, 0.93, 0.91};
    const std::array<Vec3f, 3> corners{Vec3f{-1.1f, -0.8f, 0}, {1.1f, -0.8f, 0}, {0, 1.1f, 0}};
    const std::array<Color, 3> paint{Color{0, 0.17, 0.45}, {0.79, 0.35, 0}, {0, 0.34, 0.17}};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3f from = corners[i], to = corners[(i + 1) % 3], beyond = (to - from) * 0.22f;
        const Vec3f lift{0, 0, 0.5f};  // the beam is nearer to the eye at its beginning, farther at its end
        const Vec3f across = glm::normalize(Vec3f{from.y - to.y, to.x - from.x, 0}) * 0.17f;
        scene.objects.push_back(
            {.shape = std::make_shared<const Mesh>(beam(from - beyond + lift, to + beyond - lift, across)),
             .front = i,
             .back = i});
        scene.materials.push_back({.name = colors[i], .diffuse = paint[i]});
    }
    return scene;
}

Scene knot(int width) {
    Scene scene = mesh_scene(std::make_shared<const Mesh>(trefoil_knot(0.45, 4)), "knot");
    scene.image = {width, 3 * width / 4};
    scene.background.color = {0.93, 0.93, 0.91};
    scene.materials = {{.name = "rope", .diffuse = Color{0.79, 0.35, 0.1}}};
    scene.camera.position = {2, 3, 11};
    return scene;
}

CameraFrame frame_of(const Scene& scene) { return camera_frame(scene.camera, scene.image, scene.source); }

Image shaded(const Scene& scene, const PaintedPicture& painted) {
    const CameraFrame frame = frame_of(scene);
    Image image(painted.width, painted.height);
    for (int y = 0; y < painted.height; ++y) {
        for (int x = 0; x < painted.width; ++x) {
            const auto& hit = painted.seen[static_cast<std::size_t>(y * painted.width + x)];
            image.at(x, y) = to_pixel(scene.background.color);
            if (!hit) continue;
            const Ray ray = eye_ray(frame, x + 0.5, y + 0.5);
            const SurfacePoint point = surface_point(scene, ray, *hit);
            const Vec3d direction = convert<double>(ray.direction);
            const double turned = std::abs(dot(point.normal, direction)) / glm::length(direction);
            image.at(x, y) = to_pixel(diffuse_color(scene, point, direction) * (0.15 + 0.85 * turned));
        }
    }
    return image;
}

Image after_quarters(const Scene& scene, const PaintersTree& tree, std::size_t quarters) {
    const std::size_t count = tree.pieces() * quarters / 4;
    return with_caption(shaded(scene, paint(tree, frame_of(scene), count)),
                        fmt::format("{} of {} pieces", count, tree.pieces()), 14);
}

std::size_t wrong_pixels(const Scene& scene, const PaintedPicture& painted) {
    const KdTree tracer(scene);
    const CameraFrame frame = frame_of(scene);
    std::size_t wrong = 0;
    Traversal traversal;
    for (int y = 0; y < painted.height; ++y) {
        for (int x = 0; x < painted.width; ++x) {
            const auto truth = tracer.closest(eye_ray(frame, x + 0.5, y + 0.5), traversal);
            const auto& given = painted.seen[static_cast<std::size_t>(y * painted.width + x)];
            const bool same = truth.has_value() == given.has_value() &&
                              (!truth || (truth->primitive == given->primitive && truth->t == given->t));
            wrong += !same;
        }
    }
    return wrong;
}

PlaneDrawing draw_pieces(const Scene& scene, const PaintersTree& tree) {
    const CameraFrame frame = frame_of(scene);
    const double up = frame.half_height, right = frame.half_width;
    const PlanePerspective seen(frame);
    PlaneDrawing drawing{.title = "", .low = {-right, -up}, .high = {right, up}, .width = 640, .height = 480};
    std::vector<PlaneDrawing::Text> numbers;
    for (const auto& turn : tree.back_to_front(eye_ray(frame, 0, 0).origin)) {
        PlanePolygon outline;
        Point2 middle{0, 0};
        const auto& corners = turn.piece->corners;
        for (const Vec3d& corner : corners) {
            const PlanePoint at = seen.at(corner);
            outline.corners.push_back(at);
            middle = {middle.x + at.x / static_cast<double>(corners.size()),
                      middle.y + at.y / static_cast<double>(corners.size())};
        }
        const std::size_t color = tree.triangle(turn.piece->triangle).primitive.object % colors.size();
        drawing.marks.push_back(
            PlaneDrawing::Figure{outline, {.line = "#222222", .fill = colors[color], .width = 1.5}});
        numbers.push_back({middle, std::to_string(numbers.size() + 1), 14, "#000000", Anchor::center});
    }
    for (const auto& number : numbers) drawing.marks.push_back(number);
    return drawing;
}

std::vector<std::string> painter_header() {
    return {
        "scene",        "triangles",    "pieces", "nodes deep", "pixels", "wrong, by distance", "wrong, by the tree",
        "painted over", "tests a pixel"};
}

std::vector<std::vector<std::string>> painter_rows(const std::vector<Scene>& scenes) {
    std::vector<std::vector<std::string>> rows;
    for (const Scene& scene : scenes) {
        const PaintersTree tree(scene);
        const auto painted = paint(tree, frame_of(scene));
        const std::size_t pixels = painted.seen.size(),
                          shown = static_cast<std::size_t>(
                              std::ranges::count_if(painted.seen, [](const auto& hit) { return hit.has_value(); }));
        rows.push_back({scene.source, std::to_string(tree.triangles()), std::to_string(tree.pieces()),
                        std::to_string(tree.depth()), std::to_string(pixels),
                        std::to_string(wrong_pixels(scene, paint_by_distance(tree, frame_of(scene)))),
                        std::to_string(wrong_pixels(scene, painted)),
                        fmt::format("{:.2f} times", static_cast<double>(painted.painted - shown) /
                                                        static_cast<double>(std::max<std::size_t>(1, shown))),
                        fmt::format("{:.1f}", static_cast<double>(painted.tests) / static_cast<double>(pixels))});
    }
    return rows;
}

}  // namespace raylab::split
