#include "raylab/base/command_line.h"

#include "raylab/base/error.h"
#include "raylab/base/nearest_name.h"

#include <CLI/CLI.hpp>

#include <cassert>
#include <charconv>
#include <cmath>

namespace raylab {

namespace {

// The name by which Arguments finds an option: "--out" for "-o,--out"; a positional has its own name.
std::string key(const std::string& names) {
    const auto comma = names.rfind(',');
    return comma == std::string::npos ? names : names.substr(comma + 1);
}

// Of the words that the command line does not know, the first.
std::string unknown_word(const CommandLine& command_line, const std::vector<std::string>& unknown) {
    const std::string& word = unknown.at(0);
    if (!word.starts_with('-')) return "expected no more words, found \"" + word + '"';
    std::vector<std::string> known{"--help"};
    for (const auto& option : command_line.options) known.push_back(key(option.names));
    return "expected an option (--help lists them), found " + with_suggestion(word.substr(0, word.find('=')), known);
}

template <class Number>
Number number_in(const std::string& name, const std::string& text) {
    Number value{};
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc{} || end != text.data() + text.size())
        throw Error("expected a number for " + name + ", found '" + text + "'");
    return value;
}

}  // namespace

bool Arguments::has(const std::string& name) const {
    assert(values_.contains(name));
    return !values_.at(name).empty();
}

const std::string& Arguments::text(const std::string& name) const {
    if (!has(name)) throw Error("expected " + name + ", found nothing");
    return values_.at(name).back();
}

std::optional<std::string> Arguments::text_if_given(const std::string& name) const {
    if (!has(name)) return std::nullopt;
    return text(name);
}

std::vector<std::filesystem::path> Arguments::given(const std::vector<std::string>& names) const {
    std::vector<std::filesystem::path> paths;
    for (const auto& name : names)
        if (has(name)) paths.emplace_back(text(name));
    return paths;
}

long long Arguments::integer(const std::string& name, long long lowest, long long highest) const {
    const auto value = number_in<long long>(name, text(name));
    if (value < lowest || value > highest)
        throw Error("expected " + name + " from " + std::to_string(lowest) + " to " + std::to_string(highest) +
                    ", found " + text(name));
    return value;
}

double Arguments::number(const std::string& name) const {
    const auto value = number_in<double>(name, text(name));
    if (!std::isfinite(value)) throw Error("expected a finite number for " + name + ", found " + text(name));
    return value;
}

const std::vector<std::string>& Arguments::all(const std::string& name) const {
    assert(values_.contains(name));
    return values_.at(name);
}

Arguments parse(const CommandLine& command_line, const std::vector<std::string>& given) {
    CLI::App app(command_line.about, command_line.program);
    Arguments arguments;
    for (const auto& [name, help, count] : command_line.positionals) {
        auto* option = app.add_option(name, arguments.values_[name], help)->option_text(" ");
        // Takes one word, so that the next one is left for the next positional.
        if (count == Positional::Count::one) option->required()->expected(1)->allow_extra_args(false);
        if (count == Positional::Count::optional) option->expected(0, 1);
        if (count == Positional::Count::any) option->expected(0, CLI::detail::expected_max_vector_size);
    }
    std::map<std::string, bool> switches;
    for (const auto& [names, value, help, fallback, repeat] : command_line.options) {
        if (value.empty()) {
            app.add_flag(names, switches[key(names)], help);
            continue;
        }
        auto& values = arguments.values_[key(names)];
        const auto shown = fallback.empty() ? help : help + " (default: " + fallback + ")";
        auto* option = app.add_option(names, values, shown)->option_text(value);
        option->expected(1)->allow_extra_args(false);  // what follows its value is a positional
        option->multi_option_policy(repeat == Option::Repeat::last ? CLI::MultiOptionPolicy::TakeLast
                                                                   : CLI::MultiOptionPolicy::TakeAll);
    }
    try {
        app.parse(std::vector<std::string>(given.rbegin(), given.rend()));
    } catch (const CLI::CallForHelp&) {
        throw HelpWanted{app.help()};
    } catch (const CLI::ArgumentMismatch& problem) {  // "--seed: 1 required TEXT missing"
        const std::string said = problem.what();
        throw Error(command_line.program + ": expected a value for " + said.substr(0, said.find(':')) +
                    ", found nothing");
    } catch (const CLI::ExtrasError&) {
        throw Error(command_line.program + ": " + unknown_word(command_line, app.remaining()));
    } catch (const CLI::ParseError& problem) {
        throw Error(command_line.program + ": " + problem.what());
    }
    for (const auto& [name, on] : switches)
        arguments.values_[name] = on ? std::vector<std::string>{"on"} : std::vector<std::string>{};
    for (const auto& option : command_line.options)
        if (auto& values = arguments.values_[key(option.names)]; values.empty() && !option.fallback.empty())
            values = {option.fallback};
    return arguments;
}

std::optional<std::array<int, 2>> two_integers(std::string_view text, char separator) {
    const auto middle = text.find(separator);
    if (middle == std::string_view::npos) return std::nullopt;
    std::array<int, 2> numbers{};
    for (const int i : {0, 1}) {
        const auto digits = i == 0 ? text.substr(0, middle) : text.substr(middle + 1);
        const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), numbers[i]);
        if (problem != std::errc{} || end != digits.data() + digits.size() || digits[0] == '-') return std::nullopt;
    }
    return numbers;
}

std::vector<std::string> words(int argc, char** argv) { return {argv + 1, argv + argc}; }

}  // namespace raylab
