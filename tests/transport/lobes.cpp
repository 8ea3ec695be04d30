#include "catch.h"
#include "sampling/direction_cells.h"

#include "raylab/sampling/sequence.h"
#include "raylab/tracer/refracted_direction.h"
#include "raylab/transport/lobe/lobe.h"

#include <string>

#include <fmt/format.h>

using namespace raylab;

namespace {

constexpr std::uint64_t samples = 20'000;
constexpr double degree = std::numbers::pi / 180;
// Of the hundred chi-square tests below one in a million runs with other seeds would find a fault where none is.
constexpr double alpha = 1e-8;

struct NamedLobe {
    std::string name;
    Vec3d wo;
    Lobe lobe;
};

Vec3d seen_at(double angle) { return {std::sin(angle * degree), 0, std::cos(angle * degree)}; }

std::vector<NamedLobe> lobes() {
    std::vector<NamedLobe> all;
    for (const double angle : {0.0, 30.0, 60.0, 85.0}) {
        const Vec3d wo = seen_at(angle);
        const auto add = [&](const std::string& name, const Lobe& lobe) {
            all.push_back({name + fmt::format(" at {} degrees", angle), wo, lobe});
        };
        add("diffuse", DiffuseLobe{{0.7, 0.5, 0.2}});
        for (const double n : {1.0, 20.0, 500.0}) {
            add(fmt::format("gloss {}", n), GlossLobe{0.8, n, mirrored_about_z(wo)});
            add(fmt::format("gloss {} through", n), GlossLobe{0.8, n, *refracted_direction(-wo, {0, 0, 1}, 1, 1.5)});
        }
        for (const double a : {0.1, 0.3, 1.0}) {
            add(fmt::format("rough mirror {}", a), RoughLobe{0.9, 0, a, 1, 1});
            add(fmt::format("rough glass {}", a), RoughLobe{0.2, 0.7, a, 1, 1.5});
            add(fmt::format("rough glass {} from inside", a), RoughLobe{0.2, 0.7, a, 1.5, 1});
            add(fmt::format("rough glass {} by Fresnel", a), RoughLobe{0.2, 0.8, a, 1, 1.5, FacetShares::fresnel});
            add(fmt::format("rough water {} by Fresnel from inside", a),
                RoughLobe{0.2, 0.8, a, 1.33, 1, FacetShares::fresnel});
        }
    }
    return all;
}

double any_channel(const Color& color) { return color.g; }

// The cells above the surface and, turned upside down, those below it.
struct BothSides {
    DirectionCells above{0, 40, 24}, below{0, 40, 24};

    void add(const std::optional<LobeSample>& sample) {
        const bool is_above = sample && sample->direction.z > 0, is_below = sample && !is_above;
        if (is_above)
            above.add(sample->direction);
        else
            above.add_none();
        if (is_below)
            below.add(turned(sample->direction));
        else
            below.add_none();
    }
    static Vec3d turned(const Vec3d& d) { return {d.x, d.y, -d.z}; }
};

// What the integrals over narrow lobes err by.
constexpr double of_parts = 4e-3;

}  // namespace

TEST_CASE("every lobe's samples have the density that it says, above the surface and below", "[long]") {
    for (const auto& [name, wo, lobe] : lobes()) {
        BothSides sides;
        for (std::uint64_t i = 0; i < samples; ++i) {
            RandomSequence random(51, i);
            const double u = random.next();
            const auto drawn = sample(lobe, wo, {u, random.next()});
            if (drawn && i < 300) {
                CHECK_THAT(pdf(lobe, wo, drawn->direction), WithinRel(drawn->pdf, 1e-6));
                const Color expected = value(lobe, wo, drawn->direction) / drawn->pdf;
                CHECK_THAT(drawn->weight.g, WithinRel(expected.g, 1e-6) || WithinAbs(0, 1e-300));
            }
            sides.add(drawn);
        }
        const auto wo_here = wo;
        const auto kind = lobe;
        const auto above = sides.above.integrals([&](const Vec3d& wi) { return pdf(kind, wo_here, wi); });
        const auto below =
            sides.below.integrals([&](const Vec3d& wi) { return pdf(kind, wo_here, BothSides::turned(wi)); });
        INFO(name << ": " << 1 - above.back() << " above, " << 1 - below.back() << " below");
        CHECK(sides.above.p_value(above) > alpha);
        CHECK(sides.below.p_value(below) > alpha);
        CHECK_THAT(above.back(), WithinAbs(sides.above.share_of_none(), 0.02));  // more than five standard errors
        CHECK_THAT(below.back(), WithinAbs(sides.below.share_of_none(), 0.02));
        CHECK(2 - above.back() - below.back() < 1 + of_parts);
    }
}

