#include "drawings.h"

#include "shown_cell.h"

#include "raylab/report/plane/plane_perspective.h"
#include "raylab/report/plane/plane_sketch.h"
#include "raylab/report/structure/structure_drawing.h"
#include "raylab/scene/scene_bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace raylab::lantern {

namespace {

using namespace plane_ink;

// Where a way from the light inside the room ends: on a wall, the floor or the ceiling.
Vec3d end_in_room(const Vec3d& light, const Vec3d& way, const Box& room) {
    double end = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double wall = way[axis] < 0 ? room.min[axis] : room.max[axis];
        if (way[axis] != 0) end = std::min(end, (wall - light[axis]) / way[axis]);
    }
    return light + way * end;
}

// Points of a cell's border at depth 1, all around.
std::vector<Vec3d> border_of(const LightPyramid& pyramid) {
    constexpr int pieces = 24;
    const auto corners = pyramid.corners();
    std::vector<Vec3d> points;
    for (std::size_t i = 0; i < 4; ++i)
        for (int k = 0; k < pieces; ++k)
            points.push_back(glm::mix(corners[i], corners[(i + 1) % 4], static_cast<double>(k) / pieces));
    return points;
}

// Space in perspective.
class SpaceSketch : public PlaneSketch {
public:
    explicit SpaceSketch(const CameraFrame& frame) : view_(frame) {}

    void polygon_in_space(const std::vector<Vec3d>& corners, const PlaneStyle& style) {
        std::vector<PlanePoint> seen;
        for (const Vec3d& corner : corners) seen.push_back(view_.at(corner));
        polygon(seen, style);
    }
    void line_in_space(const Vec3d& from, const Vec3d& to, const PlaneStyle& style) {
        line(view_.at(from), view_.at(to), style);
    }
    const PlanePerspective& view() const { return view_; }

    /// The room's walls first, then what it holds, the nearer the later.
    void add_objects(const Scene& scene) {
        std::vector<const Object*> objects;
        for (const Object& object : scene.objects) objects.push_back(&object);
        const auto key = [&](const Object* object) {
            const Box box = bounds(object->shape, object->placement).value();
            return std::pair(!is_wall(*object), -view_.depth(box.center()));
        };
        std::ranges::stable_sort(objects, {}, key);
        for (const Object* object : objects) add_object(*object);
    }

private:
    static bool is_wall(const Object& object) { return object.path.starts_with("polygon"); }

    void add_object(const Object& object) {
        const bool is_flat = std::holds_alternative<Polygon>(object.shape);
        PlaneStyle style{.line = "#55555f", .fill = is_flat ? "" : "#ffffff", .width = 1.2};
        if (is_wall(object)) style = {.line = "#b8b8c0", .fill = pale_grey, .width = 1.5};
        for (const Wires& piece : wires_of(object.shape, 0, object.placement))
            if (const auto outline = view_.figure(piece)) add(*outline, style);
    }

    PlanePerspective view_;
};

}  // namespace

