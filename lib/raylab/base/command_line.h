#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raylab {

/// A word of the command line that is recognised by its position. A repeated one takes all remaining words and comes
/// last.
struct Positional {
    enum class Count { one, optional, any };
    std::string name;  // its name in the help: "SCENE"
    std::string help;
    Count count = Count::one;
};

/// An option with a value ("--out DIR") or, with no value name, a switch ("--quick").
struct Option {
    std::string names;  // "-o,--out"; Arguments uses the last long name
    std::string value;  // "DIR"; empty for a switch
    std::string help;
    std::string fallback = {};  // shown in the help; empty: there is no value unless it is given
    // The values that count where the option is given more than once.
    enum class Repeat { last, all } repeat = Repeat::last;
};

/// The options and positionals that a program accepts; its help is generated from them.
struct CommandLine {
    std::string program;  // "raylab compare"
    std::string about;
    std::vector<Positional> positionals = {};
    std::vector<Option> options = {};
};

/// The values that were given. Asking for a name that the CommandLine does not have is a mistake of the program (an
/// assertion).
class Arguments {
public:
    bool has(const std::string& name) const;                 // whether it is given or has a fallback
    const std::string& text(const std::string& name) const;  // throws an Error where absent
    std::optional<std::string> text_if_given(const std::string& name) const;
    long long integer(const std::string& name, long long lowest, long long highest) const;  // an Error names the option
    double number(const std::string& name) const;
    const std::vector<std::string>& all(const std::string& name) const;
    // Those of these names that have a value.
    std::vector<std::filesystem::path> given(const std::vector<std::string>& names) const;

private:
    friend Arguments parse(const CommandLine&, const std::vector<std::string>&);
    std::map<std::string, std::vector<std::string>> values_;
};

/// Thrown by parse() for --help; run_program() prints it and exits 0.
struct HelpWanted {
    std::string text;
};

/// Reads the words after the program's name. It throws an Error for words that the command line does not allow.
Arguments parse(const CommandLine& command_line, const std::vector<std::string>& words);

/// Two whole numbers, such as a size "640x480": digits only, with `separator` between them. Absent for any other text.
std::optional<std::array<int, 2>> two_integers(std::string_view text, char separator);

/// The words of argv after the program's name.
std::vector<std::string> words(int argc, char** argv);

}  // namespace raylab
