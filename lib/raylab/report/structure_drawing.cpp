#include "raylab/report/structure_drawing.h"

#include "raylab/report/bound.h"
#include "raylab/report/plane_view.h"
#include "raylab/scene/needs.h"
#include "raylab/scene/scene_bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace raylab {

namespace {

constexpr const char *ink_of_shapes = "#555560", *ink_of_leaves = "#0072b2", *ink_of_ray = "#d55e00";

// Somewhat wider, so that what lies in its faces is seen.
Box with_margin(const Box& box) {
    const Vec3f margin = (box.max - box.min) * 0.04f;
    return {box.min - margin, box.max + margin};
}

Box space_shown(const Scene& scene, const StructureView& view, const Ray* ray) {
    if (view.shown) return *view.shown;
    Box box = scene_bounds(scene);
    if (box.is_empty()) box = {Vec3f(-1), Vec3f(1)};
    if (!ray) return with_margin(box);
    const Vec3f reach = box.max - box.min;  // as far as that from it a ray's origin is near
    const Box near{box.min - reach * 0.6f, box.max + reach * 0.6f};
    const Vec3f origin = glm::clamp(ray->origin, near.min, near.max);
    return with_margin(unite(box, {origin, origin}));
}

struct Drawn {
    PlaneView view;
    PlaneDrawing drawing;

    void figure(const std::optional<PlaneFigure>& shape, const PlaneStyle& style, const std::string& tooltip = {}) {
        if (shape) drawing.marks.push_back(PlaneDrawing::Figure{*shape, style, tooltip});
    }
};

Drawn empty_drawing(const Scene& scene, const StructureView& view, const Ray* ray) {
    const Box shown = space_shown(scene, view, ray);
    Drawn drawn{PlaneView(view.along, view.slice, shown), {.title = view.title}};
    const PlanePoint a = drawn.view.at(convert<double>(shown.min)), b = drawn.view.at(convert<double>(shown.max));
    drawn.drawing.low = {std::min(a.x, b.x), std::min(a.y, b.y)};
    drawn.drawing.high = {std::max(a.x, b.x), std::max(a.y, b.y)};
    drawn.drawing.width = view.width;
    drawn.drawing.height = view.height;
    return drawn;
}

// Calls at(object, part, place) for every primitive, places as a structure's outline counts them.
template <class At>
void for_each_primitive(const Scene& scene, const At& at) {
    std::uint32_t place = 0;
    for (const Object& object : scene.objects) {
        const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&object.shape);
        const std::size_t parts = mesh ? (*mesh)->faces.size() : 1;
        for (std::uint32_t part = 0; part < parts; ++part) at(object, part, place++);
    }
}

// All shapes, and those at `bold` places once more; where there are too many to be seen, only those.
void draw_shapes(Drawn& drawn, const Scene& scene, const StructureView& view, const std::set<std::uint32_t>& bold) {
    std::vector<PlaneDrawing::Figure> thin, thick;
    for_each_primitive(scene, [&](const Object& object, std::uint32_t part, std::uint32_t place) {
        const bool is_bold = bold.contains(place);
        if (!is_bold && thin.size() > view.most_shapes) return;
        for (const Wires& piece : wires_of(object.shape, part, object.placement))
            if (const auto figure = drawn.view.figure(piece))
                (is_bold ? thick : thin)
                    .push_back({*figure, {.line = is_bold ? "#000000" : ink_of_shapes, .width = is_bold ? 2.5 : 0.8}});
    });
    if (thin.size() > view.most_shapes) {
        thin.clear();
        drawn.drawing.notes.push_back(fmt::format("Of {} primitives only those tested are drawn.", primitive_count(scene)));
    }
    for (auto* figures : {&thin, &thick})
        for (auto& figure : *figures) drawn.drawing.marks.push_back(std::move(figure));
}

std::set<std::uint32_t> places_tested(const Outline& outline, const std::vector<Visit>& visits) {
    std::set<std::uint32_t> places;
    for (const Outline::Node& node : outline.nodes) {
        if (node.primitives.empty()) continue;
        const bool tested = std::ranges::any_of(visits, [&](const Visit& visit) {
            return visit.kind == Visit::Kind::leaf && visit.tests > 0 && same(visit.bound, node.bound);
        });
        if (tested) places.insert(node.primitives.begin(), node.primitives.end());
    }
    return places;
}

PlaneStyle style_of(Visit::Kind kind) {
    if (kind == Visit::Kind::inner) return {.line = "#8a8a92", .width = 1.2, .dash = PlaneStyle::Dash::dashed};
    if (kind == Visit::Kind::empty) return {.line = "#4a9cc8", .fill = "#eaf4fb", .width = 1.2, .dash = PlaneStyle::Dash::dotted};
    return {.line = ink_of_leaves, .fill = "#fdecc8", .width = 1.5};
}

