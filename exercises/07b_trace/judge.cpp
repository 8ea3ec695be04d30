#include "07b_trace/slot.h"
#include "arguments.h"
#include "dice.h"
#include "exercise_list.h"
#include "known.h"
#include "symptoms.h"
#include "traced_scene.h"
#include "words.h"

#include "raylab/experiment/textbook/textbook.h"
#include "raylab/report/ray_tree/ray_tree_view.h"

#include <algorithm>
#include <cmath>

namespace raylab::grading {

namespace {

using namespace trace;

constexpr double tolerance = 1e-9;  // of the largest colour in the level

// A level in words, from which a case is made.
struct Level {
    int depth, limit;
    std::optional<TracedSurface> nearest;
    Vec3d mirrored_brings, refracted_brings, background;
};

Case make(const std::string& group, Case::Kind kind, const Level& level) {
    Case question{group, kind, {}};
    const auto number = [&](double value) { question.input.push_back(value); };
    const auto vector = [&](const Vec3d& v) { question.input.insert(question.input.end(), {v.x, v.y, v.z}); };
    const TracedSurface surface = level.nearest.value_or(TracedSurface{{0, 0, 0}, 0, 0, {0, 0, 0}, {}});
    number(level.depth);
    number(level.limit);
    number(level.nearest ? 1 : 0);
    vector(surface.local);
    number(surface.kr);
    number(surface.kt);
    vector(surface.mirrored);
    vector(level.mirrored_brings);
    number(surface.refracted ? 1 : 0);
    vector(surface.refracted.value_or(Vec3d{0, 0, 0}));
    vector(level.refracted_brings);
    vector(level.background);
    return question;
}

Vec3d color(Dice& dice, double brightest = 1) { return dice.point(0.02, brightest); }

TracedSurface surface(Dice& dice, double kr, double kt) {
    const Vec3d mirrored = dice.direction();
    return {color(dice), kr, kt, mirrored, kt > 0 ? std::optional(dice.direction()) : std::nullopt};
}

// A level with this surface, in the middle of the recursion.
Level level(Dice& dice, const std::optional<TracedSurface>& nearest) {
    const int depth = static_cast<int>(dice.in(1, 4)), more = static_cast<int>(dice.in(2, 5));
    const Vec3d mirrored = color(dice), refracted = color(dice);
    return {depth, depth + more, nearest, mirrored, refracted, color(dice)};
}

TracedSurface glass(Dice& dice) {
    const double kr = dice.in(0.1, 0.4);
    return surface(dice, kr, dice.in(0.5, 0.95 - kr));
}

TracedSurface totally_reflecting(Dice& dice) {
    TracedSurface result = glass(dice);
    result.refracted.reset();
    return result;
}

TracedSurface anything(Dice& dice) {
    const double which = dice.in(0, 3);
    return which < 1 ? surface(dice, dice.in(0.2, 0.9), 0) : which < 2 ? glass(dice) : totally_reflecting(dice);
}

// The same level with this many levels left below it.
Level near_the_limit(Dice& dice, int left) {
    Level result = level(dice, anything(dice));
    result.limit = result.depth + left;
    return result;
}

Level bright(Dice& dice) {
    Level result = level(dice, glass(dice));
    result.mirrored_brings = color(dice, 40);
    return result;
}

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](std::size_t count, const std::string& group, Case::Kind kind, const auto& next) {
        for (std::size_t i = 0; i < count; ++i) all.push_back(make(group, kind, next()));
    };
    using enum Case::Kind;
    add(20, "nothing is hit", graded, [&] { return level(dice, {}); });
    add(30, "matt surfaces", graded, [&] { return level(dice, surface(dice, 0, 0)); });
    add(40, "mirrors", graded, [&] { return level(dice, surface(dice, dice.in(0.2, 0.9), 0)); });
    add(40, "glass", graded, [&] { return level(dice, glass(dice)); });
    add(20, "glass that mirrors nothing", graded, [&] { return level(dice, surface(dice, 0, dice.in(0.5, 0.95))); });
    add(40, "total internal reflection", graded, [&] { return level(dice, totally_reflecting(dice)); });
    add(20, "total internal reflection in glass that mirrors nothing", graded, [&] {
        auto surface_of = totally_reflecting(dice);
        surface_of.kr = 0;
        return level(dice, surface_of);
    });
    add(40, "the last level but one", graded, [&] { return near_the_limit(dice, 1); });
    add(40, "the last level", graded, [&] { return near_the_limit(dice, 0); });
    add(20, "nothing is hit at the last level", graded, [&] {
        auto nothing = level(dice, {});
        nothing.limit = nothing.depth;
        return nothing;
    });
    add(30, "things brighter than white", graded, [&] { return bright(dice); });
    add(20, "deeper than the limit already", adversarial, [&] { return near_the_limit(dice, -2); });
    return all;
}

struct Expected {
    Vec3d color;
    double mirror_rays, refracted_rays;
};

// The truth is computed from the list of the rays that go on.
Expected truth(const Arguments& given) {
    const auto& [level, mirrored_brings, refracted_brings] = given;
    if (!level.nearest) return {level.background, 0, 0};
    const auto& s = *level.nearest;
    const bool last = level.depth + 1 > level.limit, total = s.kt > 0 && !s.refracted;
    const double mirror = last ? 0 : total ? s.kr + s.kt : s.kr;
    const double through = last || !s.refracted ? 0 : s.kt;
    return {s.local + mirror * mirrored_brings + through * refracted_brings, mirror > 0 ? 1.0 : 0.0,
            through > 0 ? 1.0 : 0.0};
}

