#include "catch.h"

#include "raylab/tracer/traced_color.h"

#include <vector>

using namespace raylab;

namespace {

const Vec3d mirrored{0, 0, 1}, refracted{0, 0, -1}, background{0.1, 0.2, 0.3}, local{0.01, 0.02, 0.03};

struct Asked {
    Vec3d color;
    std::vector<int> depths;
};

Asked asked(int depth, const std::optional<TracedSurface>& nearest) {
    std::vector<int> depths;
    const auto color = traced_color({.depth = depth,
                                     .limit = 4,
                                     .nearest = nearest,
                                     .background = background,
                                     .trace = [&](const Vec3d& direction, int next) {
                                         depths.push_back(next);
                                         return direction == mirrored ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
                                     }});
    return {color, depths};
}

}  // namespace

TEST_CASE("a level adds the shares of its rays to the local colour") {
    const auto [color, depths] = asked(1, TracedSurface{local, 0.3, 0.5, mirrored, refracted});
    CHECK(glm::length(color - (local + Vec3d{0.3, 0.5, 0})) < 1e-15);
    CHECK(depths == std::vector{2, 2});
}

TEST_CASE("under total internal reflection the mirror ray has both shares") {
    CHECK(glm::length(asked(1, TracedSurface{local, 0.3, 0.5, mirrored, {}}).color - (local + Vec3d{0.8, 0, 0})) <
          1e-15);
}

TEST_CASE("no ray is traced beyond the limit, for a share of zero, or where nothing is hit") {
    CHECK(asked(3, TracedSurface{local, 0.3, 0.5, mirrored, refracted}).depths == std::vector{4, 4});
    CHECK(asked(4, TracedSurface{local, 0.3, 0.5, mirrored, refracted}).depths.empty());
    CHECK(asked(1, TracedSurface{local, 0, 0, mirrored, {}}).depths.empty());
    CHECK(asked(1, TracedSurface{local, 0, 0.5, mirrored, refracted}).depths.size() == 1);
    CHECK(asked(1, {}).color == background);
}
