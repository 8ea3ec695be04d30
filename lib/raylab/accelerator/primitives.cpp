#include "raylab/accelerator/primitives.h"

#include <memory>

namespace raylab {

namespace {

const Mesh* mesh_of(const Shape& shape) {
    const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&shape);
    return mesh ? mesh->get() : nullptr;
}

// The triangle a primitive is, if it is one.
std::optional<Triangle> triangle_of(const Shape& shape, std::uint32_t part) {
    if (const Mesh* mesh = mesh_of(shape)) return mesh->triangle(part);
    const auto* triangle = std::get_if<Triangle>(&shape);
    return triangle ? std::optional(*triangle) : std::nullopt;
}

}  // namespace

Primitives::Primitives(const Scene& scene) : scene_(&scene) {
    for (std::uint32_t number = 0; number < scene.objects.size(); ++number) {
        const Object& object = scene.objects[number];
        const bool plain = object.placement.is_identity() && object.sides == Sides::both;
        const Mesh* mesh = mesh_of(object.shape);
        const std::size_t parts = mesh ? mesh->faces.size() : 1;
        for (std::uint32_t part = 0; part < parts; ++part) {
            const auto triangle = plain ? triangle_of(object.shape, part) : std::nullopt;
            items_.push_back({triangle.value_or(Triangle{}), {number, part}, triangle ? Kind::triangle : Kind::other});
        }
    }
}

Primitives::Primitives(const Primitives& all, std::span<const std::uint32_t> order) : scene_(all.scene_) {
    items_.reserve(order.size());
    for (const std::uint32_t i : order) items_.push_back(all.items_[i]);
}

Target Primitives::target(Primitive primitive) const {
    const Object& object = scene_->objects[primitive.object];
    return {&object.shape, primitive.part, &object.placement, object.sides};
}

std::optional<Box> Primitives::bounds(std::size_t i) const {
    const Target t = target(items_[i].primitive);
    if (const auto triangle = triangle_of(*t.shape, t.part)) return raylab::bounds(*triangle, *t.placement);
    return raylab::bounds(*t.shape, *t.placement);
}

std::optional<Candidate> Primitives::meet(std::size_t i, const Ray& ray, Traversal& traversal) const {
    const Item& item = items_[i];
    if (item.primitive == ray.leaving && is_flat(*target(item.primitive).shape)) return std::nullopt;
    ++traversal.primitive_tests;
    Decisions decisions;
    const auto found = item.kind == Kind::triangle ? intersect(ray, item.triangle, decisions)
                                                   : intersect(ray, target(item.primitive), decisions);
    traversal.exact_decisions += decisions.exact;
    return found;
}

void Primitives::offer(std::size_t i, const Candidate& found, Nearest& nearest, Traversal& traversal) const {
    const Primitive primitive = items_[i].primitive;
    Decisions decisions;
    nearest.offer(found, target(primitive), primitive, decisions);
    traversal.exact_decisions += decisions.exact;
}

}  // namespace raylab