std::string rays(double count, const char* kind, double depth) {
    if (count == 0) return fmt::format("no {} ray", kind);
    return fmt::format("{} {} ray{} of depth {}", count, kind, count == 1 ? "" : "s", depth);
}

std::string in_words(const Vec3d& color, double mirror_rays, double mirror_depth, double refracted_rays,
                     double refracted_depth) {
    return fmt::format("{}, by {} and {}", words(color), rays(mirror_rays, "mirror", mirror_depth),
                       rays(refracted_rays, "refracted", refracted_depth));
}

Judgement judge(const Case& question, std::span<const double> a) {
    const auto given = arguments(question.input);
    const auto expected = truth(given);
    const double next = given.level.depth + 1;
    const Vec3d got{a[0], a[1], a[2]};
    Judgement result{.expected = in_words(expected.color, expected.mirror_rays, next, expected.refracted_rays, next),
                     .got = in_words(got, a[3], a[4], a[5], a[6]) +
                            (a[7] == 0 ? "" : fmt::format(" and {} in no direction of the surface's", a[7]))};
    const double size = std::max(1.0, glm::length(expected.color));
    const bool depths = (a[3] == 0 || a[4] == next) && (a[5] == 0 || a[6] == next);
    if (!std::ranges::all_of(a, [](double value) { return std::isfinite(value); }))
        result.outcome = Judgement::Outcome::nonfinite;
    else if (glm::length(got - expected.color) <= tolerance * size && a[3] == expected.mirror_rays &&
             a[5] == expected.refracted_rays && depths && a[7] == 0)
        result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const auto [level, mirrored_brings, refracted_brings] = arguments(question.input);
    std::string text = fmt::format("a ray of depth {}, the limit is {}\n", level.depth, level.limit);
    if (!level.nearest) return text + "it hits nothing; the background is " + words(level.background);
    const auto& s = *level.nearest;
    text += fmt::format("local colour   {}\nkr = {:.4g}, kt = {:.4g}\na mirror ray would bring {}\n", words(s.local),
                        s.kr, s.kt, words(mirrored_brings));
    if (s.refracted) return text + fmt::format("a refracted ray would bring {}", words(refracted_brings));
    return text + (s.kt > 0 ? "total internal reflection: nothing is refracted" : "nothing is refracted: it is opaque");
}

// One level at every pixel of the traced scene, whose rays return what they should; on the left of a line at the limit.
constexpr int picture_width = 160, picture_height = 120, at_the_limit = 40;

std::vector<Case> pixel_cases(int x, int y) {
    static const TracedScene traced = traced_scene({picture_width, picture_height});
    const RayTree tree = traced.tree(x, y);
    const auto brought = shown_tree(tree, {}).brought;
    const RayNode& eye = tree.nodes[0];
    Level level{1, x < at_the_limit ? 1 : traced.limit, {}, {0, 0, 0}, {0, 0, 0}, traced.scene.background.color};
    if (eye.ended == Ending::missed) return {make("", Case::Kind::graded, level)};
    level.nearest = TracedSurface{eye.local, 0, 0, {0, 0, 1}, {}};
    for (std::size_t i = 1; i < tree.nodes.size(); ++i) {
        const RayNode& node = tree.nodes[i];
        if (node.parent != 0 || node.kind == RayKind::shadow || !was_cast(node)) continue;
        const bool mirrored = node.kind == RayKind::reflected;
        (mirrored ? level.nearest->kr : level.nearest->kt) = node.throughput;
        (mirrored ? level.mirrored_brings : level.refracted_brings) = brought[i];
        if (!mirrored) level.nearest->refracted = Vec3d{0, 0, -1};
    }
    return {make("", Case::Kind::graded, level)};
}

Pixel shade(int, int, std::span<const double> answer) {
    const auto channel = [](double value) { return std::isfinite(value) ? cast<float>(value) : 0; };
    return {channel(answer[0]), channel(answer[1]), channel(answer[2])};
}

}  // namespace

Exercise trace_exercise() {
    return exercise_on(traced_color_slot, answer,
                       {.chart = "",
                        .inputs = inputs,
                        .outputs = outputs,
                        .arguments = {{Part::Kind::indices, "depth and limit", 2},
                                      {Part::Kind::flag, "whether a surface is hit", 1},
                                      {Part::Kind::vector, "the local colour", 3},
                                      {Part::Kind::number, "kr"},
                                      {Part::Kind::number, "kt"},
                                      {Part::Kind::flag, "the mirror ray", 3},
                                      {Part::Kind::vector, "what the mirror ray brings", 3},
                                      {Part::Kind::flag, "whether there is a refracted ray", 1},
                                      {Part::Kind::flag, "the refracted ray", 3},
                                      {Part::Kind::vector, "what the refracted ray brings", 3},
                                      {Part::Kind::vector, "the background", 3}},
                        .cases = cases,
                        .judge = judge,
                        .symptoms = symptoms(),
                        .story = story,
                        .picture = {.about = "the first level of a scene; its left quarter at the limit",
                                    .width = picture_width,
                                    .height = picture_height,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
