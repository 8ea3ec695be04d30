#include "14b_gauss_seidel/slot.h"
#include "arguments.h"
#include "exercise_list.h"
#include "known.h"
#include "patch_bars.h"
#include "symptoms.h"

#include <algorithm>
#include <cmath>

namespace raylab::grading {

namespace {

using namespace gauss_seidel;

constexpr double tolerance = 1e-9;  // relative to the largest radiosity

Case make(const std::string& group, Case::Kind kind, const RadiositySystem& system, const Radiosities& before) {
    return {group, kind, as_input(system, {before})};
}

// As if after some sweeps: nothing is what the equation would give for its neighbours.
Radiosities any_state(Dice& dice, std::size_t patches) {
    Radiosities radiosity;
    for (std::size_t i = 0; i < patches; ++i) radiosity.push_back(dice.point(0.5, 5));
    return radiosity;
}

std::size_t whole(Dice& dice, int low, int high) { return static_cast<std::size_t>(dice.in(low, high + 1)); }

Case first_sweep(Dice& dice) {
    const RadiositySystem system = any_patches(dice, 2, 0);
    return make("two patches, from their emission", Case::Kind::graded, system, system.emission);
}

Case any_flat(Dice& dice) {
    const std::size_t patches = whole(dice, 3, 6);
    const RadiositySystem system = any_patches(dice, patches, 0);
    return make("flat patches, after some sweeps", Case::Kind::graded, system, any_state(dice, patches));
}

Case concave(Dice& dice) {
    const std::size_t patches = whole(dice, 2, 6);
    const RadiositySystem system = any_patches(dice, patches, 0.3);
    return make("concave patches, which see themselves", Case::Kind::graded, system, any_state(dice, patches));
}

Case dark_with_light(Dice& dice) {
    const std::size_t patches = whole(dice, 3, 6);
    RadiositySystem system = any_patches(dice, patches, 0);
    for (std::size_t i = 1; i < patches; ++i) system.emission[i] = Color(0);
    return make("one patch emits", Case::Kind::graded, system, system.emission);
}

Case black(Dice& dice) {
    const std::size_t patches = whole(dice, 3, 6);
    RadiositySystem system = any_patches(dice, patches, 0);
    system.reflectance[0] = Color(0);
    system.reflectance[1].g = 0;
    return make("patches that are black, or black in green", Case::Kind::graded, system, any_state(dice, patches));
}

Case alone(Dice& dice) {
    const RadiositySystem system = any_patches(dice, 1, dice.in(0, 1) < 0.5 ? 0 : 0.8);
    return make("one patch alone", Case::Kind::graded, system, any_state(dice, 1));
}

Case nearly_closed(Dice& dice) {
    RadiositySystem system = any_patches(dice, 1, 0);
    system.reflectance[0] = Color(1 - dice.in(1e-13, 1e-12));
    system.form_factors.at(0, 0) = 1;
    return make("a hollow that keeps all its light but 1e-12", Case::Kind::adversarial, system, any_state(dice, 1));
}

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](int count, const auto& next) {
        for (int i = 0; i < count; ++i) all.push_back(next(dice));
    };
    add(20, first_sweep);
    add(30, dark_with_light);
    add(60, any_flat);
    add(30, black);
    add(60, concave);
    add(20, alone);
    add(20, nearly_closed);
    return all;
}

// In long doubles, by the equation as it stands: of each channel alone.
Radiosities truth(const RadiositySystem& system, Radiosities radiosity) {
    for (std::size_t i = 0; i < system.patches(); ++i)
        for (int channel = 0; channel < 3; ++channel) {
            const long double reflectance = system.reflectance[i][channel];
            long double from_others = 0;
            for (std::size_t j = 0; j < system.patches(); ++j)
                if (j != i)
                    from_others += static_cast<long double>(system.form_factors.at(i, j)) * radiosity[j][channel];
            radiosity[i][channel] = static_cast<double>((system.emission[i][channel] + reflectance * from_others) /
                                                        (1 - reflectance * system.form_factors.at(i, i)));
        }
    return radiosity;
}

Judgement judge(const Case& question, std::span<const double> answer) {
    std::span<const double> in = question.input;
    const RadiositySystem system = system_of(taken(in, system_doubles));
    const Radiosities expected = truth(system, colors_of(in, system.patches()));
    const Radiosities got = colors_of(answer, system.patches());
    Judgement result{.expected = words(expected), .got = words(got)};
    if (!std::ranges::all_of(answer, [](double value) { return std::isfinite(value); }))
        result.outcome = Judgement::Outcome::nonfinite;
    else if (is_close(got, expected, tolerance))
        result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    std::span<const double> in = question.input;
    const RadiositySystem system = system_of(taken(in, system_doubles));
    const Radiosities before = colors_of(in, system.patches());
    const double own = system.form_factors.at(0, 0);
    const std::string first =
        own > 0 ? fmt::format("Patch 0 sees itself, F_00 = {:.6g}: its own light stands on both sides of its equation.",
                              own)
                : fmt::format("Patch 0 reflects {:.6g} of red light, of what arrives from the others.",
                              truth(system, before)[0].r - system.emission[0].r);
    return words(system) + "before   " + words(before) + "\n" + first;
}

PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const RadiositySystem system = system_in(question);
    return patch_bars({{"radiosity", truth(system, before_in(question)), colors_of(answer, system.patches())}},
                      "radiosity after the sweep: right, and yours");
}

// The cube before sweeps 1 to 6, from left to right and down, and after each of them by the function under test.
constexpr int tile = 80, across = 3, down = 2;

std::vector<Case> pixel_cases(int x, int y) {
    const RadiositySystem room = cube_room();
    Radiosities radiosity = room.emission;
    for (int sweep = 0; sweep < y / tile * across + x / tile; ++sweep) radiosity = truth(room, radiosity);
    return {make("", Case::Kind::graded, room, radiosity)};
}

Pixel shade(int x, int y, std::span<const double> answer) {
    if (!std::ranges::all_of(answer, [](double value) { return std::isfinite(value); })) return {0.8f, 0, 0.5f};
    return cube_room_pixel((x % tile + 0.5) / tile, (y % tile + 0.5) / tile, colors_of(answer, most_patches));
}

}  // namespace

Exercise gauss_seidel_exercise() {
    return exercise_on(gauss_seidel_sweep_slot, answer,
                       {.inputs = inputs,
                        .outputs = outputs,
                        .cases = cases,
                        .judge = judge,
                        .symptoms = symptoms(),
                        .story = story,
                        .sketch = sketch,
                        .picture = {.about = "a room with a bright ceiling, after one, two, ... six sweeps",
                                    .width = across * tile,
                                    .height = down * tile,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
