#include "symbols.h"

#include "raylab/base/error.h"
#include "raylab/base/process.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <sstream>

namespace raylab::grading {

namespace {

constexpr std::size_t kind_at = 17, name_at = 19;  // "0123456789abcdef T name"

bool is_of_slot(const std::string& symbol, const std::string& slot) {
    return symbol.starts_with("raylab::" + slot + "(");
}

bool is_of_library(const std::string& symbol) { return symbol.starts_with("raylab::"); }

// What the file defines instead of the slot, which may be a slip.
std::string defined_instead(const Symbols& symbols, const std::string& slot) {
    const auto& defined = symbols.defined;
    if (const auto other = std::ranges::find_if(defined, is_of_library); other != defined.end())
        return ", but " + *other;
    const auto outside = [&](const std::string& symbol) { return symbol.starts_with(slot + "("); };
    if (const auto other = std::ranges::find_if(defined, outside); other != defined.end())
        return ", but ::" + *other + " outside of namespace raylab";
    return {};
}

}  // namespace

Symbols symbols_of(const std::filesystem::path& object) {
    const auto listing = run_process(find_program("nm"), {"-C", "--extern-only", object.string()}, {.timeout = 10});
    if (!listing.succeeded())
        throw Error({object.string()}, "an object file that nm can read", failure_of("nm", listing));
    Symbols symbols;
    std::istringstream lines(listing.output);
    for (std::string line; std::getline(lines, line);) {
        if (line.size() <= name_at) continue;
        auto& list = line[kind_at] == 'U'                                            ? symbols.needed
                     : std::string("WVuwv").find(line[kind_at]) != std::string::npos ? symbols.shared
                                                                                     : symbols.defined;
        list.push_back(line.substr(name_at));
    }
    return symbols;
}

std::vector<std::string> faults_of(const Symbols& symbols, const std::string& slot,
                                   const std::filesystem::path& harness) {
    std::vector<std::string> faults;
    const auto of_slot = [&](const std::string& symbol) { return is_of_slot(symbol, slot); };
    if (std::ranges::none_of(symbols.defined, of_slot))
        faults.push_back(
            fmt::format("undefined reference to raylab::{}: the file does not define it with the arguments "
                        "that its header declares{}",
                        slot, defined_instead(symbols, slot)));
    std::vector<std::string> called;
    std::ranges::copy_if(symbols.needed, std::back_inserter(called),
                         [&](const std::string& symbol) { return is_of_library(symbol) && !of_slot(symbol); });
    if (called.empty()) return faults;
    const auto library = symbols_of(harness).defined;
    for (const auto& symbol : called)
        if (std::ranges::find(library, symbol) != library.end())
            faults.push_back(
                fmt::format("the file calls {}, a function of the library: the answer is yours to write, and "
                            "what it may use stands in the headers that its stub includes",
                            symbol));
    return faults;
}

}  // namespace raylab::grading
