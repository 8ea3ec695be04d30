#include "isolated_process.h"

#include "launcher.h"

#include "raylab/base/error.h"

namespace raylab::grading {

ProcessResult run_isolated(const Isolated& isolated, Work work, const std::filesystem::path& program,
                           const std::vector<std::string>& words, const ProcessOptions& options) {
    std::vector<std::string> all{std::to_string(static_cast<int>(isolated.isolation.level)),
                                 words_for_work[static_cast<std::size_t>(work)], isolated.folder.string(),
                                 program.string()};
    all.insert(all.end(), words.begin(), words.end());
    auto result = run_process(RAYLAB_BUILD "/exercises/raylab_isolated", all, options);
    if (result.end == ProcessResult::End::exited && result.code == exit_not_isolated)
        throw Error("expected to isolate a program, found: " + failure_of("the launcher", result));
    return result;
}

}  // namespace raylab::grading