// A visit's number stands beside the middle of the ray's way through it; an inner node has none.
void number_visit(Drawn& drawn, const Ray& ray, const Visit& visit, std::size_t number, double end) {
    const auto span = span_inside(ray, visit.bound);
    if (!span || visit.kind == Visit::Kind::inner) return;
    const Vec3d origin = convert<double>(ray.origin), direction = convert<double>(ray.direction);
    const double t = (span->min + std::max(span->min, std::min(span->max, end))) / 2;
    const PlanePoint way = drawn.view.at(direction);
    constexpr double letter = 8.5, away = 10;  // pixels
    const double length = std::max(std::hypot(way.x, way.y), 1e-30), side = way.x < 0 ? -away : away;
    drawn.drawing.marks.push_back(
        PlaneDrawing::Text{drawn.view.at(origin + direction * t), std::to_string(number), letter, "#000000", Anchor::center,
                           {-side * way.y / length, letter / 2 - side * way.x / length}});
}

// The cells that the ray does not come to, where there are few enough to be seen.
void draw_others(Drawn& drawn, const Outline& outline) {
    constexpr std::size_t most = 1500;
    if (outline.nodes.size() > most) return;
    for (const Outline::Node& node : outline.nodes)
        if (node.children.empty()) drawn.figure(drawn.view.figure(node.bound), {.line = "#d8d8de", .width = 0.8});
}

void draw_ray(Drawn& drawn, const Ray& ray, const std::optional<Hit>& hit) {
    const auto inside = span_inside(ray, drawn.view.shown());
    if (!inside) return;
    const auto at = [&](double t) {
        return drawn.view.at(convert<double>(ray.origin) + convert<double>(ray.direction) * t);
    };
    const double end = hit ? hit->t : inside->max;
    drawn.drawing.marks.push_back(PlaneDrawing::Arrow{at(inside->min), at(end), {.line = ink_of_ray, .width = 2.2}});
    if (hit) drawn.drawing.marks.push_back(PlaneDrawing::Dot{at(end), 4.5, "#000000"});
}

std::string leaf_color(std::size_t primitives, std::size_t most) {  // white to a middle blue
    const double share = most > 0 ? static_cast<double>(primitives) / static_cast<double>(most) : 0;
    const auto mix = [&](int full) { return static_cast<int>(255 + (full - 255) * (primitives > 0 ? 0.12 + 0.6 * share : 0)); };
    return fmt::format("#{:02x}{:02x}{:02x}", mix(0x00), mix(0x72), mix(0xb2));
}

}  // namespace

PlaneDrawing draw_structure(const Scene& scene, const Outline& outline, const StructureView& view) {
    Drawn drawn = empty_drawing(scene, view, nullptr);
    std::size_t most = 0, leaves = 0;
    for (const auto& node : outline.nodes) most = std::max(most, node.primitives.size());
    for (const auto& node : outline.nodes) {  // leaves below, so that no box hides another
        if (!node.children.empty()) continue;
        ++leaves;
        drawn.figure(drawn.view.figure(node.bound), {.line = ink_of_leaves, .fill = leaf_color(node.primitives.size(), most), .width = 1},
                     fmt::format("{} primitives {}", node.primitives.size(), node.label));
    }
    for (const auto& node : outline.nodes)
        if (!node.children.empty())
            drawn.figure(drawn.view.figure(node.bound), {.line = "#8a8a92", .width = 1, .dash = PlaneStyle::Dash::dashed}, node.label);
    draw_shapes(drawn, scene, view, {});
    drawn.drawing.notes.push_back(fmt::format("{} nodes, {} of them leaves; the darker, the more primitives (at most {})",
                                              outline.nodes.size(), leaves, most));
    return drawn.drawing;
}

PlaneDrawing draw_ray_through(const Scene& scene, const Accelerator& structure, const Ray& ray, const StructureView& view) {
    Drawn drawn = empty_drawing(scene, view, &ray);
    const auto visits = structure.visits(ray);
    const Outline outline = structure.outline();
    Traversal traversal;
    const auto hit = structure.closest(ray, traversal);
    draw_others(drawn, outline);
    for (const Visit& visit : visits)
        drawn.figure(drawn.view.figure(visit.bound), style_of(visit.kind), fmt::format("{}, {} tests", words(visit.bound), visit.tests));
    draw_shapes(drawn, scene, view, places_tested(outline, visits));
    draw_ray(drawn, ray, hit);
    const double end = hit ? hit->t : std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < std::min(visits.size(), view.most_numbers); ++i) number_visit(drawn, ray, visits[i], i + 1, end);
    drawn.drawing.notes.push_back(fmt::format("{} visits in the order of their numbers, {} primitive tests", visits.size(),
                                              traversal.primitive_tests));
    drawn.drawing.notes.push_back("solid: with tests; dotted: empty; dashed: inner node; bold: what was tested");
    return drawn.drawing;
}

}  // namespace raylab
