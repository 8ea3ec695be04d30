#include "14c_shooting/slot.h"
#include "arguments.h"
#include "exercise_list.h"
#include "known.h"
#include "patch_bars.h"
#include "symptoms.h"

#include <algorithm>
#include <cmath>

namespace raylab::grading {

namespace {

using namespace shooting;

constexpr double tolerance = 1e-9;  // relative to the largest radiosity
// The powers of the two patches with most differ by this share at least, or are equal: who shoots is not a matter of
// rounding.
constexpr double margin = 0.02;

Case make(const std::string& group, Case::Kind kind, const State& state) {
    return {group, kind, as_input(state.system, {state.radiosity, state.unshot})};
}

bool is_decided(const State& state) {
    const std::size_t shooter = shooter_of(state);
    for (std::size_t i = 0; i < state.system.patches(); ++i)
        if (i != shooter && power(state, i) > (1 - margin) * power(state, shooter)) return false;
    return true;
}

std::size_t whole(Dice& dice, int low, int high) { return static_cast<std::size_t>(dice.in(low, high + 1)); }

// After some steps: each patch has radiosity that it has shot already, and some that it has not.
State any_state(Dice& dice, std::size_t patches, double own) {
    for (;;) {
        State state{.system = any_patches(dice, patches, own), .radiosity = {}, .unshot = {}};
        for (std::size_t i = 0; i < patches; ++i) {
            state.unshot.push_back(dice.point(0.1, 2));
            state.radiosity.push_back(state.unshot.back() + dice.point(0.1, 6));
        }
        if (is_decided(state)) return state;
    }
}

Case first_shot(Dice& dice) {
    State state = any_state(dice, whole(dice, 2, 6), 0);
    for (std::size_t i = 1; i < state.system.patches(); ++i) state.system.emission[i] = Color(0);
    state.radiosity = state.unshot = state.system.emission;
    return make("one patch emits, and nothing has been shot", Case::Kind::graded, state);
}

Case any_flat(Dice& dice) {
    return make("flat patches, after some steps", Case::Kind::graded, any_state(dice, whole(dice, 3, 6), 0));
}

Case concave(Dice& dice) {
    return make("concave patches, which see themselves", Case::Kind::graded, any_state(dice, whole(dice, 2, 6), 0.3));
}

// The larger patch is darker per area, and yet it has more to give.
Case large_and_dark(Dice& dice) {
    for (;;) {
        State state = any_state(dice, 2, 0);
        state.unshot[1] = state.unshot[0] * 0.6;
        state.radiosity[1] = state.unshot[1] + dice.point(0.1, 6);
        if (is_decided(state) && shooter_of(state) == 1) return make("a large dark patch", Case::Kind::graded, state);
    }
}

// Red alone would choose the other patch.
Case blue(Dice& dice) {
    for (;;) {
        State state = any_state(dice, 3, 0);
        const std::size_t shooter = shooter_of(state);
        state.unshot[shooter].r = 0.01;
        if (is_decided(state) && shooter_of(state) == shooter)
            return make("a patch with hardly any red light", Case::Kind::graded, state);
    }
}

Case equal(Dice& dice) {
    State state = any_state(dice, whole(dice, 3, 6), 0);
    const std::size_t shooter = shooter_of(state);
    const std::size_t other = (shooter + 1) % state.system.patches();
    state.unshot[other] = state.unshot[shooter];
    const double ratio = state.system.area[shooter] / state.system.area[other];
    state.system.area[other] = state.system.area[shooter];
    for (std::size_t i = 0; i < state.system.patches(); ++i)  // reciprocity with the area that has changed
        if (i != other) state.system.form_factors.at(other, i) /= ratio;
    return make("two patches with the same power", Case::Kind::graded, state);
}

Case black(Dice& dice) {
    State state = any_state(dice, whole(dice, 3, 6), 0);
    state.system.reflectance[0] = Color(0);
    state.system.reflectance[1].g = 0;
    return make("patches that are black, or black in green", Case::Kind::graded, state);
}

Case done(Dice& dice) {
    State state = any_state(dice, whole(dice, 1, 6), 0);
    std::ranges::fill(state.unshot, Color(0));
    return make("all has been shot", Case::Kind::graded, state);
}

Case close_call(Dice& dice) {
    State state = any_state(dice, 2, 0);
    state.unshot[1] = state.unshot[0] * (state.system.area[0] / state.system.area[1] * (1 + dice.in(-1e-15, 1e-15)));
    return make("powers equal to the last digit or two", Case::Kind::adversarial, state);
}

std::vector<Case> cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](int count, const auto& next) {
        for (int i = 0; i < count; ++i) all.push_back(next(dice));
    };
    add(30, first_shot);
    add(60, any_flat);
    add(20, large_and_dark);
    add(20, blue);
    add(20, equal);
    add(20, black);
    add(40, concave);
    add(10, done);
    add(20, close_call);
    return all;
}

