#include "raylab/accelerator/bvh8/bvh8_contents.h"

#include "raylab/accelerator/bvh8/bvh8_walk.h"
#include "raylab/base/tiles.h"
#include "raylab/geometry/shape_parts.h"

#include <algorithm>
#include <memory>

namespace raylab {

namespace {

// Whether the floats of a leaf are all that is needed to test the object's triangles.
bool is_plain(const Scene& scene, const Object& object) {
    return object.placement.is_identity() && object.sides == Sides::both && !motion_of(scene, object) &&
           (as_mesh(object.shape) || std::holds_alternative<Triangle>(object.shape));
}

}  // namespace

// The input from which the tree is built.
struct Bvh8Contents::Sorted {
    std::vector<Run> runs;
    std::vector<Triangle> triangles;
    std::vector<Primitive> others, unbounded;
    std::vector<Box> boxes;  // of the other primitives
    static constexpr std::size_t piece_size = std::size_t{1} << 14;

    Sorted(const Scene& scene, int threads) {
        for (std::uint32_t number = 0; number < scene.objects.size(); ++number) {
            const Object& object = scene.objects[number];
            const std::size_t parts = part_count(object.shape);
            if (is_plain(scene, object)) {
                runs.push_back({static_cast<std::uint32_t>(triangles.size()), number});
                triangles.resize(triangles.size() + parts);
                const std::span<Triangle> own = std::span(triangles).last(parts);
                for_each_piece(parts, piece_size, parts <= piece_size ? 1 : threads,
                               [&](std::size_t begin, std::size_t end) {
                                   for (std::size_t part = begin; part < end; ++part)
                                       own[part] = *triangle_of(object.shape, part);
                               });
                continue;
            }
            for (std::uint32_t part = 0; part < parts; ++part) {
                const auto box = bounds_of(scene, {number, part});
                (box ? others : unbounded).push_back({number, part});
                if (box) boxes.push_back(*box);
            }
        }
    }
};

Bvh8Contents::Bvh8Contents(const Scene& scene, const Bvh8BuildOptions& options)
    : Bvh8Contents(scene, Sorted(scene, options.threads), options) {}

Bvh8Contents::Bvh8Contents(const Scene& scene, const Sorted& sorted, const Bvh8BuildOptions& options)
    : scene_(&scene),
      runs_(sorted.runs),
      others_(scene, sorted.others),
      unbounded_(scene, sorted.unbounded),
      tree_(build_bvh8_nodes(sorted.triangles, sorted.boxes, options)) {}

std::size_t Bvh8Contents::bytes() const {
    return tree_.bytes() + others_.bytes() + unbounded_.bytes() + runs_.capacity() * sizeof(Run);
}

Primitive Bvh8Contents::primitive(std::uint32_t number) const {
    if (runs_.size() == 1) return {runs_[0].object, number};
    const auto after = std::upper_bound(runs_.begin(), runs_.end(), number,
                                        [](std::uint32_t n, const Run& run) { return n < run.first; });
    const Run& run = *(after - 1);
    return {run.object, number - run.first};
}

std::uint32_t Bvh8Contents::number_left_by(const Ray& ray) const {
    if (ray.leaving == no_primitive) return Bvh8Query::leaves_none;
    for (const Run& run : runs_)
        if (run.object == ray.leaving.object) return run.first + ray.leaving.part;
    return Bvh8Query::leaves_none;
}

std::vector<std::uint32_t> Bvh8Contents::places_in_scene(Bvh8Child leaf) const {
    const std::vector<std::uint32_t> first = first_places(*scene_);
    std::vector<std::uint32_t> places;
    for (std::size_t place = 0; place < leaf.count(); ++place) {
        const Primitive name = leaf.kind() == Bvh8Child::Kind::others
                                   ? others_.primitive(tree_.others[leaf.first() + place])
                                   : primitive(tree_.number(leaf, place));
        places.push_back(first[name.object] + name.part);
    }
    return places;
}

}  // namespace raylab
