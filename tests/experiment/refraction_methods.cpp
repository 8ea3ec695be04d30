#include "catch.h"

#include "raylab/experiment/refraction_methods.h"
#include "raylab/sampling/sequence.h"
#include "raylab/tracer/refracted_direction.h"

using namespace raylab;

TEST_CASE("every method of refraction agrees with the exact answer where nothing is delicate") {
    RandomSequence random(4, 0);
    std::vector<RefractionQuery> queries;
    while (queries.size() < 500) {
        const Vec3d n = random.unit_vector(), d = random.unit_vector();
        const double cosine = -dot(d, n), sine_squared = 1 - cosine * cosine;
        const float before = cast<float>(random.between(1, 2)), behind = cast<float>(random.between(1, 2));
        const double sine_behind_squared = before / behind * double{before} / behind * sine_squared;
        if (cosine < 0.2 || cosine > 0.98 || std::abs(sine_behind_squared - 1) < 0.05) continue;
        queries.push_back({convert<float>(d * random.between(0.1, 3)), convert<float>(n), before, behind});
    }
    auto methods = refraction_methods();
    methods.push_back(your_refraction_method());
    for (const auto& method : methods) {
        INFO(method.title());
        const double tolerance = method.number == "float" ? 3e-6 : 1e-14;
        std::vector<std::optional<Vec3d>> answers(queries.size());
        method.answer({}, {}, queries, answers);
        for (std::size_t i = 0; i < queries.size(); ++i) {
            const auto truth = exact_refraction(queries[i]);
            REQUIRE(truth.has_value() == answers[i].has_value());
            if (truth) CHECK(glm::length(*truth - *answers[i]) < tolerance);
        }
    }
}

TEST_CASE("straight against the normal every method goes straight on, however the vectors' lengths are rounded") {
    RandomSequence random(12, 0);
    std::vector<RefractionQuery> queries;
    for (int i = 0; i < 2000; ++i) {
        const Vec3f normal = convert<float>(random.unit_vector() * random.between(0.1, 3));
        queries.push_back({-normal, normal, cast<float>(random.between(1, 2)), cast<float>(random.between(1, 2))});
    }
    auto methods = refraction_methods();
    methods.push_back(your_refraction_method());
    for (const auto& method : methods) {
        INFO(method.title());
        // An angle of 0 is known to the square root of what its cosine is known to.
        const double tolerance =
            4 * std::sqrt(2 * (method.number == "float" ? unit_roundoff<float> : unit_roundoff<double>));
        std::vector<std::optional<Vec3d>> answers(queries.size());
        method.answer({}, {}, queries, answers);
        for (std::size_t i = 0; i < queries.size(); ++i) {
            REQUIRE(answers[i]);
            CHECK(glm::length(*answers[i] - glm::normalize(convert<double>(queries[i].direction))) < tolerance);
        }
    }
}

TEST_CASE("the exact answer keeps Snell's law for vectors of any length") {
    const auto refracted = exact_refraction({{3, -4, 0}, {0, 7, 0}, 1, 2});  // sine 3/5 becomes 3/10
    REQUIRE(refracted);
    CHECK_THAT(refracted->x, WithinAbs(0.3, 1e-16));
    CHECK_THAT(refracted->y, WithinAbs(-std::sqrt(0.91), 1e-16));
    const auto critical = exact_refraction({{3, -4, 0}, {0, 7, 0}, 5, 3});
    REQUIRE(critical);
    CHECK(glm::length(*critical - Vec3d{1, 0, 0}) < 1e-15);
    CHECK_FALSE(exact_refraction({{3, -4, 0}, {0, 7, 0}, 5.0000005f, 3}));
}