std::string words_of(std::size_t shooter, const std::vector<Color>& radiosity, const std::vector<Color>& unshot) {
    return fmt::format("patch {} shoots; radiosity {}; unshot {}", shooter, words(radiosity), words(unshot));
}

Judgement judge(const Case& question, std::span<const double> answer) {
    const State before = state_of(question.input);
    const State after = shot(before);
    const std::size_t patches = before.system.patches();
    const Radiosities radiosity = colors_of(answer.subspan(1), patches);
    const Radiosities unshot = colors_of(answer.subspan(1 + color_doubles), patches);
    Judgement result{.expected = words_of(shooter_of(before), after.radiosity, after.unshot), .got = ""};
    if (!std::ranges::all_of(answer, [](double value) { return std::isfinite(value); })) {
        result.got = "numbers that are not finite";
        result.outcome = Judgement::Outcome::nonfinite;
        return result;
    }
    result.got = fmt::format("patch {} shoots; radiosity {}; unshot {}", answer[0], words(radiosity), words(unshot));
    if (answer[0] == static_cast<double>(shooter_of(before)) && is_close(radiosity, after.radiosity, tolerance) &&
        is_close(unshot, after.unshot, tolerance))
        result.outcome = Judgement::Outcome::right;
    return result;
}

std::string story(const Case& question) {
    const State state = state_of(question.input);
    std::string text = words(state.system) + "radiosity  " + words(state.radiosity) + "\nunshot     " +
                       words(state.unshot) + "\nunshot power, area times the sum of the channels:";
    for (std::size_t i = 0; i < state.system.patches(); ++i) text += fmt::format(" {:.6g}", power(state, i));
    return text + fmt::format("\nPatch {} has most of it.", shooter_of(state));
}

PlaneDrawing sketch(const Case& question, std::span<const double> answer) {
    const State after = shot(state_of(question.input));
    const std::size_t patches = after.system.patches();
    return patch_bars({{"radiosity", after.radiosity, colors_of(answer.subspan(1), patches)},
                       {"unshot", after.unshot, colors_of(answer.subspan(1 + color_doubles), patches)}},
                      "after the step: right, and yours");
}

// The cube before steps 1, 2, 3, 5, 9 and 17, and after each of them by the function under test.
constexpr int tile = 80, across = 3, down = 2;
constexpr int steps_before[across * down] = {0, 1, 2, 4, 8, 16};

std::vector<Case> pixel_cases(int x, int y) {
    State room{.system = cube_room(), .radiosity = {}, .unshot = {}};
    room.radiosity = room.unshot = room.system.emission;
    for (int step = 0; step < steps_before[y / tile * across + x / tile]; ++step) room = shot(std::move(room));
    return {make("", Case::Kind::graded, room)};
}

Pixel shade(int x, int y, std::span<const double> answer) {
    if (!std::ranges::all_of(answer, [](double value) { return std::isfinite(value); })) return {0.8f, 0, 0.5f};
    return cube_room_pixel((x % tile + 0.5) / tile, (y % tile + 0.5) / tile,
                           colors_of(answer.subspan(1), most_patches));
}

}  // namespace

Exercise shooting_exercise() {
    return exercise_on(shooting_step_slot, answer,
                       {.inputs = inputs,
                        .outputs = outputs,
                        .cases = cases,
                        .judge = judge,
                        .symptoms = symptoms(),
                        .story = story,
                        .sketch = sketch,
                        .picture = {.about = "a room with a bright ceiling after 1, 2, 3, 5, 9 and 17 steps",
                                    .width = across * tile,
                                    .height = down * tile,
                                    .cases = pixel_cases,
                                    .shade = shade}});
}

}  // namespace raylab::grading