PlaneDrawing draw_cube(const Scene& scene) {
    constexpr double size = 0.62;  // half the cube's side; it is for the eye, since only directions count
    constexpr ImageSize pixels{960, 600};
    Camera camera = scene.camera;
    camera.position = {2.3, 2.5, 3.3};
    camera.target = {-0.62, 0.92, -0.42};
    std::get<Perspective>(camera.projection).fov_y *= 0.78;
    const CameraFrame frame = camera_frame(camera, pixels, scene.source);
    const Vec3d light = light_of(scene);
    const LightPyramid cell = shown_pyramid(scene);
    const Box room = scene_bounds(scene);

    SpaceSketch sketch(frame);
    sketch.add_objects(scene);
    std::vector<Vec3d> patch, on_face;
    for (const Vec3d& way : border_of(cell)) patch.push_back(end_in_room(light, way, room));
    for (const Vec3d& way : cell.corners()) on_face.push_back(light + way * size);
    sketch.polygon_in_space(patch, {.line = orange, .width = 2.5});
    for (const Vec3d& way : cell.corners())
        sketch.line_in_space(light, end_in_room(light, way, room), {.line = orange, .width = 1.5});
    for (const int face : {1, 5})
        for (int i = 0; i <= coarse; ++i) {
            const double s = 2.0 * i / coarse - 1;
            const auto at = [&](double u, double v) { return light + LightPyramid{face}.vector(u, v, 1) * size; };
            sketch.line_in_space(at(s, -1), at(s, 1), {.line = "#8fc1de", .width = 1});
            sketch.line_in_space(at(-1, s), at(1, s), {.line = "#8fc1de", .width = 1});
        }
    const auto corner = [&](int i) { return light + Vec3d{i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1} * size; };
    for (int i = 0; i < 8; ++i)
        for (const int bit : {1, 2, 4})
            if (!(i & bit)) sketch.line_in_space(corner(i), corner(i | bit), {.line = blue, .width = 2});
    sketch.polygon_in_space(on_face, {.line = vermilion, .fill = "#ffd9a0", .width = 2});
    const auto seen = [&](const Vec3d& point) { return sketch.view().at(point); };
    sketch.arrow(seen(shown_point), seen(light), {.line = vermilion, .width = 2.5});
    sketch.dot(seen(light), 6, vermilion);
    sketch.dot(seen(shown_point), 5);
    sketch.words(seen(light), "**L**", {.aside = {14, 22}, .height = 13});
    sketch.words(seen(shown_point), "**P**", {.aside = {-14, 8}, .anchor = Anchor::right, .height = 13});
    sketch.words(seen(corner(6)), "face −x", {.aside = {8, 26}, .color = blue, .height = 14});
    sketch.words(seen(corner(3)), "face −z", {.aside = {-8, 26}, .anchor = Anchor::right, .color = blue, .height = 14});
    return {.low = {-frame.half_width, -frame.half_height},
            .high = {frame.half_width, frame.half_height},
            .width = pixels.width,
            .height = pixels.height,
            .marks = sketch.marks()};
}

PlaneDrawing draw_column(const Scene& scene) {
    const Vec3d d = shown_point - light_of(scene);
    const double w = -d.x, u = d.y;  // the face is -x, and its columns go along y
    PlaneSketch sketch;
    for (int i = 0; i <= coarse; ++i) {
        const double s = 2.0 * i / coarse - 1;
        sketch.line({0, 0}, {1, s}, {.line = light_grey});
        sketch.line({0.97, s}, {1.03, s}, {.line = blue, .width = 1.5});
        if (i < coarse)
            sketch.words({1, s + 1.0 / coarse}, std::to_string(i), {.aside = {12, 5}, .color = blue, .height = 10});
    }
    sketch.line({1, -1}, {1, 1}, {.line = blue, .width = 2.5});
    sketch.path({{0, 0}, {w, 0}, {w, u}}, {.line = grey, .width = 1.5, .dash = dashed});
    sketch.line({1, 0}, {1, u / w}, {.line = vermilion, .width = 4});
    sketch.arrow({0, 0}, {w, u}, {.line = vermilion, .width = 2.2});
    sketch.dot({0, 0}, 5, vermilion);
    sketch.dot({1, u / w}, 4.5);
    sketch.dot({w, u}, 4.5);
    sketch.words({0, 0}, "**L**", {.aside = {-24, 6}});
    sketch.words({w, u}, "**P**", {.aside = {10, 8}});
    sketch.words({0.78 * w, 0.78 * u}, "**d** = **P** − **L**", {.aside = {-6, 30}, .anchor = Anchor::right});
    sketch.words({0.75 * w, 0}, fmt::format("*w* = {:g}", w), {.aside = {0, -9}, .anchor = Anchor::center});
    sketch.words({w, u / 2}, fmt::format("*u* = −{:g}", -u), {.aside = {8, 0}});
    sketch.words({1, u / w}, fmt::format("*u* / *w* = −{:g}", -u / w), {.aside = {-12, 30}, .anchor = Anchor::right});
    sketch.words({1, 1}, "+1", {.aside = {0, -10}, .anchor = Anchor::center});
    sketch.words({1, -1}, "−1", {.aside = {0, 22}, .anchor = Anchor::center});
    sketch.words({1, 1}, "the face, at depth 1", {.aside = {44, 4}, .color = blue});
    return {.low = {-0.35, -1.4}, .high = {2.5, 1.25}, .width = 960, .height = 520, .marks = sketch.marks()};
}

