#include "raylab/accelerator/primitives.h"

#include "raylab/geometry/revolution_filter.h"
#include "raylab/geometry/shape_parts.h"

namespace raylab {

namespace {

std::optional<PreparedFlat> prepared(const Shape& shape) {
    if (const auto* plane = std::get_if<Plane>(&shape)) return PreparedFlat(*plane);
    if (const auto* disk = std::get_if<Disk>(&shape)) return PreparedFlat(*disk);
    if (const auto* polygon = std::get_if<Polygon>(&shape)) return PreparedFlat(*polygon);
    return std::nullopt;
}

}  // namespace

std::vector<std::uint32_t> first_places(const Scene& scene) {
    std::vector<std::uint32_t> first;
    std::size_t place = 0;
    for (const Object& object : scene.objects) {
        first.push_back(static_cast<std::uint32_t>(place));
        place += part_count(object.shape);
    }
    return first;
}

Primitives::Primitives(const Scene& scene) : scene_(&scene) {
    for (std::uint32_t number = 0; number < scene.objects.size(); ++number) {
        const Object& object = scene.objects[number];
        const std::size_t parts = part_count(object.shape);
        for (std::uint32_t part = 0; part < parts; ++part) add(item(object, {number, part}));
    }
}

Primitives::Primitives(const Scene& scene, std::span<const Primitive> some) : scene_(&scene) {
    items_.reserve(some.size());
    for (const Primitive& primitive : some) add(item(scene.objects[primitive.object], primitive));
}

Primitives::Primitives(const Primitives& all, std::span<const std::uint32_t> order) : scene_(all.scene_) {
    items_.reserve(order.size());
    for (const std::uint32_t i : order) {
        add(all.items_[i]);
        if (const auto* flat = std::get_if<Flat>(&all.items_[i].shape)) items_.back().shape = kept(all.flats_[*flat]);
    }
}

void Primitives::add(const Item& item) {
    items_.push_back(item);
    if (const auto* rows = std::get_if<TriangleRows>(&item.shape)) triangles_ = unite(triangles_, raylab::bounds(rows->triangle()));
}

Primitives::Flat Primitives::kept(const PreparedFlat& flat) {
    flats_.push_back(flat);
    return static_cast<Flat>(flats_.size() - 1);
}

Primitives::Item Primitives::item(const Object& object, Primitive primitive) {
    Item item{.shape = Elsewhere{},
              .primitive = primitive,
              .sides = object.sides,
              .surface = is_flat(object.shape) ? Item::Surface::flat : Item::Surface::curved};
    if (!object.placement.is_identity()) return item;
    if (const auto triangle = triangle_of(object.shape, primitive.part)) {
        item.shape = TriangleRows(*triangle);
    } else if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        item.shape = *sphere;
    } else if (const auto flat = prepared(object.shape)) {
        item.shape = kept(*flat);
    } else if (std::holds_alternative<Cylinder>(object.shape)) {
        item.shape = Cylindrical{};
    } else if (std::holds_alternative<Cone>(object.shape)) {
        item.shape = Conical{};
    }
    return item;
}

std::size_t Primitives::bytes() const {
    std::size_t sum = items_.capacity() * sizeof(Item) + flats_.capacity() * sizeof(PreparedFlat);
    for (const PreparedFlat& flat : flats_) sum += flat.bytes();
    return sum;
}

std::optional<Box> Primitives::bounds(std::size_t i) const {
    const Target t = target(items_[i].primitive);
    if (const auto triangle = triangle_of(*t.shape, t.part)) return raylab::bounds(*triangle, *t.placement);
    return raylab::bounds(*t.shape, *t.placement);
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
    const Target t = target(items_[i].primitive);
    if (const auto triangle = triangle_of(*t.shape, t.part)) return raylab::hull(*triangle, *t.placement);
    return raylab::hull(*t.shape, *t.placement);
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

inline FilterVerdict Primitives::decide(const Item& item, const Ray& ray) const {
    if (const auto* flat = std::get_if<Flat>(&item.shape)) return flats_[*flat].meet(ray, item.sides);
    const Shape& shape = scene_->objects[item.primitive.object].shape;
    if (std::holds_alternative<Cylindrical>(item.shape)) return revolution_filter::decide(ray, *std::get_if<Cylinder>(&shape), item.sides);
    if (std::holds_alternative<Conical>(item.shape)) return revolution_filter::decide(ray, *std::get_if<Cone>(&shape), item.sides);
    return Undecided{};
}

std::optional<Candidate> Primitives::intersection(const Item& item, const Ray& ray, Decisions& decisions) const {
    if (const auto* rows = std::get_if<TriangleRows>(&item.shape)) return intersect(ray, rows->triangle(), decisions, item.sides);
    if (const auto* sphere = std::get_if<Sphere>(&item.shape)) return intersect(ray, *sphere, decisions, item.sides);
    const FilterVerdict soon = decide(item, ray);
    if (!std::holds_alternative<Undecided>(soon)) return candidate_of(soon);
    return intersect(ray, target(item.primitive), decisions);
}

}  // namespace raylab
