#include "catch.h"

#include "raylab/experiment/transform/normal_methods.h"
#include "raylab/geometry/transformed_normal.h"
#include "raylab/sampling/sequence.h"

using namespace raylab;

namespace {

using Columns = std::array<Vec3d, 3>;

void check_same(const Vec3d& a, const Vec3d& b, double tolerance) {
    INFO("(" << a.x << " " << a.y << " " << a.z << ") and (" << b.x << " " << b.y << " " << b.z << ")");
    CHECK(glm::length(a - b) <= tolerance);
}

}  // namespace

TEST_CASE("a rotation carries normals like points") {
    const Columns quarter{Vec3d{0, 1, 0}, Vec3d{-1, 0, 0}, Vec3d{0, 0, 1}};
    check_same(transformed_normal(quarter, {1, 0, 0}), {0, 1, 0}, 0);
}

TEST_CASE("a pressed surface's normals turn toward the pressing") {
    const Columns pressed{Vec3d{1, 0, 0}, Vec3d{0, 0.5, 0}, Vec3d{0, 0, 1}};
    check_same(transformed_normal(pressed, {1, 1, 0}), glm::normalize(Vec3d{1, 2, 0}), 1e-15);
}

TEST_CASE("under a mirror a normal stays on its side") {
    const Columns mirror{Vec3d{-1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
    check_same(transformed_normal(mirror, {0, 1, 0}), {0, 1, 0}, 0);
    check_same(transformed_normal(mirror, {1, 0, 0}), {-1, 0, 0}, 0);
}

TEST_CASE("the normal is unit whatever the map's size and the normal's length") {
    const Columns tiny{Vec3d{1e-40, 0, 0}, Vec3d{0, 2e-40, 0}, Vec3d{0, 0, 1e-40}};
    check_same(transformed_normal(tiny, {0, 7, 0}), {0, 1, 0}, 1e-15);
}

TEST_CASE("the double methods and the slot agree with exact tangents; the mistakes do not") {
    std::vector<NormalQuery> queries;
    for (std::uint64_t sample = 0; sample < 500; ++sample) {
        RandomSequence random(6, 0, sample);
        const auto column = [&](int axis) {
            Vec3d v = random.unit_vector() * 0.3;
            v[axis] += random.between(0, 1) < 0.5 ? -1 : 1;
            return convert<float>(v);
        };
        const Vec3f x = column(0), y = column(1), z = column(2);
        queries.push_back({{x, y, z}, convert<float>(random.unit_vector())});
    }
    auto methods = normal_methods();
    methods.push_back(your_normal_method());
    for (const auto& method : methods) {
        std::vector<Vec3d> answers(queries.size());
        method.answer({}, {}, queries, answers);
        double worst = 0;
        for (std::size_t i = 0; i < queries.size(); ++i)
            worst = std::max(worst, glm::length(answers[i] - exact_normal(queries[i])));
        INFO(method.title() << " is off by " << worst);
        const bool mistake = method.name == "like a point" || method.name == "cofactors, sign forgotten";
        CHECK((mistake ? worst > 0.3 : worst < (method.number == "float" ? 1e-5 : 1e-14)));
    }
}
