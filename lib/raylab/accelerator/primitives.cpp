#include "raylab/accelerator/primitives.h"

#include "raylab/base/tiles.h"
#include "raylab/geometry/placement_at.h"
#include "raylab/geometry/shape_parts.h"
#include "raylab/scene/needs.h"

#include <limits>

namespace raylab {

std::vector<std::uint32_t> first_places(const Scene& scene) {
    std::vector<std::uint32_t> first;
    std::size_t place = 0;
    for (const Object& object : scene.objects) {
        first.push_back(static_cast<std::uint32_t>(place));
        place += part_count(object.shape);
    }
    return first;
}

std::vector<Primitive> primitives_of(const Scene& scene) {
    std::vector<Primitive> names;
    names.reserve(primitive_count(scene));
    for (std::uint32_t number = 0; number < scene.objects.size(); ++number) {
        const std::size_t parts = part_count(scene.objects[number].shape);
        for (std::uint32_t part = 0; part < parts; ++part) names.push_back({number, part});
    }
    return names;
}

std::optional<Box> bounds_at(const Scene& scene, Primitive primitive, float time) {
    const Object& object = scene.objects[primitive.object];
    const Motion* motion = motion_of(scene, object);
    if (const auto triangle = triangle_of(object.shape, primitive.part))
        return motion ? bounds(*triangle, object.placement, *motion, time) : bounds(*triangle, object.placement);
    return motion ? bounds(object.shape, object.placement, *motion, time) : bounds(object.shape, object.placement);
}

std::optional<Box> bounds_of(const Scene& scene, Primitive primitive) {
    const auto [begin, end] = ray_times(scene);
    const auto first = bounds_at(scene, primitive, begin);
    if (!first || !motion_of(scene, scene.objects[primitive.object])) return first;
    return unite(*first, *bounds_at(scene, primitive, end));
}

std::vector<std::optional<Box>> bounds_of(const Scene& scene, std::span<const Primitive> some, int threads) {
    constexpr std::size_t grain = 256;
    std::vector<std::optional<Box>> found(some.size());
    for_each_piece(some.size(), grain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) found[i] = bounds_of(scene, some[i]);
    });
    return found;
}

Primitives::Primitives(const Scene& scene) : Primitives(scene, primitives_of(scene)) {}

Primitives::Primitives(const Scene& scene, std::span<const Primitive> some) : scene_(&scene) {
    std::vector<Prepared> places(scene.objects.size(), none);
    items_.reserve(some.size());
    for (const Primitive& primitive : some) {
        const Object& object = scene.objects[primitive.object];
        add(item(primitive), places[primitive.object],
            [&] { return PreparedShape(object.shape, object.placement, motion_of(scene, object)); });
    }
}

Primitives::Primitives(const Primitives& all, std::span<const std::uint32_t> order) : scene_(all.scene_) {
    std::vector<Prepared> places(scene_->objects.size(), none);
    items_.reserve(order.size());
    for (const std::uint32_t i : order) {
        const Item& item = all.items_[i];
        add(item, places[item.primitive.object], [&] { return all.prepared_[std::get<Prepared>(item.shape)]; });
    }
}

// Adds a primitive. One that is kept prepared shares what its object's first one has made, and where that lies.
template <class Prepare>
void Primitives::add(Item item, Prepared& place, const Prepare& prepare) {
    if (auto* prepared = std::get_if<Prepared>(&item.shape)) {
        if (place == none) {
            place = static_cast<Prepared>(prepared_.size());
            prepared_.push_back(prepare());
        }
        *prepared = place;
    }
    items_.push_back(item);
    if (const auto* rows = std::get_if<TriangleRows>(&item.shape))
        triangles_ = unite(triangles_, raylab::bounds(rows->triangle()));
}

// As it lies here, but for the place of what is kept prepared.
Primitives::Item Primitives::item(Primitive primitive) const {
    const Object& object = scene_->objects[primitive.object];
    Item item{.shape = none,
              .primitive = primitive,
              .sides = object.sides,
              .surface = is_flat(object.shape) ? Item::Surface::flat : Item::Surface::curved};
    const bool in_place = object.placement.is_identity() && !motion_of(*scene_, object);
    const auto triangle = triangle_of(object.shape, primitive.part);
    if (in_place && triangle) {
        item.shape = TriangleRows(*triangle);
    } else if (const auto* sphere = std::get_if<Sphere>(&object.shape); in_place && sphere) {
        item.shape = *sphere;
    }
    return item;
}

std::size_t Primitives::bytes() const {
    std::size_t sum =
        items_.capacity() * sizeof(Item) + (prepared_.capacity() - prepared_.size()) * sizeof(PreparedShape);
    for (const PreparedShape& shape : prepared_) sum += shape.bytes();
    return sum;
}

std::optional<Triangle> Primitives::triangle(std::size_t i) const {
    const auto* rows = std::get_if<TriangleRows>(&items_[i].shape);
    return rows ? std::optional(rows->triangle()) : std::nullopt;
}

std::optional<Sphere> Primitives::whole_sphere(std::size_t i) const {
    const auto* sphere = std::get_if<Sphere>(&items_[i].shape);
    return sphere && items_[i].sides == Sides::both ? std::optional(*sphere) : std::nullopt;
}

Hull Primitives::hull(std::size_t i) const {
    const Target t = target(i);
    const auto triangle = triangle_of(*t.shape, t.part);
    if (t.motion && !only_translates(*t.motion)) return corners_at_both_ends(i);
    const Hull at_rest = triangle ? raylab::hull(*triangle, *t.placement) : raylab::hull(*t.shape, *t.placement);
    if (!t.motion) return at_rest;
    Hull hull = swept(at_rest, t.motion->translation, times());
    return is_finite(hull) ? hull : corners_at_both_ends(i);
}

Hull Primitives::corners_at_both_ends(std::size_t i) const {
    const auto [begin, end] = times();
    const auto first = bounds_at(i, begin), last = bounds_at(i, end);
    if (!first) return {};
    Hull both = raylab::hull(*first);
    const Hull more = raylab::hull(*last);
    both.insert(both.end(), more.begin(), more.end());
    return both;
}

std::vector<std::uint32_t> Primitives::places() const {
    const std::vector<std::uint32_t> begin = first_places(*scene_);
    std::vector<std::uint32_t> places;
    places.reserve(size());
    for (const Item& item : items_) places.push_back(begin[item.primitive.object] + item.primitive.part);
    return places;
}

bool Primitives::reaches(std::size_t i, const BoxOfDoubles& box) const {
    const Item& item = items_[i];
    if (const auto* rows = std::get_if<TriangleRows>(&item.shape)) return raylab::reaches(rows->triangle(), box);
    if (const auto* sphere = std::get_if<Sphere>(&item.shape)) return raylab::reaches(*sphere, box);
    return true;
}

std::optional<Candidate> Primitives::intersection(const Item& item, const Ray& ray, DecisionCounts& decisions) const {
    if (const auto* rows = std::get_if<TriangleRows>(&item.shape))
        return intersect(ray, rows->triangle(), decisions, item.sides);
    if (const auto* sphere = std::get_if<Sphere>(&item.shape)) return intersect(ray, *sphere, decisions, item.sides);
    const PreparedShape& shape = prepared_[*std::get_if<Prepared>(&item.shape)];
    return shape.intersect(ray, item.primitive.part, item.sides, decisions);
}

}  // namespace raylab
