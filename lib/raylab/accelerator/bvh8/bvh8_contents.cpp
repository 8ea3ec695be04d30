#include "raylab/accelerator/bvh8/bvh8_contents.h"

#include "raylab/geometry/shape_parts.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <ranges>

namespace raylab {

namespace {

// Whether a leaf says all that is needed to test the object's triangles: they may be seen from the front alone, but not
// from the back alone, which is rare.
bool is_plain(const Scene& scene, const Object& object) {
    return object.placement.is_identity() && object.sides != Sides::back && !motion_of(scene, object) &&
           (as_mesh(object.shape) || std::holds_alternative<Triangle>(object.shape));
}

}  // namespace

// The input from which the tree is built.
struct Bvh8Contents::Sorted {
    std::vector<Run> runs;
    TriangleRuns triangles;
    std::vector<Primitive> others, unbounded;
    Bvh8Instances instances;
    std::vector<Box> boxes;  // of the other primitives, and of the instances after them

    Sorted(const Scene& scene, const Bvh8BuildOptions& options) : instances(scene, options) {
        for (std::uint32_t number = 0; number < scene.objects.size(); ++number) {
            const Object& object = scene.objects[number];
            const std::size_t parts = part_count(object.shape);
            if (is_plain(scene, object)) {
                add(number, parts);
                if (const Mesh* mesh = as_mesh(object.shape))
                    triangles.add(*mesh, object.sides);
                else
                    triangles.add(std::get<Triangle>(object.shape), object.sides);
                continue;
            }
            if (instances.add(number)) continue;
            for (std::uint32_t part = 0; part < parts; ++part) others.push_back({number, part});
        }
        set_unbounded_apart(scene, options.threads);
        for (std::size_t i = 0; i < instances.size(); ++i) boxes.push_back(instances.bounds(i));
    }

private:
    void set_unbounded_apart(const Scene& scene, int threads) {
        const auto found = bounds_of(scene, others, threads);
        std::vector<Primitive> bounded;
        for (std::size_t i = 0; i < found.size(); ++i) {
            (found[i] ? bounded : unbounded).push_back(others[i]);
            if (found[i]) boxes.push_back(*found[i]);
        }
        others = std::move(bounded);
    }

    // The run's last object is the one before this one and has as many triangles: then it goes on.
    void add(std::uint32_t object, std::size_t parts) {
        if (parts == 0) return;
        const auto first = static_cast<std::uint32_t>(triangles.size());
        const auto each = static_cast<std::uint32_t>(parts);
        const bool goes_on = !runs.empty() && runs.back().triangles_each == each &&
                             runs.back().object + (first - runs.back().first) / each == object;
        if (!goes_on) runs.push_back({first, object, each});
    }
};

Bvh8Contents::Bvh8Contents(const Scene& scene, const Bvh8BuildOptions& options)
    : Bvh8Contents(scene, options, [&](const TriangleRuns& triangles, std::span<const Box> others) {
          return build_bvh8_nodes(triangles, others, options);
      }) {}

Bvh8Contents::Bvh8Contents(const Scene& scene, const Bvh8BuildOptions& options, const Build& build)
    : Bvh8Contents(scene, Sorted(scene, options), build) {}

Bvh8Contents::Bvh8Contents(const Scene& scene, Sorted sorted, const Build& build)
    : scene_(&scene),
      runs_(sorted.runs),
      tree_(build(sorted.triangles, sorted.boxes)),
      others_(scene, put_in_leaf_order(sorted)),
      unbounded_(scene, sorted.unbounded),
      instances_(std::move(sorted.instances)) {}

// Brings other shapes and instances into the order of the leaves, which name them so from then on: those of
// neighbouring leaves lie beside each other in memory. (What was split stands in several leaves: the first one counts.)
// Returns the shapes.
std::vector<Primitive> Bvh8Contents::put_in_leaf_order(Sorted& sorted) {
    constexpr auto unseen = std::numeric_limits<std::uint32_t>::max();
    const std::size_t count = sorted.others.size();
    std::vector<std::uint32_t> place(count + sorted.instances.size(), unseen);
    std::vector<Primitive> shapes;
    std::vector<std::uint32_t> instances;
    shapes.reserve(count);
    for (std::uint32_t& other : tree_.others) {
        if (place[other] == unseen) {
            const bool is_shape = other < count;
            place[other] = static_cast<std::uint32_t>(is_shape ? shapes.size() : count + instances.size());
            if (is_shape)
                shapes.push_back(sorted.others[other]);
            else
                instances.push_back(other - static_cast<std::uint32_t>(count));
        }
        other = place[other];
    }
    if (std::ranges::equal(tree_.others, std::views::iota(std::size_t{0}, tree_.others.size())))
        tree_.others = std::vector<std::uint32_t>();
    sorted.instances.put_in_order(instances);
    return shapes;
}

std::size_t Bvh8Contents::bytes() const {
    return tree_.bytes() + others_.bytes() + unbounded_.bytes() + instances_.bytes() + runs_.capacity() * sizeof(Run);
}

const Bvh8Contents::Run& Bvh8Contents::run_of(std::uint32_t number) const {
    return *(std::ranges::upper_bound(runs_, number, {}, &Run::first) - 1);
}

std::uint32_t Bvh8Contents::number_of(Primitive name) const {
    const auto after = std::ranges::upper_bound(runs_, name.object, {}, &Run::object);
    if (after == runs_.begin()) return Bvh8Query::leaves_none;
    const Run& run = *(after - 1);
    const std::size_t end = after == runs_.end() ? tree_.triangle_count : after->first;
    const std::size_t before = std::size_t{name.object - run.object} * run.triangles_each;
    const std::size_t number = run.first + before + name.part;
    return number < end ? static_cast<std::uint32_t>(number) : Bvh8Query::leaves_none;
}

std::vector<std::uint32_t> Bvh8Contents::places_in_scene(Bvh8Child leaf) const {
    const std::vector<std::uint32_t> first = first_places(*scene_);
    std::vector<std::uint32_t> places;
    const auto add = [&](Primitive name) { places.push_back(first[name.object] + name.part); };
    for (std::size_t place = 0; place < leaf.count(); ++place) {
        if (leaf.kind() != Bvh8Child::Kind::others) {
            add(primitive(tree_.number(leaf, place)));
        } else if (const std::size_t other = tree_.other(leaf.first() + place); other < others_.size()) {
            add(others_.primitive(other));
        } else {
            const std::uint32_t object = instances_.object(other - others_.size());
            const std::size_t parts = part_count(scene_->objects[object].shape);
            for (std::uint32_t part = 0; part < parts; ++part) add({object, part});
        }
    }
    return places;
}

}  // namespace raylab
