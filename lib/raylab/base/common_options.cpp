#include "raylab/base/common_options.h"

namespace raylab {

Option threads_option() { return {"--threads", "N", "the number of threads; 0: all cores", "0"}; }

int threads_of(const Arguments& arguments) { return static_cast<int>(arguments.integer("--threads", 0, 1024)); }

std::optional<std::uint64_t> seed_if_given(const Arguments& arguments) {
    if (!arguments.has("--seed")) return std::nullopt;
    return static_cast<std::uint64_t>(arguments.integer("--seed", 0, static_cast<long long>(largest_seed)));
}

}  // namespace raylab
