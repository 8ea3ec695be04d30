#include "raylab/report/build_target.h"

#include "raylab/base/error.h"
#include "raylab/report/provenance.h"

namespace raylab {

ProcessResult build_target(const std::string& target, double timeout) {
    const auto ninja = find_program("ninja");
    if (ninja.empty()) throw Error("expected ninja on the PATH, to build " + target + "; found none");
    auto result = run_process(ninja, {"-C", build_folder().string(), "--quiet", target}, {.timeout = timeout});
    if (result.end == ProcessResult::End::timed_out)
        throw Error("expected to build " + target + ", found: " + failure_of("the compiler", result));
    return result;
}

}  // namespace raylab
