#include "raylab/experiment/structure/structure_difference_search.h"

#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/primitives.h"
#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/experiment/adversarial/adversarial_rays.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/report/structure/structure_replay.h"
#include "rotating.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>

using namespace raylab;

namespace {

// Structures that are wrong on purpose: the tester must find and explain them.

/// The list, with answers that a subclass modifies.
class Wrapped : public Accelerator {
public:
    explicit Wrapped(const Scene& scene) : list_(make_accelerator("list", scene)) {}
    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override {
        return list_->closest(ray, traversal);
    }
    bool occluded(const Ray& ray, Traversal& traversal) const override { return list_->occluded(ray, traversal); }
    std::size_t bytes() const override { return list_->bytes(); }

protected:
    std::unique_ptr<Accelerator> list_;
};

/// Boxes tested by their slabs in floats, without an error bound, as most programs do.
class FloatBoxes final : public Wrapped {
public:
    explicit FloatBoxes(const Scene& scene) : Wrapped(scene), primitives_(scene) {}
    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override {
        Nearest nearest(ray);
        for (std::size_t i = 0; i < primitives_.size(); ++i)
            if (rays_hitting(ray, primitives_.bounds(i))) primitives_.test(i, ray, nearest, traversal);
        return nearest.hit();
    }

private:
    static bool rays_hitting(const Ray& ray, const std::optional<Box>& box) {
        float near = ray.range.min, far = ray.range.max;
        for (int axis = 0; box && axis < 3; ++axis) {
            const float inverse = 1 / ray.direction[axis];
            const float a = (box->min[axis] - ray.origin[axis]) * inverse,
                        b = (box->max[axis] - ray.origin[axis]) * inverse;
            near = std::max(near, std::min(a, b));
            far = std::min(far, std::max(a, b));
        }
        return near <= far;
    }
    Primitives primitives_;
};

/// Of equal hits the last one wins.
class LastWins final : public Wrapped {
public:
    explicit LastWins(const Scene& scene) : Wrapped(scene), scene_(scene) {}
    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override {
        auto hit = list_->closest(ray, traversal);
        for (std::uint32_t i = 0; hit && i < std::min<std::size_t>(30, scene_.objects.size()); ++i) {
            const Scene alone{.objects = {scene_.objects[i]}};
            Ray same = ray;
            same.leaving = no_primitive;
            const auto other = make_accelerator("list", alone)->closest(same, traversal);
            if (!other || other->t != hit->t) continue;
            const Primitive also{i, other->primitive.part};
            if (also != ray.leaving) hit->primitive = also;
        }
        return hit;
    }

private:
    const Scene& scene_;
};

/// Returns what it found for the previous ray, if that started at the same point.
class StaleMemory final : public Wrapped {
public:
    using Wrapped::Wrapped;
    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override {
        const auto hit = list_->closest(ray, traversal);
        const auto given = traversal.steps == 7 && hit ? std::optional<Hit>() : hit;  // 7: set by the previous ray
        traversal.steps = hit ? 7 : 0;
        return given;
    }
};

/// Claims that nothing beyond the first unit of t occludes.
class ShortSighted final : public Wrapped {
public:
    using Wrapped::Wrapped;
    bool occluded(const Ray& ray, Traversal& traversal) const override {
        const auto hit = list_->closest(ray, traversal);
        return hit && !(hit->t > 1);
    }
};

/// Gives each of several rays the answer of the previous one.
class MixesUp final : public Wrapped {
public:
    using Wrapped::Wrapped;
    std::vector<std::optional<Hit>> closest_of(std::span<const Ray> rays, Traversal& traversal) const override {
        auto hits = Accelerator::closest_of(rays, traversal);
        if (hits.size() > 1) std::ranges::copy_backward(hits.begin(), hits.end() - 1, hits.end());
        return hits;
    }
};

/// The same of whether there is any hit.
class MixesUpAny final : public Wrapped {
public:
    using Wrapped::Wrapped;
    std::vector<bool> occluded_of(std::span<const Ray> rays, Traversal& traversal) const override {
        auto occluded_rays = Accelerator::occluded_of(rays, traversal);
        std::rotate(occluded_rays.begin(), occluded_rays.begin() + (occluded_rays.size() > 1 ? 1 : 0),
                    occluded_rays.end());
        return occluded_rays;
    }
};

template <class Structure>
StructureMethod broken(const std::string& name) {
    return {name, "exact", [](const Scene& scene) { return std::make_unique<Structure>(scene); }};
}

StructureDifference found(const StructureMethod& method, std::uint64_t rays = 2'000) {
    const auto report = find_differences({.structures = {method}, .rays = rays, .oracle_every = 1'000'000});
    REQUIRE(report.differences.size() == 1);
    CHECK(report.wrong.at(method.name) > 0);
    return report.differences[0];
}

std::size_t primitives_in(const Scene& scene) { return Primitives(scene).size(); }

std::vector<StructureMethod> all_but_the_list() {
    std::vector<StructureMethod> methods;
    for (const std::string& name : accelerator_names())
        if (name != "list" && name != "auto") methods.push_back(structure_method(name));
    return methods;
}

struct RandomRays {
    std::uint64_t rays, seed;
};

// A quarter of so many rays, in each round of tests with a seed of its own: RAYLAB_TEST_ROUND repeats what one found.
RandomRays rotating(std::uint64_t rays) {
    const std::uint64_t watched = adversarial::watched(rays);
    if (all_are_tested() || watched < rays) return {watched, 1};  // a sanitizer watches few anyway
    return {rays / 4, 2 + test_round()};
}

void check_moving(const RandomRays& random) {
    const auto [rays, seed] = random;
    const auto report = find_differences({.structures = all_but_the_list(),
                                          .scenes = adversarial::moving_scene_kinds(),
                                          .rays = rays,
                                          .oracle_every = 10,
                                          .seed = seed});
    for (const auto& difference : report.differences) {
        INFO(to_json(difference));
        CHECK(difference.structure == "");
    }
    CHECK(report.wrong.empty());
    CHECK(report.total.oracle_rays * 20 > rays);
    CHECK(report.by_kind.size() == adversarial::moving_scene_kinds().size());
    for (const auto& [kind, count] : report.by_kind) {
        INFO(kind);
        CHECK(count.rays * 25 > rays);
        CHECK(count.hits * 20 > count.rays);
    }
}

}  // namespace