PlaneDrawing draw_list(const Scene& scene) {
    const Vec3d light = light_of(scene);
    const LightPyramid cell = shown_pyramid(scene);
    const Box shown{{-2.2f, 0, -1.75f}, {0.42f, 3, 0.2f}};
    const PlaneView view(1, {}, shown);
    // From above a face's cells are seen by their rows alone.
    const auto at = [&](double v, double depth) { return view.at(light + cell.vector(0, v, 1) * depth); };
    const double far = light.x - scene_bounds(scene).min.x;
    PlaneSketch sketch;
    sketch.polygon({view.at(light), at(cell.v_min, far), at(cell.v_max, far)},
                   {.line = orange, .fill = pale_orange, .width = 1.5});
    for (int i = 0; i <= coarse; ++i) sketch.line(view.at(light), at(2.0 * i / coarse - 1, 2.4), {.line = light_grey});
    PlaneDrawing drawing =
        draw_structure(scene, {}, {.title = "", .along = 1, .shown = shown, .width = 960, .height = 675});
    sketch.add(drawing.marks);
    sketch.line(at(-1, 0.62), at(1, 0.62), {.line = blue, .width = 2.5});
    sketch.words(at(-0.95, 0.62), "face −x, from above", {.aside = {10, 4}, .color = blue, .height = 14});
    sketch.arrow(view.at(shown_point), view.at(light), {.line = vermilion, .width = 2.5});
    const LightBuffer buffer = buffer_of(scene, coarse);
    const std::array<PlaneWords, 4> beside{{{.aside = {30, -22}, .anchor = Anchor::left, .height = 13},
                                            {.aside = {0, 26}, .anchor = Anchor::center, .height = 13},
                                            {.aside = {4, 26}, .height = 13},
                                            {.aside = {4, -14}, .height = 13}}};
    std::size_t place = 0;
    for (const auto& [primitive, depth] : buffer.list(shown_cell(scene))) {
        const bool is_above = place == 0 || place == 3;
        const PlanePoint above = at(cell.v_min - 0.06, depth), below = at(cell.v_max + 0.06, depth);
        const std::string name = plain_name(scene, buffer, primitive);
        const PlaneWords& how = beside.at(place);
        const PlaneDrawing::Data nth{{"visit", std::to_string(place + 1)}};  // the page steps through the list
        sketch.add(PlaneDrawing::Figure{PlanePolygon{{above, below}},
                                        {.width = 2.5, .dash = dotted},
                                        fmt::format("{}, from depth {:.3f} m on", name, depth),
                                        nth});
        sketch.add(PlaneDrawing::Text{.at = is_above ? above : below,
                                      .words = fmt::format("{}: {}", place + 1, name),
                                      .height = how.height,
                                      .color = how.color,
                                      .anchor = how.anchor,
                                      .aside = how.aside,
                                      .halo = how.halo,
                                      .data = nth});
        ++place;
    }
    sketch.dot(view.at(light), 6, vermilion);
    sketch.dot(view.at(shown_point), 5);
    sketch.words(view.at(light), "**L**", {.aside = {14, 24}, .height = 13});
    sketch.words(view.at(shown_point), "**P**", {.aside = {-12, 6}, .anchor = Anchor::right, .height = 13});
    drawing.notes.clear();
    drawing.marks = sketch.marks();
    return drawing;
}

