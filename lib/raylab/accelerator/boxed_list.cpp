#include "raylab/accelerator/boxed_list.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace raylab {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr Box everything{Vec3f{-infinity, -infinity, -infinity}, Vec3f{infinity, infinity, infinity}};

// What FourBoxes can hold: a box that reaches past its coordinates is as good as endless.
Box box_of(const Primitives& primitives, std::size_t i) {
    Box box = primitives.bounds(i).value_or(everything);
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(box.min[axis]) <= FourBoxesRay::largest)) box.min[axis] = -infinity;
        if (!(std::abs(box.max[axis]) <= FourBoxesRay::largest)) box.max[axis] = infinity;
    }
    return box;
}

}  // namespace

BoxedList::BoxedList(const Scene& scene) : primitives_(scene) {
    for (std::size_t i = 0; i < primitives_.size(); ++i) {
        if (i % 4 == 0) boxes_.push_back(FourBoxes::empty());
        boxes_.back().set(i % 4, box_of(primitives_, i));
    }
}

template <class At>
void BoxedList::visit(const FourBoxesRay& ray, Traversal& traversal, const At& at) const {
    const std::size_t size = primitives_.size();
    for (std::size_t group = 0; group < boxes_.size(); ++group) {
        traversal.box_tests += 4;
        for (unsigned met = ray.meets(boxes_[group]); met != 0; met &= met - 1)
            if (const std::size_t i = 4 * group + static_cast<std::size_t>(std::countr_zero(met)); i < size && at(i)) return;
    }
}

std::optional<Hit> BoxedList::closest(const Ray& ray, Traversal& traversal) const {
    Nearest nearest(ray);
    FourBoxesRay box_ray(ray);
    visit(box_ray, traversal, [&](std::size_t i) {
        primitives_.test(i, ray, nearest, traversal);
        box_ray.set_end(std::min<double>(ray.range.max, nearest.limit()));
        return false;
    });
    return nearest.hit();
}

bool BoxedList::occluded(const Ray& ray, Traversal& traversal) const {
    if (traversal.stopped_again([&](std::size_t i) { return primitives_.hits(i, ray, traversal); })) return true;
    bool hit = false;
    visit(FourBoxesRay(ray), traversal, [&](std::size_t i) {
        hit = primitives_.hits(i, ray, traversal);
        if (hit) traversal.stopped_by(i);
        return hit;
    });
    return hit;
}

}  // namespace raylab