TEST_CASE("every structure answers a million hard rays as the list does, and the list ten thousand of them as the "
          "oracle does") {
    const auto structures = all_but_the_list();
    const auto [rays, seed] = rotating(1'000'000);
    const auto report = find_differences({.structures = structures, .rays = rays, .seed = seed});
    for (const auto& difference : report.differences) {
        INFO(to_json(difference));
        CHECK(difference.structure == "");
    }
    CHECK(report.wrong.empty());
    const DifferenceCount& total = report.total;
    CHECK(total.rays == rays);
    CHECK(total.oracle_rays >= total.rays / 110);  // one in a hundred, except in the large scenes
    CHECK(total.hits > total.rays / 8);            // about a sixth
    CHECK(report.by_kind.size() == adversarial::scene_kinds().size());
    for (const auto& [kind, count] : report.by_kind) {
        INFO(kind);
        CHECK(count.rays * 1000 > total.rays);
        CHECK((count.hits > 0) == (kind != "empty"));
    }
}

TEST_CASE("sizes from 2^-126 to 2^100: every structure answers a million rays as the list does, and the list as the "
          "oracle") {
    auto structures = all_but_the_list();
    for (const char* name : {"bvh_splits:1", "grid:0.5", "grid_mailbox:20", "octree:4"})
        structures.push_back(structure_method(name));
    const auto [rays, seed] = rotating(1'000'000);
    const auto report = find_differences({.structures = structures,
                                          .scenes = adversarial::exponent_scene_kinds(),
                                          .rays = rays,
                                          .oracle_every = 9,
                                          .together = 500,
                                          .seed = seed});
    for (const auto& difference : report.differences) {
        INFO(to_json(difference));
        CHECK(difference.structure == "");
    }
    CHECK(report.wrong.empty());
    CHECK(report.total.oracle_rays * 10 > rays);
    CHECK(report.total.together_rays == rays);
    CHECK(report.by_kind.size() == adversarial::exponent_scene_kinds().size());
    for (const auto& [kind, count] : report.by_kind) {
        INFO(kind);
        CHECK(count.rays * 25 > rays);
        CHECK(count.hits * 12 > count.rays);
    }
}

