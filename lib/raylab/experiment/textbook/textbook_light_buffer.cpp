#include "raylab/experiment/textbook/textbook_light_buffer.h"

#include "raylab/accelerator/light_buffer/light_hull.h"
#include "raylab/accelerator/light_buffer/light_through_list.h"
#include "raylab/accelerator/light_buffer/listed_cells.h"
#include "raylab/base/error.h"
#include "raylab/geometry/largest_coordinate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab {

namespace {

using Polygon3d = std::vector<Vec3d>;
using Polygons = std::vector<Polygon3d>;

// Of a face's cube: how deep a polygon begins along the face's axis.
double depth_of(const Polygon3d& corners, int face) {
    double depth = std::numeric_limits<double>::infinity();
    for (const Vec3d& corner : corners) depth = std::min(depth, (face % 2 == 0 ? 1 : -1) * corner[face / 2]);
    return depth;
}

// The sides of a box, whose corner i has its larger coordinate along each axis whose bit is set in i.
Polygons sides_of(const std::vector<Vec3d>& corners) {
    Polygons sides;
    for (const std::size_t axis : {1u, 2u, 4u}) {
        const std::size_t right = axis == 4 ? 1 : 2 * axis, up = 7 - axis - right;
        for (const std::size_t side : {std::size_t{0}, axis})
            sides.push_back({corners[side], corners[side + right], corners[side + right + up], corners[side + up]});
    }
    return sides;
}

// What bounds a primitive, as seen from the light.
Polygons polygons_of(const Silhouette::Hull& hull) {
    if (hull.face_normals.size() == 1) return {hull.corners};
    if (hull.ball == 0) return sides_of(hull.corners);
    std::vector<Vec3d> corners;
    for (unsigned i = 0; i < 8; ++i)
        corners.push_back(hull.corners[0] +
                          hull.ball * Vec3d{i & 1u ? 1.0 : -1.0, i & 2u ? 1.0 : -1.0, i & 4u ? 1.0 : -1.0});
    return sides_of(corners);
}

Vec3d place_of_first_light(const Scene& scene) {
    const auto* point = scene.lights.empty() ? nullptr : std::get_if<PointLight>(&scene.lights[0].kind);
    if (!point) throw Error("a textbook's light buffer: expected a point light as the first light of the scene");
    return point->position;
}

}  // namespace

TextbookLightBuffer::TextbookLightBuffer(const Scene& scene, int resolution)
    : primitives_(scene),
      light_(place_of_first_light(scene)),
      resolution_(resolution),
      lists_(static_cast<std::size_t>(6 * resolution * resolution)) {
    for (std::uint32_t i = 0; i < primitives_.size(); ++i) add(i);
    for (List& list : lists_) std::ranges::sort(list, {}, &Entry::depth);
}

std::size_t TextbookLightBuffer::index(const LightCell& cell) const {
    const int last = static_cast<int>(lists_.size()) - 1;  // a student's cell may be anywhere
    return static_cast<std::size_t>(
        std::clamp((cell.face * resolution_ + cell.row) * resolution_ + cell.column, 0, last));
}

void TextbookLightBuffer::add(std::uint32_t primitive) {
    const auto hull = hull_from(light_, primitives_.target(primitive), 0);
    if (!hull) return unbounded_.push_back(primitive);
    for (const auto& polygon : polygons_of(*hull))
        for (int face = 0; face < 6; ++face) {
            const auto cells = listed_cells(polygon, face, resolution_);
            if (!cells) continue;
            const double depth = depth_of(polygon, face);
            for (int row = std::max(cells->first_row, 0); row <= std::min(cells->last_row, resolution_ - 1); ++row)
                for (int column = std::max(cells->first_column, 0);
                     column <= std::min(cells->last_column, resolution_ - 1); ++column) {
                    List& listed = lists_[index({face, column, row})];
                    if (listed.empty() || listed.back().primitive != primitive)
                        listed.push_back({depth, primitive});
                    else
                        listed.back().depth = std::min(listed.back().depth, depth);
                }
        }
}

std::size_t TextbookLightBuffer::bytes() const {
    std::size_t sum =
        primitives_.bytes() + lists_.capacity() * sizeof(List) + unbounded_.capacity() * sizeof unbounded_[0];
    for (const List& list : lists_) sum += list.capacity() * sizeof(Entry);
    return sum;
}

std::optional<Hit> TextbookLightBuffer::closest(const Ray& ray, Traversal& traversal) const {
    Nearest nearest(ray);
    for (std::size_t i = 0; i < primitives_.size(); ++i) primitives_.test(i, ray, nearest, traversal);
    return nearest.hit();
}

bool TextbookLightBuffer::occluded(const Ray& ray, Traversal& traversal) const {
    const Vec3d way = convert<double>(ray.origin) - light_;
    const Vec3d missed = way + convert<double>(ray.direction) * static_cast<double>(ray.range.max);
    constexpr double near = 1e-4;  // of the way: a shadow ray of floats ends so near to its light
    if (!(glm::length(missed) <= near * glm::length(way))) return closest(ray, traversal).has_value();
    ++traversal.steps;
    const auto hits = [&](std::uint32_t i) { return primitives_.hits(i, ray, traversal); };
    if (std::ranges::any_of(unbounded_, hits)) return true;
    const List& list = lists_[index(light_cell(way, resolution_))];
    const auto entry = [&](int i) { return list[static_cast<std::size_t>(i)]; };
    const double share = light_through_list({.depth = largest_coordinate(way),
                                             .filled = std::numeric_limits<double>::infinity(),
                                             .entries = static_cast<int>(list.size()),
                                             .begin = [&](int i) { return entry(i).depth; },
                                             .through = [&](int i) { return hits(entry(i).primitive) ? 0.0 : 1.0; }});
    return share == 0;
}

}  // namespace raylab
