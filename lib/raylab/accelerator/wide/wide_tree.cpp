#include "raylab/accelerator/wide/wide_tree.h"

#include "raylab/accelerator/ray_box.h"
#include "raylab/accelerator/wide/wide_build.h"
#include "raylab/accelerator/wide/wide_walk.h"

#include <algorithm>
#include <memory>

namespace raylab {

namespace {

const Mesh* mesh_of(const Shape& shape) {
    const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&shape);
    return mesh ? mesh->get() : nullptr;
}

std::size_t parts_of(const Shape& shape) {
    const Mesh* mesh = mesh_of(shape);
    return mesh ? mesh->faces.size() : 1;
}

// Whether the floats of a leaf say all there is to know.
bool is_plain(const Object& object) {
    return object.placement.is_identity() && object.sides == Sides::both &&
           (mesh_of(object.shape) || std::holds_alternative<Triangle>(object.shape));
}

Triangle triangle_of(const Shape& shape, std::size_t part) {
    if (const Mesh* mesh = mesh_of(shape)) return mesh->triangle(part);
    return std::get<Triangle>(shape);
}

}  // namespace

// What the tree is built from.
struct WideTree::Sorted {
    std::vector<Run> runs;
    std::vector<Triangle> triangles;
    std::vector<Primitive> others, unbounded;
    std::vector<Box> boxes;  // of the others

    explicit Sorted(const Scene& scene) {
        for (std::uint32_t number = 0; number < scene.objects.size(); ++number) {
            const Object& object = scene.objects[number];
            const std::size_t parts = parts_of(object.shape);
            if (is_plain(object)) {
                runs.push_back({static_cast<std::uint32_t>(triangles.size()), number});
                triangles.reserve(triangles.size() + parts);
                for (std::size_t part = 0; part < parts; ++part) triangles.push_back(triangle_of(object.shape, part));
                continue;
            }
            for (std::uint32_t part = 0; part < parts; ++part) {
                const auto box = mesh_of(object.shape) ? bounds(triangle_of(object.shape, part), object.placement)
                                                       : bounds(object.shape, object.placement);
                (box ? others : unbounded).push_back({number, part});
                if (box) boxes.push_back(*box);
            }
        }
    }
};

WideTree::WideTree(const Scene& scene) : WideTree(scene, Sorted(scene)) {}

WideTree::WideTree(const Scene& scene, const Sorted& sorted)
    : scene_(&scene),
      runs_(sorted.runs),
      others_(scene, sorted.others),
      unbounded_(scene, sorted.unbounded),
      tree_(build_wide_nodes(sorted.triangles, sorted.boxes)) {}

std::size_t WideTree::bytes() const {
    return tree_.bytes() + others_.bytes() + unbounded_.bytes() + runs_.capacity() * sizeof(Run);
}

Primitive WideTree::primitive(std::size_t slot) const {
    const std::uint32_t number = tree_.triangles[slot];
    if (runs_.size() == 1) return {runs_[0].object, number};
    const auto after = std::upper_bound(runs_.begin(), runs_.end(), number,
                                        [](std::uint32_t n, const Run& run) { return n < run.first; });
    const Run& run = *(after - 1);
    return {run.object, number - run.first};
}

Triangle WideTree::triangle(WideChild leaf, std::size_t place) const {
    const float* rows = tree_.corners.data() + 9 * leaf.first() + place;
    const std::size_t count = leaf.count();
    const auto corner = [&](std::size_t vertex) {
        return Vec3f(rows[3 * vertex * count], rows[(3 * vertex + 1) * count], rows[(3 * vertex + 2) * count]);
    };
    return {corner(0), corner(1), corner(2)};
}

class WideTree::Leaves : public WideLeaves {
public:
    Leaves(const WideTree& tree, const Ray& ray, Traversal& traversal) : tree_(tree), ray_(ray), traversal_(traversal) {}

protected:
    std::optional<Candidate> meet(WideChild leaf, std::size_t place) {
        Decisions decisions;
        const auto candidate = intersect(ray_, tree_.triangle(leaf, place), decisions);
        traversal_.exact_decisions += decisions.exact;
        return candidate;
    }

    const WideTree& tree_;
    const Ray& ray_;
    Traversal& traversal_;
};

class WideTree::ClosestLeaves final : public Leaves {
public:
    ClosestLeaves(const WideTree& tree, const Ray& ray, Traversal& traversal) : Leaves(tree, ray, traversal), nearest_(ray) {
        for (std::size_t i = 0; i < tree.unbounded_.size(); ++i) tree.unbounded_.test(i, ray, nearest_, traversal);
    }

    double doubtful(WideChild leaf, std::size_t place) override {
        const auto candidate = meet(leaf, place);
        return candidate ? met(leaf, place, *candidate) : end();
    }

    double met(WideChild leaf, std::size_t place, const Candidate& at) override {
        const Primitive primitive = tree_.primitive(leaf.first() + place);
        const Object& object = tree_.scene_->objects[primitive.object];
        Decisions decisions;
        nearest_.offer(at, {&object.shape, primitive.part, &object.placement, object.sides}, primitive, decisions);
        traversal_.exact_decisions += decisions.exact;
        return end();
    }

    double met(WideChild leaf, std::size_t place) override { return doubtful(leaf, place); }

