#include "raylab/accelerator/bvh8/bvh8_collapse.h"
#include "catch.h"
#include "raylab/experiment/adversarial/adversarial.h"

#include <algorithm>
#include <deque>
#include <numeric>

using namespace raylab;
using namespace raylab::adversarial;
using namespace raylab::bvh8_parts;

namespace {

// Boxes of very different sizes and shapes.
std::vector<Box> boxes_of(Draw& draw, int count) {
    std::vector<Box> boxes;
    for (int i = 0; i < count; ++i) {
        const Vec3f at = draw.in_cube(10);
        const auto length = [&] { return std::exp2(draw.uniform(-6, 4)); };
        boxes.push_back({at, at + Vec3f(length(), length(), length())});
    }
    return boxes;
}

// The expected work of a wide tree, and the references of its leaves.
struct Wide {
    double work = 0;
    std::vector<std::uint32_t> numbers = {};
    std::size_t most_children = 0;

    void add_leaf(const References& references, const ReferenceRange& part) {
        work += double{leaf_work} * double{part.box.half_area()};
        for (const Reference& one : references.of(part)) numbers.push_back(one.number());
    }
};

void add(Wide& wide, const References& references, const CollapsedTree& tree, CollapsedTree::Part node) {
    wide.work += double{tree.range(node).box.half_area()};
    const CollapsedTree::Children children = tree.children(node.at);
    wide.most_children = std::max(wide.most_children, children.count);
    for (std::size_t i = 0; i < children.count; ++i) {
        const CollapsedTree::Part child = children.parts[i];
        if (child.is_leaf)
            wide.add_leaf(references, tree.range(child));
        else
            add(wide, references, tree, child);
    }
}

// The same splits, where the child of the largest area is always divided next.
void add_greedily(Wide& wide, References& references, const ReferenceRange& part) {
    wide.work += double{part.box.half_area()};
    std::deque<ReferenceRange> parts{part};
    ThreadPool alone;
    while (parts.size() < bvh8_width) {
        const auto by_area = [&](const ReferenceRange& one) {
            return references.fit_in_leaf(one) ? -1 : one.box.half_area();
        };
        const auto largest = std::ranges::max_element(parts, {}, by_area);
        if (references.fit_in_leaf(*largest)) break;
        const auto [left, right] = references.split(*largest, 1, alone);
        *largest = left;
        parts.push_back(right);
    }
    for (const ReferenceRange& one : parts) {
        if (references.fit_in_leaf(one))
            wide.add_leaf(references, one);
        else
            add_greedily(wide, references, one);
    }
}

}  // namespace

TEST_CASE("of all wide trees over the same binary one, that of the least work is chosen") {
    Draw draw(3);
    ThreadPool alone;
    double chosen_work = 0, greedy_work = 0;
    for (int i = 0; i < 60; ++i) {
        const std::vector<Box> boxes = boxes_of(draw, draw.integer(9, 400));
        const TriangleRuns none;
        References once(none, boxes, {}, alone), again(none, boxes, {}, alone);
        const CollapsedTree tree(once, once.all(), 1);
        Wide chosen, greedy;
        add(chosen, once, tree, {CollapsedTree::root, false});
        add_greedily(greedy, again, again.all());
        CHECK(chosen.work <= greedy.work * 1.00001);
        CHECK(chosen.most_children <= bvh8_width);
        chosen_work += chosen.work;
        greedy_work += greedy.work;

        std::ranges::sort(chosen.numbers);
        std::vector<std::uint32_t> all(boxes.size());
        std::iota(all.begin(), all.end(), 0u);
        CHECK(chosen.numbers == all);
    }
    CHECK(chosen_work < .97 * greedy_work);
}

TEST_CASE("a part that is a leaf is its own child, and boxes without end are chosen, too") {
    const TriangleRuns none;
    const std::vector<Box> one{{Vec3f(0), Vec3f(1)}};
    ThreadPool alone;
    References single(none, one, {}, alone);
    const auto children = CollapsedTree(single, single.all(), 1).children(CollapsedTree::root);
    CHECK((children.count == 1 && children.parts[0].is_leaf));

    std::vector<Box> endless;
    for (int i = 0; i < 40; ++i) endless.push_back({Vec3f(-infinity), Vec3f(infinity)});
    References references(none, endless, {}, alone);
    Wide wide;
    add(wide, references, CollapsedTree(references, references.all(), 1), {CollapsedTree::root, false});
    CHECK(wide.numbers.size() == endless.size());
}
