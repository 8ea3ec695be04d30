#include "section.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/image/color.h"
#include "raylab/report/plane/plane_view.h"
#include "raylab/report/ray_tree/ray_tree_style.h"
#include "raylab/scene/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab::recursion {

namespace {

constexpr double letters = 12;  // the height of a capital, in pixels
const Box everywhere{{-30, -30, -30}, {30, 30, 30}};

PlanePoint on_plane(const Vec3d& p) { return {p.x, p.y}; }

// The colour of a shape's inside: its material's, pale, since rays are drawn over it.
std::string pale(const Material& material) {
    if (material.kt > 0) return "#e3f1fb";
    const auto* diffuse = std::get_if<Color>(&material.diffuse);
    const Color color = glm::mix(diffuse ? *diffuse : Color{1, 1, 1}, Color{1, 1, 1}, 0.4);
    return fmt::format("#{:02x}{:02x}{:02x}", srgb_byte(color.x), srgb_byte(color.y), srgb_byte(color.z));
}

void add_name(PlaneSketch& sketch, PlanePoint at, const std::string& name, Anchor anchor, Point2 aside) {
    sketch.words(at, name, {.aside = aside, .anchor = anchor, .height = letters, .halo = {}});
}

void add_shape(PlaneSketch& sketch, const Object& object, const Material& material) {
    const PlaneView view(2, 0.0, everywhere);
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        const PlanePoint center = on_plane(convert<double>(sphere->center));
        sketch.circle(center, double{sphere->radius}, {.line = "#444444", .fill = pale(material), .width = 2});
        const double aside = 0.3 * double{sphere->radius};
        add_name(sketch, {center.x - aside, center.y + aside}, material.name, Anchor::center, {0, letters / 2});
        return;
    }
    for (const Wires& piece : wires_of(object.shape, 0, object.placement))
        if (const auto figure = view.figure(piece)) {
            sketch.add(*figure, {.line = "#444444", .width = 4});
            const auto& corners = std::get<PlanePolygon>(*figure).corners;
            add_name(sketch, corners.front(), material.name, Anchor::left, {12, 20});
        }
}

void add_light(PlaneSketch& sketch, const Light& light) {
    const auto* point = std::get_if<PointLight>(&light.kind);
    if (!point) return;
    const PlanePoint at = on_plane(point->position);
    sketch.light(at);
    add_name(sketch, at, "light", Anchor::left, {14, letters / 2});
}

// Where a ray of the tree ends: at its hit, at a shadow ray's obstacle or light, or in the air.
PlanePoint end_of(const RayNode& node, const Scene& scene, const Accelerator& accelerator, double reach) {
    if (node.ended == Ending::missed)
        return on_plane(convert<double>(node.ray.origin) + reach * convert<double>(node.ray.direction));
    if (node.kind != RayKind::shadow) return on_plane(node.point);
    if (node.ended == Ending::reached) return on_plane(std::get<PointLight>(scene.lights[node.light].kind).position);
    Traversal traversal;
    const auto obstacle = accelerator.closest(node.ray, traversal);
    return on_plane(convert<double>(node.ray.origin) + obstacle->t * convert<double>(node.ray.direction));
}

// A ray's number stands on its middle, beside it where the ray is short.
void add_number(PlaneSketch& sketch, std::size_t number, PlanePoint from, PlanePoint to, const std::string& color) {
    const Point2 way{to.x - from.x, to.y - from.y};
    const double length = std::hypot(way.x, way.y), pixels = length < 1 ? 15 / length : 0;
    sketch.words({(from.x + to.x) / 2, (from.y + to.y) / 2}, "**" + std::to_string(number) + "**",
                 {.aside = {pixels * way.y, letters / 2 + pixels * way.x},
                  .anchor = Anchor::center,
                  .color = color,
                  .height = letters + 1});
}

}  // namespace

RayTree section_tree(const Scene& scene) { return section_tree_towards(scene, scene.camera.target); }

RayTree section_tree_towards(Scene scene, const Vec3d& target) {
    scene.camera.target = target;
    const auto accelerator = make_accelerator("list", scene);
    const CameraFrame frame = camera_frame(scene.camera, scene.image, scene.source);
    return ray_tree(scene, *accelerator, {.depth = 4, .threshold = 0.05},
                    eye_ray(frame, scene.image.width / 2.0, scene.image.height / 2.0));
}

PlaneStyle style_of(RayKind kind) {
    const RayStrokes strokes = strokes_of(kind);
    const auto dash = kind == RayKind::shadow        ? PlaneStyle::Dash::dotted
                      : kind == RayKind::transmitted ? PlaneStyle::Dash::dashed
                                                     : PlaneStyle::Dash::solid;
    return {.line = strokes.color, .width = 2.5, .dash = dash};
}

std::string word_for(const Scene& scene, const RayNode& node) {
    if (node.kind == RayKind::shadow) return node.ended == Ending::reached ? "lit" : "blocked";
    if (node.ended == Ending::missed) return "sky";
    if (!was_cast(node)) return "cut";
    const auto hit =
        std::ranges::find_if(scene.objects, [&](const Object& object) { return object.path == node.object; });
    return scene.materials[hit->front].name;
}

void add_section(PlaneSketch& sketch, const Scene& scene) {
    for (const Object& object : scene.objects) add_shape(sketch, object, scene.materials[object.front]);
    for (const Light& light : scene.lights) add_light(sketch, light);
    const PlanePoint eye = on_plane(scene.camera.position);
    sketch.dot(eye, 6, "#000000");
    add_name(sketch, eye, "eye", Anchor::center, {0, -letters});
}

void add_rays(PlaneSketch& sketch, const Scene& scene, const RayTree& tree, const std::vector<std::size_t>& nodes,
              double reach) {
    const auto accelerator = make_accelerator("list", scene);
    for (const std::size_t i : nodes) {
        const RayNode& node = tree.nodes[i];
        if (!was_cast(node)) continue;
        const PlanePoint from = on_plane(convert<double>(node.ray.origin)),
                         to = end_of(node, scene, *accelerator, reach);
        sketch.arrow(from, to, style_of(node.kind));
        if (node.ended == Ending::blocked)
            sketch.words(to, "**×**", {.aside = {0, 7}, .anchor = Anchor::center, .color = "#b00000", .height = 15});
        add_number(sketch, i + 1, from, to, style_of(node.kind).line);
    }
}

PlaneDrawing section_with_rays(const Scene& scene, const RayTree& tree, const std::vector<std::size_t>& nodes) {
    PlaneSketch sketch;
    add_section(sketch, scene);
    add_rays(sketch, scene, tree, nodes, 1.5);
    return {
        .title = "", .low = {-4.4, -0.35}, .high = {3.7, 4.65}, .width = 420, .height = 275, .marks = sketch.marks()};
}

}  // namespace raylab::recursion
