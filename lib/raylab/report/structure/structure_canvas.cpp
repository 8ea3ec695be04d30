#include "raylab/report/structure/structure_canvas.h"

#include "raylab/geometry/shape_parts.h"
#include "raylab/report/structure/bound.h"
#include "raylab/scene/needs.h"
#include "raylab/scene/scene_bounds.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

namespace {

constexpr const char* ink_of_shapes = "#555560";

// The box is slightly enlarged, so that shapes in its faces are visible.
Box with_margin(const Box& box) {
    const Vec3f margin = (box.max - box.min) * 0.04f;
    return {box.min - margin, box.max + margin};
}

// The box about the scene, its bounds and the ray's origin; bounds that reach far beyond the scene are cut off.
Box space_shown(const Scene& scene, const StructureView& view, std::span<const Bound> bounds, const Ray* ray) {
    if (view.shown) return *view.shown;
    Box box = scene_bounds(scene);
    if (box.is_empty()) box = {Vec3f(-1), Vec3f(1)};
    const Vec3f reach = (box.max - box.min) * 0.6f;
    const Box near{box.min - reach, box.max + reach};
    const auto include = [&](const Box& more) {
        box = unite(box, {glm::clamp(more.min, near.min, near.max), glm::clamp(more.max, near.min, near.max)});
    };
    for (const Bound& bound : bounds) include(box_about(bound));
    if (ray) include({ray->origin, ray->origin});
    return with_margin(box);
}

// Calls at(object, part, place) for every primitive; places are counted as in a structure's outline.
template <class At>
void for_each_primitive(const Scene& scene, const At& at) {
    std::uint32_t place = 0;
    for (const Object& object : scene.objects) {
        const std::size_t parts = part_count(object.shape);
        for (std::uint32_t part = 0; part < parts; ++part) at(object, part, place++);
    }
}

}  // namespace

StructureCanvas empty_canvas(const Scene& scene, const StructureView& view, std::span<const Bound> bounds,
                             const Ray* ray) {
    const Box shown = space_shown(scene, view, bounds, ray);
    StructureCanvas canvas{PlaneView(view.along, view.slice, shown), {.title = view.title}};
    const PlanePoint a = canvas.view.at(convert<double>(shown.min)), b = canvas.view.at(convert<double>(shown.max));
    canvas.drawing.low = {std::min(a.x, b.x), std::min(a.y, b.y)};
    canvas.drawing.high = {std::max(a.x, b.x), std::max(a.y, b.y)};
    canvas.drawing.width = view.width;
    canvas.drawing.height = view.height;
    return canvas;
}

void draw_shapes(StructureCanvas& canvas, const Scene& scene, const StructureView& view,
                 const std::set<std::uint32_t>& bold) {
    std::vector<PlaneDrawing::Figure> thin, thick;
    for_each_primitive(scene, [&](const Object& object, std::uint32_t part, std::uint32_t place) {
        const bool is_bold = bold.contains(place);
        if (!is_bold && thin.size() > view.max_shapes) return;
        for (const Wires& piece : wires_of(object.shape, part, object.placement))
            if (const auto figure = canvas.view.figure(piece))
                (is_bold ? thick : thin)
                    .push_back({*figure, {.line = is_bold ? "#000000" : ink_of_shapes, .width = is_bold ? 2.5 : 0.8}});
    });
    if (thin.size() > view.max_shapes) {
        thin.clear();
        canvas.drawing.notes.push_back(
            fmt::format("Of {} primitives {}.", primitive_count(scene),
                        bold.empty() ? "none is drawn: they are too many" : "only those tested are drawn"));
    }
    for (auto* figures : {&thin, &thick})
        for (auto& figure : *figures) canvas.drawing.marks.push_back(std::move(figure));
}

}  // namespace raylab