    double others(WideChild leaf) override {
        for (std::size_t i = leaf.first(); i < leaf.first() + leaf.count(); ++i)
            tree_.others_.test(tree_.tree_.others[i], ray_, nearest_, traversal_);
        return end();
    }

    double end() const { return std::min<double>(ray_.range.max, nearest_.limit()); }
    std::optional<Hit> hit() const { return nearest_.hit(); }

private:
    Nearest nearest_;
};

class WideTree::OccludedLeaves final : public Leaves {
public:
    using Leaves::Leaves;

    double doubtful(WideChild leaf, std::size_t place) override {
        return meet(leaf, place) ? met(leaf, place) : double{ray_.range.max};
    }

    double met(WideChild leaf, std::size_t place, const Candidate&) override { return met(leaf, place); }
    double met(WideChild leaf, std::size_t place) override { return stopped_by(leaf.first() + place); }

    double others(WideChild leaf) override {
        for (std::size_t i = leaf.first(); i < leaf.first() + leaf.count(); ++i) {
            const std::size_t other = tree_.tree_.others[i];
            if (tree_.others_.hits(other, ray_, traversal_)) return stopped_by(tree_.tree_.triangles.size() + other);
        }
        return ray_.range.max;
    }

    bool is_hit() const { return hit_; }

private:
    double stopped_by(std::size_t number) {
        traversal_.stopped_by(number);
        hit_ = true;
        return nothing_more;
    }
    bool hit_ = false;
};

namespace {

// In doubles, one box after the other and every triangle asked exactly: for rays that floats cannot hold.
class WalkInDoubles {
public:
    WalkInDoubles(const WideNodes& tree, const WideQuery& query, WideLeaves& leaves, Traversal& traversal)
        : tree_(tree), ray_(query.ray), leaving_(query.leaving), leaves_(leaves), traversal_(traversal) {
        ray_.set_end(query.end);
    }

    // False: nothing matters any more.
    bool visit(WideChild child) {
        if (child.kind() == WideChild::Kind::others) return go_on_to(leaves_.others(child));
        if (child.is_node()) return visit(tree_.nodes[child.first()]);
        for (std::size_t place = 0; place < child.count(); ++place) {
            if (tree_.triangles[child.first() + place] == leaving_) continue;
            ++traversal_.primitive_tests;
            if (!go_on_to(leaves_.doubtful(child, place))) return false;
        }
        return true;
    }

private:
    bool visit(const WideNode& node) {
        ++traversal_.steps;
        traversal_.box_tests += wide;
        std::array<double, wide> entries;
        std::array<std::size_t, wide> order;
        for (std::size_t i = 0; i < wide; ++i) {
            BoxTree::Planes planes;
            for (std::size_t row = 0; row < 6; ++row) planes[row].fill(node.planes[row][i]);
            entries[i] = ray_.entries(planes)[0];
            order[i] = i;
        }
        std::ranges::sort(order, {}, [&](std::size_t i) { return entries[i]; });
        for (const std::size_t i : order)
            if (ray_.reaches(entries[i]) && !visit(node.children[i])) return false;
        return true;
    }

    bool go_on_to(double end) {
        ray_.set_end(end);
        return end != WideLeaves::nothing_more;
    }

    const WideNodes& tree_;
    BoxRay ray_;
    std::uint32_t leaving_;
    WideLeaves& leaves_;
    Traversal& traversal_;
};

}  // namespace

void WideTree::walk(WideWalks::Walk how, const WideQuery& query, Leaves& leaves, Traversal& traversal) const {
    if (tree_.nodes.empty() || how(tree_, query, leaves, traversal)) return;
    WalkInDoubles(tree_, query, leaves, traversal).visit(WideChild::node(0));
}

std::uint32_t WideTree::number_left_by(const Ray& ray) const {
    if (ray.leaving == no_primitive) return WideQuery::leaves_none;
    for (const Run& run : runs_)
        if (run.object == ray.leaving.object) return run.first + ray.leaving.part;
    return WideQuery::leaves_none;
}

std::optional<Hit> WideTree::closest(const Ray& ray, Traversal& traversal) const {
    ClosestLeaves leaves(*this, ray, traversal);
    walk(walks_.nearest, {ray, leaves.end(), number_left_by(ray)}, leaves, traversal);
    return leaves.hit();
}

bool WideTree::occluded(const Ray& ray, Traversal& traversal) const {
    const std::size_t triangles = tree_.triangles.size();
    const auto hits = [&](std::size_t i) {
        if (i >= triangles) return others_.hits(i - triangles, ray, traversal);
        const Primitive p = primitive(i);
        if (p == ray.leaving) return false;
        Decisions decisions;
        ++traversal.primitive_tests;
        return intersect(ray, triangle_of(scene_->objects[p.object].shape, p.part), decisions).has_value();
    };
    if (traversal.stopped_again(hits)) return true;
    for (std::size_t i = 0; i < unbounded_.size(); ++i)
        if (unbounded_.hits(i, ray, traversal)) return true;
    OccludedLeaves leaves(*this, ray, traversal);
    walk(walks_.any, {ray, ray.range.max, number_left_by(ray)}, leaves, traversal);
    return leaves.is_hit();
}

}  // namespace raylab
