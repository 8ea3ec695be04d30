#include "raylab/accelerator/light_buffer/light_buffer.h"

#include "raylab/accelerator/primitives.h"
#include "raylab/geometry/largest_coordinate.h"

#include <algorithm>

namespace raylab {

LightBuffer::LightBuffer(std::shared_ptr<const Primitives> primitives, const Vec3d& light,
                         const LightBufferOptions& options)
    : primitives_(std::move(primitives)),
      light_(light),
      options_(options),
      lists_(light_lists(*primitives_, light, options)) {}

LightBuffer::LightBuffer(const Scene& scene, const Vec3d& light, const LightBufferOptions& options)
    : LightBuffer(std::make_shared<const Primitives>(scene), light, options) {}

Primitive LightBuffer::primitive(std::uint32_t place) const { return primitives_->primitive(place); }

// A ray from P in direction D, not quite to the light at L. With d = P - L, its point at t strays from the straight way
// by t |d x D| / |d|, if it is compared with the point there that is as far along; at the end by the most. So whatever
// it hits is within the tolerance of a point of the straight way, and that way has one direction from the light: one
// cell.
std::optional<LightBuffer::Way> LightBuffer::way(const Ray& ray) const {
    const Vec3d d = convert<double>(ray.origin) - light_, direction = convert<double>(ray.direction);
    const Vec3d aside = cross(d, direction);
    const double distance2 = dot(d, d), end = ray.range.max, toward = -dot(d, direction) * end;
    const double tolerance = lists_.tolerance;
    // Written positively: NaN, from an infinite end, is no way to the light. Within 1024 radii of the light rounding is
    // at most 2^-39 radii; the tolerance is 2^-17.
    const bool arrives = ray.range.min >= 0 && toward > 0 && toward <= distance2 &&
                         end * end * dot(aside, aside) <= tolerance * tolerance * distance2 &&
                         distance2 <= 1024 * 1024 * lists_.radius * lists_.radius;
    if (!arrives) return std::nullopt;
    const double left = distance2 - toward;  // times the distance
    const bool to_light = ray.range.min == 0 && left * left <= tolerance * tolerance * distance2 / 4;
    return Way{d, largest_coordinate(d), to_light ? Way::Ends::at_light : Way::Ends::before};
}

std::optional<std::size_t> LightBuffer::index(const LightCell& cell) const {
    const auto n = static_cast<std::size_t>(options_.resolution);
    const std::size_t index = (static_cast<std::size_t>(cell.face) * n + static_cast<std::size_t>(cell.row)) * n +
                              static_cast<std::size_t>(cell.column);
    return index < lists_.covers.size() ? std::optional(index) : std::nullopt;  // a student's cell may be anywhere
}

std::span<const LightLists::Entry> LightBuffer::list(const LightCell& cell) const {
    const std::size_t at = *index(cell);
    return std::span(lists_.entries).subspan(lists_.first[at], lists_.first[at + 1] - lists_.first[at]);
}

std::optional<bool> LightBuffer::occluded(const Ray& ray, Traversal& traversal) const {
    const auto way = this->way(ray);
    if (!way) return std::nullopt;
    const auto cell = index(light_cell(way->from_light, options_.resolution));
    return cell ? stopped(ray, *way, *cell, traversal) : std::nullopt;
}

std::optional<bool> LightBuffer::stopped(const Ray& ray, const Way& way, std::size_t cell, Traversal& traversal) const {
    ++traversal.steps;
    const LightLists::Cover& cover = lists_.covers[cell];
    if (way.depth > cover.depth) {  // what is behind is not listed
        if (way.ends != Way::Ends::at_light || primitives_->primitive(cover.primitive) == ray.leaving)
            return std::nullopt;
        return true;
    }
    const auto stops = [&](std::size_t i) { return primitives_->hits(i, ray, traversal); };
    if (std::ranges::any_of(lists_.everywhere, stops)) return true;
    for (std::uint32_t at = lists_.first[cell]; at < lists_.first[cell + 1]; ++at) {
        const auto& [primitive, depth] = lists_.entries[at];
        if (depth > way.depth) return false;  // and so is all that follows
        if (stops(primitive)) return true;
    }
    return false;
}

}  // namespace raylab