namespace {

// A cell from above, its light at the origin, opening to the left.
constexpr PlanePoint light{0, 0};
constexpr std::array<PlanePoint, 2> cell_corners{{{-1, 0.25}, {-1, 0.5}}};

void add_cell(PlaneSketch& sketch) {
    std::vector<PlanePoint> pyramid{light};
    for (const PlanePoint corner : cell_corners) pyramid.push_back({2.2 * corner.x, 2.2 * corner.y});
    sketch.polygon(pyramid, {.line = orange, .fill = pale_orange, .width = 1.5});
    sketch.line({-1, -0.9}, {-1, 0.9}, {.line = blue, .width = 2.5});
    for (const PlanePoint corner : cell_corners) sketch.dot(corner, 4.5, orange);
    sketch.words(cell_corners[0], "**c**_{1}", {.aside = {12, -3}});
    sketch.words(cell_corners[1], "**c**_{2}", {.aside = {10, -12}});
}

}  // namespace

PlaneDrawing draw_separating_plane() {
    const std::array<PlanePoint, 3> triangle{{{-1.9, -0.05}, {-1.2, 0.12}, {-1.45, -0.75}}};
    constexpr double slope = -0.165;  // of the plane, seen edge-on
    const PlanePoint start{-0.5, -0.5 * slope}, end{start.x + 0.4 * slope, start.y - 0.4};
    PlaneSketch sketch;
    add_cell(sketch);
    sketch.polygon({triangle.begin(), triangle.end()}, {.line = grey, .fill = pale_blue, .width = 2});
    sketch.line({-2.3, -2.3 * slope}, {0.9, 0.9 * slope}, {.width = 2, .dash = dashed});
    sketch.arrow(start, end, {.width = 2});
    sketch.dot(light, 6, vermilion);
    for (const PlanePoint corner : triangle) sketch.dot(corner, 4.5, grey);
    sketch.words(light, "**L**", {.aside = {-4, 24}});
    sketch.words(end, "**n**", {.aside = {10, 4}});
    sketch.words(triangle[0], "**p**_{1}", {.aside = {-8, 22}, .anchor = Anchor::right});
    sketch.words(triangle[1], "**p**_{2}", {.aside = {10, 14}});
    sketch.words(triangle[2], "**p**_{3}", {.aside = {10, 14}});
    sketch.words({0.15, 0.08}, "**n** · **x** < 0");
    sketch.words({0.15, -0.3}, "**n** · **x** > 0");
    return {.low = {-2.3, -0.95}, .high = {0.95, 1.1}, .width = 520, .height = 350, .marks = sketch.marks()};
}

PlaneDrawing draw_fifth_plane() {
    const PlanePoint low{0.65, -0.9}, high{0.65, 0.9};
    PlaneSketch sketch;
    add_cell(sketch);
    for (const PlanePoint corner : cell_corners)
        sketch.line(light, {-1.4 * corner.x, -1.4 * corner.y}, {.line = orange, .width = 1.5, .dash = dotted});
    sketch.line(low, high, {.line = grey, .width = 5});
    sketch.line({0, -1.05}, {0, 1.05}, {.width = 2, .dash = dashed});
    sketch.dot(light, 6, vermilion);
    sketch.dot(low, 4.5, grey);
    sketch.dot(high, 4.5, grey);
    sketch.words(light, "**L**", {.aside = {8, -10}});
    sketch.words(high, "**p**_{1}", {.aside = {12, 4}});
    sketch.words(low, "**p**_{2}", {.aside = {12, 4}});
    sketch.words({0, -0.95}, "*w* = 0", {.aside = {8, 6}});
    sketch.words({0, -0.95}, "in front: *w* > 0", {.aside = {-10, 6}, .anchor = Anchor::right});
    sketch.words({0.65, 0.35}, "a wall behind", {.aside = {12, 4}});
    return {.low = {-1.6, -1.0}, .high = {1.5, 1.05}, .width = 520, .height = 350, .marks = sketch.marks()};
}

}  // namespace raylab::lantern
