#include "raylab/accelerator/bvh8/bvh8_instances.h"

#include "raylab/accelerator/bvh8/bvh8_build.h"
#include "raylab/accelerator/primitives.h"
#include "raylab/geometry/shape_parts.h"
#include "raylab/number/enclosure.h"
#include "raylab/number/next_float.h"
#include "raylab/scene/moving.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace raylab {

namespace {

// All numbers between two floats.
Enclosure between(float low, float high) {
    const double middle = (double{low} + high) / 2;
    return {middle, std::max(high - middle, middle - low) * (1 + 4 * unit_roundoff<double>)};
}

Box placed(const Vec3<Enclosure>& box, const Affine& placement) {
    Box image;
    for (int axis = 0; axis < 3; ++axis) {
        const auto& [x, y, z] = placement.columns;
        const Enclosure all = Enclosure(x[axis]) * box.x + Enclosure(y[axis]) * box.y + Enclosure(z[axis]) * box.z +
                              Enclosure(placement.translation[axis]);
        image.min[axis] = -rounded_up(-all.lower());
        image.max[axis] = rounded_up(all.upper());
    }
    return image;
}

// The box about the images of the root's boxes: closer than the image of the box about all, and no work for each
// vertex.
Box box_about(const Bvh8Nodes& tree, const Affine& placement) {
    Box all;
    const auto& planes = tree.nodes[0].planes;
    for (std::size_t i = 0; i < bvh8_width; ++i) {
        if (planes[0][i] > planes[3][i]) continue;
        all = unite(all, placed({between(planes[0][i], planes[3][i]), between(planes[1][i], planes[4][i]),
                                 between(planes[2][i], planes[5][i])},
                                placement));
    }
    return all;
}

}  // namespace

bool Bvh8Instances::add(std::uint32_t number) {
    const Object& object = scene_->objects[number];
    const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&object.shape);
    if (!mesh || (*mesh)->faces.empty() || object.placement.is_identity() || motion_of(*scene_, object)) return false;
    const auto map = WorldToMesh::inverse_of(object.placement);
    if (!map) return false;
    const Bvh8Nodes& tree = tree_of(*mesh);
    if (tree.farthest_origin < 0) return false;
    instances_.push_back({number, object.sides, box_about(tree, object.placement), &tree, *map});
    return true;
}

const Bvh8Nodes& Bvh8Instances::tree_of(const std::shared_ptr<const Mesh>& mesh) {
    auto& tree = trees_[mesh.get()];
    if (!tree) {
        TriangleRuns triangles;
        triangles.add(*mesh);
        tree = std::make_unique<const Bvh8Nodes>(build_bvh8_nodes(triangles, {}, options_));
    }
    return *tree;
}

void Bvh8Instances::put_in_order(const std::vector<std::uint32_t>& order) {
    std::vector<Instance> ordered;
    ordered.reserve(order.size());
    for (const std::uint32_t i : order) ordered.push_back(instances_[i]);
    instances_ = std::move(ordered);
}

std::size_t Bvh8Instances::bytes() const {
    std::size_t sum = instances_.capacity() * sizeof(Instance);
    for (const auto& [mesh, tree] : trees_) sum += sizeof *tree + tree->bytes();
    return sum;
}

// The exact tests of an instance's triangles.
class Bvh8Instances::Leaves : public Bvh8Leaves {
public:
    Leaves(const Scene& scene, const Instance& instance, const Ray& ray, Traversal& traversal)
        : instance_(instance), ray_(ray), traversal_(traversal), scene_(scene) {}

    /// The t of the walk at which it ends, once this triangle has been tested.
    virtual double test(std::uint32_t face, const Triangle& triangle) = 0;

    double uncertain(Bvh8Child leaf, std::size_t place) final {
        return test(tree().number(leaf, place), tree().triangle(leaf, place));
    }
    double hit_found(Bvh8Child leaf, std::size_t place) override { return uncertain(leaf, place); }
    double others(Bvh8Child) final {
        assert(false && "the tree over a mesh holds triangles");
        return everything;
    }

