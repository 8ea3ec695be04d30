#include "memory_words.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>

namespace raylab {

CommandLine with_memory_option(CommandLine command_line) {
    command_line.options.push_back(
        {"--memory", "LIMIT",
         "refuse input that is expected to need more memory: bytes, or with K, M, G such as 4G "
         "(default: half of the machine's)"});
    return command_line;
}

MemoryLimit memory_limit(const Arguments& arguments) {
    const auto words = arguments.text_if_given("--memory");
    return words ? memory_limit_from_words(*words) : MemoryLimit{};
}

void say_memory(const MemoryNeed& need) {
    constexpr std::uintmax_t worth_a_line = 1 << 20;
    if (need.bytes < worth_a_line) return;
    fmt::print(stderr, "memory: {} needs {}: {}\n", need.what, bytes_in_words(need.bytes), need.why);
}

}  // namespace raylab