TEST_CASE("things that move: every structure answers rays of all times as the list does, and the list as the oracle") {
    check_moving(rotating(200'000));
}

TEST_CASE("a million rays at things that move", "[.million]") { check_moving({1'000'000, 1}); }

TEST_CASE("boxes in floats lose hits: found, and one primitive and one ray show it") {
    const auto difference = found(broken<FloatBoxes>("float boxes"));
    CHECK(primitives_in(difference.smallest.scene) == 1);
    REQUIRE(difference.smallest.rays.size() == 1);
    CHECK(difference.smallest.rays[0].leaving == no_primitive);
    CHECK(difference.answers.found == "closest: nothing");
}

TEST_CASE("a wrong order of equal hits is shown by two primitives") {
    const auto difference = found(broken<LastWins>("last wins"), 4'000);
    INFO(to_json(difference));
    CHECK(primitives_in(difference.smallest.scene) == 2);
    CHECK(difference.smallest.rays.size() == 1);
}

TEST_CASE("what goes wrong only after another ray is shown by two rays") {
    const auto difference = found(broken<StaleMemory>("stale memory"));
    CHECK(primitives_in(difference.smallest.scene) <= 2);
    CHECK(difference.smallest.rays.size() == 2);
}

TEST_CASE("a false occluded() is found, too") {
    const auto difference = found(broken<ShortSighted>("short-sighted"));
    CHECK(primitives_in(difference.smallest.scene) == 1);
    CHECK(difference.answers.expected == "occluded: yes");
    CHECK(difference.answers.found == "occluded: no");
}

TEST_CASE("rays asked together get answers of their own, or two of them show it") {
    const auto difference = found(broken<MixesUp>("mixes up"));
    CHECK(primitives_in(difference.smallest.scene) == 1);
    CHECK(difference.smallest.rays.size() == 2);
    CHECK(difference.answers.found.starts_with("closest_of, ray 1"));

    const auto of_any = found(broken<MixesUpAny>("mixes up any"));
    CHECK(primitives_in(of_any.smallest.scene) == 1);
    CHECK(of_any.smallest.rays.size() == 2);
    CHECK(of_any.answers.found.starts_with("occluded_of, ray "));
}

TEST_CASE("what is found does not depend on the number of threads", "[threads]") {
    const auto once = find_differences({.structures = {broken<FloatBoxes>("b")}, .rays = 1'500, .threads = 1});
    const auto again = find_differences({.structures = {broken<FloatBoxes>("b")}, .rays = 1'500, .threads = 3});
    CHECK(once.wrong == again.wrong);
    CHECK(to_json(once.differences.at(0)) == to_json(again.differences.at(0)));
}

TEST_CASE("a difference comes back from its file as it was, and still shows the difference") {
    const auto file =
        std::filesystem::temp_directory_path() / ("raylab_difference_" + std::to_string(getpid()) + ".json");
    for (const auto& method : {broken<FloatBoxes>("float boxes"), broken<StaleMemory>("stale memory")}) {
        const auto difference = found(method);
        write_file(file, to_json(difference));
        const auto back = read_difference(file);
        CHECK(back.smallest.rays.size() == difference.smallest.rays.size());
        const auto answers = judge_by_list(method)(back.smallest);
        REQUIRE(answers);
        CHECK(answers->expected == difference.answers.expected);
        CHECK(answers->found == difference.answers.found);
        CHECK_FALSE(judge_by_list(structure_method("bvh"))(back.smallest));
    }
    std::filesystem::remove(file);
}

TEST_CASE("every kind of scene survives its file") {
    const auto file = std::filesystem::temp_directory_path() / ("raylab_kinds_" + std::to_string(getpid()) + ".json");
    adversarial::Draw draw(3);
    StructureDifference difference{
        .structure = "x", .smallest = {{}, {Ray{{0, 0, 1e-40f}, {-0.0f, 0, 1}, {-1, 2}, {3, 4}}}}, .answers = {}};
    for (const auto& kind : adversarial::every_scene_kind())
        for (int i = 0; i < 5; ++i) {
            INFO(kind.name);
            difference.smallest.scene = kind.make(draw);
            const std::string text = to_json(difference);
            write_file(file, text);
            const auto back = read_difference(file);
            CHECK(to_json(StructureDifference{back.structure, back.scene_kind, back.ray_kind, difference.seed,
                                              difference.piece, back.smallest, back.answers}) == text);
            const Ray& ray = back.smallest.rays.at(0);
            CHECK(std::signbit(ray.direction.x));
            CHECK(ray.origin.z == 1e-40f);
            CHECK(ray.leaving == Primitive{3, 4});
        }
    std::filesystem::remove(file);
}

TEST_CASE("a file that is no difference is refused with the place and what was expected") {
    const auto file = std::filesystem::temp_directory_path() / ("raylab_refused_" + std::to_string(getpid()) + ".json");
    const std::string good =
        R"({"raylab":"difference","structure":"a","scene":"b","rays_aimed":"c","expected":"d","found":"e",)";
    for (const auto& [text, expected] :
         {std::pair<std::string, std::string>{"{", "expected JSON"},
          {"[]", "expected a field \"raylab\""},
          {good + R"("objects":[],"rays":[]})", "/rays: expected at least one ray"},
          {good + R"("objects":[{"shape":"teapot"}],"rays":[]})",
           "/objects/0/shape: expected a shape's name, found \"teapot\""},
          {good + R"("objects":[{"shape":"sphere","center":[0,1],"radius":1}],"rays":[]})",
           "/objects/0/center: expected three numbers"},
          {good + R"("objects":[{"shape":"sphere","center":[0,1,1e39],"radius":1}],"rays":[]})",
           "/center/2: expected a finite number that fits a float"},
          {good + R"("objects":[{"shape":"sphere","center":[0,1,"infinity"],"radius":1}],"rays":[]})",
           "/center/2: expected a finite number"},
          {std::string(200'000, '['), "nested at most 64 deep"},
          {good + R"("objects":[],"rays":)" + std::string(100'000, '[') + std::string(100'000, ']') + "}",
           "nested at most 64 deep"},
          {good + R"("objects":[{"shape":"mesh","vertices":[],"faces":[[0,1,2]]}],"rays":[]})",
           "faces: expected indices of vertices"},
          {good + R"("objects":[],"rays":[{"origin":[0,0,0],"direction":[0,0,0],"range":[0,1]}]})",
           "a direction that is not zero"}}) {
        write_file(file, text);
        try {
            read_difference(file);
            FAIL("taken: " + text);
        } catch (const Error& error) {
            INFO(error.what());
            CHECK(std::string(error.what()).find(expected) != std::string::npos);
        }
    }
    std::filesystem::remove(file);
}

TEST_CASE("scenes and rays are as hard as their names say") {
    adversarial::Draw draw(1);
    std::set<std::string> names;
    const auto kinds = adversarial::every_scene_kind();
    for (const auto& kind : kinds) names.insert(kind.name);
    CHECK(names.size() == kinds.size());
    for (const auto& kind : kinds) {
        const adversarial::SceneRays rays(kind.make(draw));
        for (std::size_t which = 0; which < adversarial::SceneRays::kinds().size(); ++which)
            for (int i = 0; i < 50; ++i) {
                const Ray ray = rays.draw(draw, which);
                INFO(kind.name << ", " << adversarial::SceneRays::kinds()[which]);
                CHECK(ray.direction != Vec3f(0));
                CHECK((std::isfinite(ray.origin.x) && std::isfinite(ray.direction.x)));
            }
    }
}
