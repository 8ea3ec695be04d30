#include "raylab/accelerator/bvh8/bvh8_binary_top.h"
#include "catch.h"
#include "raylab/experiment/adversarial/adversarial.h"

#include <vector>

using namespace raylab;
using namespace raylab::adversarial;
using namespace raylab::bvh8_parts;

namespace {

constexpr std::size_t size = 700;

struct Ranges {
    std::vector<std::size_t> borders = {};  // where each part ends, depth first
    std::size_t split = 0;

    void add(const BinaryTop& top, const BinaryTop::Part& part) {
        borders.push_back(part.range.end);
        if (part.left == 0) {
            CHECK(part.range.size() <= size);
            return;
        }
        CHECK(part.range.size() > size);
        ++split;
        const auto [left, right] = top.halves(part, 1);
        CHECK(left.range.begin == part.range.begin);
        CHECK(left.range.end == right.range.begin);
        CHECK(right.range.end == part.range.end);
        add(top, left);
        add(top, right);
    }
};

}  // namespace

TEST_CASE("the binary top splits every large part, the same ones by any number of threads", "[threads]") {
    Draw draw(611);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 30'000; ++i) {
        const Vec3f at = draw.in_cube(10);
        triangles.push_back({at, at + draw.in_cube(.1f), at + draw.in_cube(.1f)});
    }
    const TriangleRuns runs(std::move(triangles));
    std::vector<std::size_t> first;
    for (const int count : {1, 2, 5}) {
        ThreadPool threads(count, 5);
        References references(runs, {}, {}, threads);
        const BinaryTop top(references, size, threads);
        Ranges found;
        for (const BinaryTop::Part& root : top.roots()) found.add(top, root);
        CHECK(found.split >= 30'000 / size);
        if (first.empty()) first = found.borders;
        CHECK(found.borders == first);
    }
}

TEST_CASE("a part below the binary top is split when it is asked for") {
    Draw draw(612);
    std::vector<Box> boxes;
    for (int i = 0; i < 100; ++i) {
        const Vec3f at = draw.in_cube(10);
        boxes.push_back({at, at + Vec3f(.5f)});
    }
    ThreadPool alone;
    const TriangleRuns none;
    References references(none, boxes, {}, alone);
    const BinaryTop top(references, size, alone);
    REQUIRE(top.roots().size() == 1);
    const BinaryTop::Part root = top.roots()[0];
    CHECK(root.left == 0);
    const auto [left, right] = top.halves(root, 1);
    CHECK((left.range.size() > 0 && right.range.size() > 0));
    CHECK(left.range.size() + right.range.size() == 100);
}