TEST_CASE("white furnace: no lobe returns more light than it gets, and the mean weight is the integral of its value",
          "[long]") {
    for (const auto& [name, wo, lobe] : lobes()) {
        double sum = 0, squares = 0;
        for (std::uint64_t i = 0; i < samples; ++i) {
            RandomSequence random(53, i);
            const double u = random.next();
            const auto drawn = sample(lobe, wo, {u, random.next()});
            const double weight = drawn ? any_channel(drawn->weight) : 0;
            sum += weight;
            squares += weight * weight;
        }
        const double mean = sum / samples, error = std::sqrt((squares / samples - mean * mean) / samples);
        const auto wo_here = wo;
        const auto kind = lobe;
        const DirectionCells cells(0, 40, 24);
        double integral = 0;
        for (const double side : {1.0, -1.0})
            integral += 1 - cells
                                .integrals([&](const Vec3d& wi) {
                                    return any_channel(value(kind, wo_here, Vec3d{wi.x, wi.y, side * wi.z}));
                                })
                                .back();
        INFO(name << ": " << mean << " +- " << error << ", " << integral);
        CHECK(std::abs(mean - integral) < 4.5 * error + of_parts);  // 60 lobes: one false alarm in 2000 sets of seeds
        CHECK(mean < 1 + 4 * error);
    }
}

TEST_CASE("white furnace, exactly: a diffuse lobe keeps its albedo, and Phong's at normal incidence all of k") {
    const Vec3d wo = seen_at(40);
    const auto drawn = DiffuseLobe{{0.7, 0.5, 0.25}}.sample(wo, {0.3, 0.8});
    CHECK_THAT(drawn->weight.r, WithinRel(0.7, 1e-15));
    CHECK_THAT(drawn->weight.b, WithinRel(0.25, 1e-15));
    for (const double n : {1.0, 50.0, 1e6}) {
        // cos^(n + 1) of the lobe is a uniform number t, and the integral of t^(1 / (n + 1)) is (n + 1) / (n + 2). The
        // midpoints of 10^5 intervals know it to nine digits.
        const GlossLobe lobe{0.8, n, {0, 0, 1}};
        double sum = 0;
        for (int i = 0; i < 100'000; ++i) sum += lobe.sample({0, 0, 1}, {(i + 0.5) / 100'000, 0.5})->weight.g / 100'000;
        CHECK_THAT(sum, WithinRel(0.8, 1e-7));
    }
    // A facet that neither hides nor is hidden mirrors all: as roughness vanishes, kr remains.
    CHECK_THAT((RoughLobe{0.9, 0, 1e-4, 1, 1}.sample(wo, {0.3, 0.8})->weight.g), WithinRel(0.9, 1e-6));
}

TEST_CASE("light may go either way: f is the same from wi to wo, and through a surface up to the indices squared") {
    for (std::uint64_t i = 0; i < 2000; ++i) {
        RandomSequence random(57, i);
        Vec3d wo = random.unit_vector(), wi = random.unit_vector();
        wo.z = std::abs(wo.z) + 1e-3;
        wi.z = std::abs(wi.z) + 1e-3;
        wo = glm::normalize(wo);
        wi = glm::normalize(wi);
        const auto f = [](const auto& lobe, const Vec3d& to, const Vec3d& from) {
            return lobe.value(to, from).g / std::abs(from.z);
        };
        const double there = f(GlossLobe{0.5, 8, mirrored_about_z(wo)}, wo, wi);
        CHECK_THAT(f(GlossLobe{0.5, 8, mirrored_about_z(wi)}, wi, wo), WithinRel(there, 1e-10));
        for (const auto shares : {FacetShares::coefficients, FacetShares::fresnel}) {
            const RoughLobe above{0.3, 0.6, 0.4, 1.2, 1.5, shares}, below{0.3, 0.6, 0.4, 1.5, 1.2, shares};
            CHECK_THAT(f(above, wi, wo), WithinRel(f(above, wo, wi), 1e-9));
            const Vec3d through{wi.x, wi.y, -wi.z};
            const Vec3d out{wo.x, wo.y, -wo.z};
            CHECK_THAT(f(below, wi, out) * 1.5 * 1.5,
                       WithinRel(f(above, wo, through) * 1.2 * 1.2, 1e-9) || WithinAbs(0, 1e-12));
        }
    }
}

TEST_CASE("nothing is scattered to the wrong side") {
    const Vec3d wo = seen_at(50), above = seen_at(-20), below{above.x, 0, -above.z};
    CHECK(DiffuseLobe{Color(1)}.value(wo, below) == Color(0));
    CHECK(GlossLobe{1, 5, mirrored_about_z(wo)}.value(wo, below) == Color(0));
    CHECK(GlossLobe{1, 5, *refracted_direction(-wo, {0, 0, 1}, 1, 1.5)}.value(wo, above) == Color(0));
    CHECK(RoughLobe{1, 0, 0.5, 1, 1.5}.value(wo, below) == Color(0));
    CHECK(RoughLobe{1, 0, 0.5, 1, 1.5}.pdf(wo, below) == 0);
}

TEST_CASE("a density that is one hundredth too large is found by 10^6 samples of the diffuse lobe") {
    const DiffuseLobe lobe{Color(0.5)};
    double right = 0, wrong = 0;
    constexpr int trials = 1'000'000;
    for (std::uint64_t i = 0; i < trials; ++i) {
        RandomSequence random(59, i);
        const double u = random.next();
        const auto drawn = *lobe.sample({0, 0, 1}, {u, random.next()});
        const double estimate = drawn.direction.z / drawn.pdf;  // of the integral of cos, which is pi
        right += estimate / trials;
        wrong += drawn.direction.z / (1.01 * drawn.pdf) / trials;
    }
    CHECK_THAT(right, WithinRel(std::numbers::pi, 1e-9));  // no variance: the density is in proportion
    CHECK(std::abs(wrong / std::numbers::pi - 1) > 5e-3);
}
