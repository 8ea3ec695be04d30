#include "catch.h"
#include "geometry/verdict.h"
#include "tracer/shadow_ray_stage.h"

#include "raylab/base/tiles.h"
#include "raylab/experiment/shadow_oracle.h"
#include "raylab/tracer/shading/ray_start.h"

#include <mutex>

// A million shadow rays, started as the lab starts them, against the shadows of the exact points they stand for.

using namespace raylab;
using namespace raylab::shadow_rays;
using adversarial::Draw;

namespace {

// Anywhere on the viewer's side: steeply over the point, or low, or grazing.
Vec3d light_over(const Found& found, double scale, Draw& draw) {
    const Vec3d tangent = glm::normalize(cross(found.normal, direction(draw)));
    const double height = draw.one_in(3) ? std::pow(10, draw.number(-5, 0)) : draw.number(0.1, 3);
    return found.at.position +
           glm::normalize(tangent + height * found.normal) * (scale * std::pow(10, draw.number(-0.5, 1)));
}

struct Tally {
    std::size_t shadow_rays = 0, acne = 0, lost = 0;
    std::size_t near_edges = 0,
                at_edges = 0;  // an edge may be inside the band; one is, and the answer is that of its other side
    std::string first;

    void add(const Tally& other) {
        shadow_rays += other.shadow_rays, acne += other.acne, lost += other.lost, near_edges += other.near_edges,
            at_edges += other.at_edges;
        if (first.empty()) first = other.first;
    }
};

constexpr double grazing = 0x1p-20;  // of a light's height over the horizon: a direction in floats is off by 2^-24

void judge(const Stage& stage, const ShadowOracle& oracle, const Accelerator& accelerator, Draw& draw, Tally& tally) {
    const auto point = found(stage.scene, accelerator, stage.aimed(draw));
    if (!point) return;
    const Vec3d light = light_over(*point, stage.where.scale, draw);
    const Vec3d way = light - point->at.position;
    const double distance = glm::length(way);
    if (!(dot(way, point->normal) > grazing * distance)) return;
    ++tally.shadow_rays;
    Traversal traversal;
    const Ray ray = shadow_ray(point->at, {way / distance, distance, {}}, {}, point->ray, point->hit.t);
    const Shade said = accelerator.occluded(ray, traversal) ? Shade::blocked : Shade::lit;
    const ShadowQuestion question{point->ray, point->hit, light};
    const auto known = oracle.around(question);
    if (known == said) return;
    if (!known) {
        ++tally.near_edges;
        if (oracle.at(question) == said) return;
        if (oracle.edge_passes(question)) {
            ++tally.at_edges;
            return;
        }
    }
    ++(said == Shade::blocked ? tally.acne : tally.lost);
    if (tally.first.empty())
        tally.first = fmt::format("{} on {}: eye {}, light {:a} {:a} {:a}", said == Shade::blocked ? "acne" : "lost",
                                  stage.scene.objects[point->hit.primitive.object].shape.index(),
                                  adversarial::words(point->ray), light.x, light.y, light.z);
}

Tally shadow_rays_in(Where where, Kind kind, std::size_t rays, std::uint64_t seed) {
    constexpr std::size_t a_stage = 500;  // rays in each scene
    Tally all;
    std::mutex collecting;
    for_each_piece((rays + a_stage - 1) / a_stage, 1, 0, [&](std::size_t begin, std::size_t) {
        Draw draw(seed + begin);
        const Stage set = stage(where, kind, draw);
        const ShadowOracle oracle(set.scene);
        const auto accelerator = make_accelerator("auto", set.scene);
        Tally tally;
        for (std::size_t i = 0; tally.shadow_rays < a_stage && i < 8 * a_stage; ++i)
            judge(set, oracle, *accelerator, draw, tally);
        const std::lock_guard lock(collecting);
        all.add(tally);
    });
    return all;
}

}  // namespace

TEST_CASE("a million shadow rays: no acne and no lost contact shadow, but at the shadows' very edges") {
    Tally all;
    std::uint64_t seed = 1;
    const std::size_t share = adversarial::watched(1'000'000) / (kinds * places().size());
    for (const Where where : places())
        for (int kind = 0; kind < kinds; ++kind) {
            const Tally tally = shadow_rays_in(where, Kind(kind), share, seed += 1'000'000);
            INFO(fmt::format("scale {}, {} away, kind {}: {} of {} near edges; {}", where.scale, where.away, kind,
                             tally.near_edges, tally.shadow_rays, tally.first));
            CHECK(tally.acne == 0);
            CHECK(tally.lost == 0);
            all.add(tally);
        }
    INFO(fmt::format("{} shadow rays, {} near edges, {} at edges", all.shadow_rays, all.near_edges, all.at_edges));
    CHECK(all.shadow_rays > adversarial::watched(900'000));
    CHECK(all.near_edges < all.shadow_rays / 3);
    CHECK(all.at_edges < all.shadow_rays / 500);
}
