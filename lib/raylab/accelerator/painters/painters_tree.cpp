#include "raylab/accelerator/painters/painters_tree.h"

#include "raylab/accelerator/painters/cut_piece.h"
#include "raylab/base/error.h"
#include "raylab/geometry/shape_parts.h"
#include "raylab/scene/moving.h"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>
#include <utility>

namespace raylab {

namespace {

using Piece = PaintersTree::Piece;

// Of this many triangles, spread evenly over the remaining ones, the one whose plane cuts the fewest is taken.
constexpr std::size_t candidates = 8;

std::vector<PaintersTree::Placed> triangles_of(const Scene& scene) {
    std::vector<PaintersTree::Placed> result;
    for (std::uint32_t number = 0; number < scene.objects.size(); ++number) {
        const Object& object = scene.objects[number];
        const bool is_triangles = as_mesh(object.shape) || std::holds_alternative<Triangle>(object.shape);
        if (!is_triangles || !object.placement.is_identity() || motion_of(scene, object))
            throw Error(scene.source + ": expected triangles that stand where they were made, found " + object.path);
        for (std::uint32_t part = 0; part < part_count(object.shape); ++part) {
            const Triangle triangle = *triangle_of(object.shape, part);
            if (has_plane(triangle))
                result.push_back({triangle, {&object.shape, part, &object.placement, object.sides}, {number, part}});
        }
    }
    return result;
}

struct Pile {
    std::vector<Piece> pieces;
    std::optional<std::uint32_t> parent;
    Sign side = Sign::zero;  // the side of the parent's plane
};

class Builder {
public:
    explicit Builder(const std::vector<PaintersTree::Placed>& triangles) : triangles_(triangles) {}

    std::vector<PaintersTree::Node> build() {
        Pile all;
        for (std::uint32_t i = 0; i < triangles_.size(); ++i)
            all.pieces.push_back(whole_piece(triangles_[i].corners, i));
        std::vector<Pile> piles;
        if (!all.pieces.empty()) piles.push_back(std::move(all));
        // Not recursive, because in a convex shape all triangles lie behind one another, and the tree is as deep as
        // there are triangles.
        while (!piles.empty()) {
            Pile pile = std::move(piles.back());
            piles.pop_back();
            for (Pile& half : divide(std::move(pile)))
                if (!half.pieces.empty()) piles.push_back(std::move(half));
        }
        return std::move(nodes_);
    }

private:
    std::array<Pile, 2> divide(Pile pile) {
        const auto index = static_cast<std::uint32_t>(nodes_.size());
        const std::uint32_t plane = best_plane(pile.pieces);
        nodes_.push_back({plane, {}});
        if (pile.parent)
            (pile.side == Sign::negative ? nodes_[*pile.parent].behind : nodes_[*pile.parent].before) = index;
        std::array<Pile, 2> halves{Pile{{}, index, Sign::negative}, Pile{{}, index, Sign::positive}};
        for (Piece& piece : pile.pieces) {
            Halves parts = divided(piece, triangles_[piece.triangle].corners, triangles_[plane].corners, plane);
            if (parts.inside) nodes_[index].pieces.push_back(std::move(*parts.inside));
            if (parts.behind) halves[0].pieces.push_back(std::move(*parts.behind));
            if (parts.before) halves[1].pieces.push_back(std::move(*parts.before));
        }
        std::ranges::sort(nodes_[index].pieces, std::ranges::greater{}, &Piece::triangle);
        return halves;
    }

    std::uint32_t best_plane(const std::vector<Piece>& pieces) const {
        std::uint32_t best = pieces.front().triangle;
        std::size_t smallest = std::numeric_limits<std::size_t>::max();
        const std::size_t step = std::max<std::size_t>(1, pieces.size() / candidates);
        for (std::size_t i = 0; i < pieces.size(); i += step) {
            const std::size_t found = cost(pieces, triangles_[pieces[i].triangle].corners);
            if (found < smallest) std::tie(smallest, best) = std::pair(found, pieces[i].triangle);
        }
        return best;
    }

    // A cut makes one piece more; a lopsided tree only makes traversals longer.
    static std::size_t cost(const std::vector<Piece>& pieces, const Triangle& plane) {
        std::size_t cut = 0, behind = 0, before = 0;
        for (const Piece& piece : pieces) {
            const Reach sides = reach(piece, plane);
            cut += sides.behind && sides.before;
            behind += !sides.before;
            before += !sides.behind;
        }
        return 8 * cut + (behind > before ? behind - before : before - behind);
    }

    const std::vector<PaintersTree::Placed>& triangles_;
    std::vector<PaintersTree::Node> nodes_;
};

}  // namespace

PaintersTree::PaintersTree(const Scene& scene) : triangles_(triangles_of(scene)), nodes_(Builder(triangles_).build()) {}

std::size_t PaintersTree::pieces() const {
    std::size_t sum = 0;
    for (const Node& node : nodes_) sum += node.pieces.size();
    return sum;
}

std::size_t PaintersTree::depth() const {
    std::vector<std::size_t> depth(nodes_.size(), 1);
    for (std::size_t i = 0; i < nodes_.size(); ++i)  // parents stand before their children
        for (const auto& child : {nodes_[i].behind, nodes_[i].before})
            if (child) depth[*child] = depth[i] + 1;
    return nodes_.empty() ? 0 : *std::ranges::max_element(depth);
}

std::vector<PaintersTree::Turn> PaintersTree::back_to_front(const Vec3f& origin) const {
    struct Step {
        std::uint32_t node;
        enum class What { walk, paint } what;
        bool unordered;
    };
    std::vector<Turn> order;
    std::vector<Step> steps;
    if (!nodes_.empty()) steps.push_back({0, Step::What::walk, false});
    DecisionCounts decisions;
    while (!steps.empty()) {
        const auto [index, what, above] = steps.back();
        steps.pop_back();
        const Node& node = nodes_[index];
        if (what == Step::What::paint) {
            for (const Piece& piece : node.pieces) order.push_back({&piece, above || piece.rounded});
            continue;
        }
        const Sign eye = side(triangles_[node.plane].corners, origin, decisions);
        const bool unordered = above || eye == Sign::zero;
        const auto near = eye == Sign::negative ? node.behind : node.before,
                   far = eye == Sign::negative ? node.before : node.behind;
        if (near) steps.push_back({*near, Step::What::walk, unordered});  // pushed last, so visited first
        steps.push_back({index, Step::What::paint, unordered});
        if (far) steps.push_back({*far, Step::What::walk, unordered});
    }
    return order;
}

}  // namespace raylab