    /// Tests every triangle, for rays whose numbers exceed floats.
    void test_all() {
        const Mesh& mesh = *std::get<std::shared_ptr<const Mesh>>(scene_.objects[instance_.object].shape);
        for (std::uint32_t face = 0; face < mesh.faces.size(); ++face)
            if (test(face, mesh.triangle(face)) == nothing_more) return;
    }

    const Bvh8Nodes& tree() const { return *instance_.tree; }

protected:
    static constexpr double everything = std::numeric_limits<double>::infinity();  // the walk goes on as it was

    // (All that this needs is the instance's and the leaf's. A hundred thousand objects are not in the caches: each
    // that is read would be waited for.)
    std::optional<Candidate> hit(std::uint32_t face, const Triangle& triangle) const {
        if (name(face) == ray_.leaving) return std::nullopt;
        DecisionCounts decisions;
        const auto found = intersect(ray_, triangle, instance_.map.placement(), decisions, instance_.sides);
        traversal_.exact_decisions += decisions.exact;
        return found;
    }
    Primitive name(std::uint32_t face) const { return {instance_.object, face}; }

    const Instance& instance_;
    const Ray& ray_;
    Traversal& traversal_;
    const Scene& scene_;
};

class Bvh8Instances::NearestLeaves final : public Leaves {
public:
    NearestLeaves(const Scene& scene, const Instance& instance, const Ray& ray, const RayInMesh& in_mesh,
                  Nearest& found, Traversal& traversal)
        : Leaves(scene, instance, ray, traversal), in_mesh_(in_mesh), found_(found) {}

    double test(std::uint32_t face, const Triangle& triangle) override {
        const auto found = hit(face, triangle);
        if (!found) return everything;
        offer(scene_, name(face), *found, found_, traversal_);
        return in_mesh_.at_most(found_.limit());
    }

private:
    const RayInMesh& in_mesh_;
    Nearest& found_;
};

class Bvh8Instances::AnyLeaves final : public Leaves {
public:
    using Leaves::Leaves;

    // What the walk is sure of needs no other test, unless a side is not seen or the triangle is left.
    double hit_found(Bvh8Child leaf, std::size_t place) override {
        if (instance_.sides != Sides::both || name(tree().number(leaf, place)) == ray_.leaving)
            return uncertain(leaf, place);
        is_hit = true;
        return nothing_more;
    }

    double test(std::uint32_t face, const Triangle& triangle) override {
        is_hit = is_hit || hit(face, triangle);
        return is_hit ? nothing_more : everything;
    }

    bool is_hit = false;
};

void Bvh8Instances::walk(Bvh8Walks::Walk how, const RayInMesh& ray, Leaves& leaves, Traversal& traversal) {
    const Bvh8Query query{ray.ray, ray.ray.range.max, Bvh8Query::leaves_none, ray.displacement};
    if (ray.displacement == std::numeric_limits<float>::infinity() || !how(leaves.tree(), query, leaves, traversal))
        leaves.test_all();
}

std::optional<RayInMesh> Bvh8Instances::carried(const Ray& ray, double end, const Instance& into) {
    // An instance's lines come from memory together: the bounds would be waited for, and then the map.
    for (std::size_t line = 1; line <= sizeof into / 64; ++line)
        __builtin_prefetch(reinterpret_cast<const std::byte*>(&into) + 64 * line);
    return into.map.carried(ray, end, into.bounds);
}

void Bvh8Instances::test(std::size_t i, const Ray& ray, double end, Nearest& nearest, Traversal& traversal) const {
    const Instance& instance = instances_[i];
    const auto in_mesh = carried(ray, end, instance);
    if (!in_mesh) return;
    NearestLeaves leaves(*scene_, instance, ray, *in_mesh, nearest, traversal);
    walk(walks_.candidates, *in_mesh, leaves, traversal);
}

bool Bvh8Instances::hits(std::size_t i, const Ray& ray, Traversal& traversal) const {
    const Instance& instance = instances_[i];
    const auto in_mesh = carried(ray, ray.range.max, instance);
    if (!in_mesh) return false;
    AnyLeaves leaves(*scene_, instance, ray, traversal);
    walk(walks_.any_candidate, *in_mesh, leaves, traversal);
    return leaves.is_hit;
}

}  // namespace raylab
