#include "changed_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace raylab::grading {

namespace {

using Kind = Part::Kind;
using Numbers = std::span<double>;

// Arguments of one name (the corners of a polygon, say) are changed together, since a mistake uses all of them alike.
struct Argument {
    Part part;
    std::vector<std::size_t> places;  // of the first number of each
};

std::vector<Argument> arguments_of(const Exercise& exercise) {
    std::vector<Argument> all;
    std::size_t place = 0;
    for (const auto& part : exercise.arguments) {
        const auto known = std::ranges::find(all, part.name, [](const Argument& one) { return one.part.name; });
        if (known == all.end())
            all.push_back({part, {place}});
        else
            known->places.push_back(place);
        place += part.count;
    }
    std::erase_if(all,
                  [](const Argument& one) { return one.part.kind == Kind::flag || one.part.kind == Kind::indices; });
    return all;
}

struct Change {
    std::string words;  // after the argument's name
    void (*apply)(Numbers);
};

const std::vector<Change>& changes_of(Kind kind) {
    static const Change turned{"has the other sign", [](Numbers x) {
                                   for (double& value : x) value = -value;
                               }};
    static const Change left_out{"is 0", [](Numbers x) { std::ranges::fill(x, 0.0); }};
    static const Change unit{"has the length 1", [](Numbers x) {
                                 const double length = std::hypot(x[0], x[1], x[2]);
                                 for (double& value : x) value /= length;
                             }};
    static const std::vector<Change> of_vectors{turned, left_out, unit}, of_directions{turned, unit};
    static const std::vector<Change> of_numbers{turned,
                                                left_out,
                                                {"is 1", [](Numbers x) { x[0] = 1; }},
                                                {"is twice as large", [](Numbers x) { x[0] *= 2; }},
                                                {"is half as large", [](Numbers x) { x[0] /= 2; }},
                                                {"is squared", [](Numbers x) { x[0] *= x[0]; }},
                                                {"is its root", [](Numbers x) { x[0] = std::sqrt(x[0]); }},
                                                {"is 1 over it", [](Numbers x) { x[0] = 1 / x[0]; }}};
    return kind == Kind::vector ? of_vectors : kind == Kind::direction ? of_directions : of_numbers;
}

using Changed = std::function<void(std::vector<double>& input)>;

// Whether the answer is right for the case with other arguments. There is no such case where a change makes a number
// infinite, or none.
bool is_right_for_changed(const Exercise& exercise, const Case& question, const Changed& change,
                          std::span<const double> answer) {
    Case other = question;
    change(other.input);
    const auto is_kept = [](double before, double after) { return std::isfinite(after) || before == after; };
    return std::ranges::equal(question.input, other.input, is_kept) &&
           exercise.judge(other, answer).outcome == Judgement::Outcome::right;
}

Symptom symptom_of(const Exercise& exercise, const std::string& words, const Changed& change) {
    const auto right_answer = [&exercise](const Case& question) {
        std::vector<double> answer(exercise.outputs);
        exercise.reference(question.input, answer);
        return answer;
    };
    return {"another_question", "what you give is right for another question, in which " + words,
            [&exercise, change](const WrongAnswer& w) {
                return is_right_for_changed(exercise, w.question, change, w.given);
            },
            [&exercise, change, right_answer](const Case& question) {
                return !is_right_for_changed(exercise, question, change, right_answer(question));
            }};
}

}  // namespace

std::vector<Symptom> changed_argument_symptoms(const Exercise& exercise) {
    std::vector<Symptom> all;
    const auto arguments = arguments_of(exercise);
    for (const auto& argument : arguments)
        for (const auto& change : changes_of(argument.part.kind))
            all.push_back(symptom_of(exercise, argument.part.name + " " + change.words,
                                     [argument, apply = change.apply](std::vector<double>& input) {
                                         for (const std::size_t place : argument.places)
                                             apply(Numbers(input).subspan(place, argument.part.count));
                                     }));
    for (auto a = arguments.begin(); a != arguments.end(); ++a)
        for (auto b = a + 1; b != arguments.end(); ++b) {
            if (a->part.kind != b->part.kind || a->places.size() != b->places.size()) continue;
            all.push_back(symptom_of(exercise, fmt::format("{} and {} have changed places", a->part.name, b->part.name),
                                     [one = *a, other = *b](std::vector<double>& input) {
                                         for (std::size_t i = 0; i < one.places.size(); ++i)
                                             std::swap_ranges(input.data() + one.places[i],
                                                              input.data() + one.places[i] + one.part.count,
                                                              input.data() + other.places[i]);
                                     }));
        }
    return all;
}

}  // namespace raylab::grading
