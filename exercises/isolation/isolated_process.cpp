#include "isolated_process.h"

#include "launcher.h"
#include "scratch_size.h"

#include "raylab/base/error.h"
#include "raylab/report/provenance.h"

#include <fmt/format.h>

namespace raylab::grading {

namespace {

constexpr std::uintmax_t largest_scratch = std::uintmax_t{256} << 20;  // bytes; a check needs five million

std::string objection_to(const std::filesystem::path& folder) {
    const auto bytes = scratch_size(folder);
    if (bytes <= largest_scratch) return {};
    return fmt::format("it filled its folder with {} MB, and {} are allowed", bytes >> 20, largest_scratch >> 20);
}

}  // namespace

ProcessResult run_isolated(const Isolated& isolated, const Allowed& allowed, const std::filesystem::path& program,
                           const std::vector<std::string>& words, ProcessOptions options) {
    std::vector<std::string> all{std::to_string(static_cast<int>(isolated.isolation.level)),
                                 words_for_work[static_cast<std::size_t>(allowed.work)],
                                 std::to_string(allowed.seconds), isolated.folder.string(), program.string()};
    all.insert(all.end(), words.begin(), words.end());
    options.timeout = allowed.patience();
    if (may_write(allowed.work)) options.objection = [folder = isolated.folder] { return objection_to(folder); };
    auto result = run_process(build_folder() / "exercises/raylab_isolated", all, options);
    if (result.end == ProcessResult::End::exited && result.code == exit_not_isolated)
        throw Error("expected to isolate a program, found: " + failure_of("the launcher", result));
    return result;
}

}  // namespace raylab::grading
