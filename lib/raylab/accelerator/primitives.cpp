#include "raylab/accelerator/primitives.h"

#include <memory>

namespace raylab {

namespace {

std::size_t part_count(const Shape& shape) {
    const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&shape);
    return mesh ? (*mesh)->faces.size() : 1;
}

}  // namespace

Primitives::Primitives(const Scene& scene) : scene_(&scene) {
    for (std::size_t object = 0; object < scene.objects.size(); ++object) {
        const std::size_t parts = part_count(scene.objects[object].shape);
        for (std::size_t part = 0; part < parts; ++part) {
            primitives_.push_back({static_cast<std::uint32_t>(object), static_cast<std::uint32_t>(part)});
        }
    }
}

Target Primitives::target(Primitive primitive) const {
    const Object& object = scene_->objects[primitive.object];
    return {&object.shape, primitive.part, &object.placement, object.sides};
}

std::optional<Box> Primitives::bounds(std::size_t i) const {
    const Target t = target(primitives_[i]);
    if (const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(t.shape)) {
        return raylab::bounds((*mesh)->triangle(t.part), *t.placement);
    }
    return raylab::bounds(*t.shape, *t.placement);
}

std::size_t Primitives::bytes() const { return primitives_.capacity() * sizeof(Primitive); }

std::optional<Candidate> Primitives::meet(Primitive primitive, const Ray& ray, Traversal& traversal) const {
    const Target aim = target(primitive);
    if (primitive == ray.leaving && is_flat(*aim.shape)) return std::nullopt;
    ++traversal.primitive_tests;
    Decisions decisions;
    const auto found = intersect(ray, aim, decisions);
    traversal.exact_decisions += decisions.exact;
    return found;
}

void Primitives::test(std::size_t i, const Ray& ray, Nearest& nearest, Traversal& traversal) const {
    const Primitive primitive = primitives_[i];
    const auto found = meet(primitive, ray, traversal);
    if (!found) return;
    Decisions decisions;
    nearest.offer(*found, target(primitive), primitive, decisions);
    traversal.exact_decisions += decisions.exact;
}

bool Primitives::hits(std::size_t i, const Ray& ray, Traversal& traversal) const {
    return meet(primitives_[i], ray, traversal).has_value();
}

}  // namespace raylab
