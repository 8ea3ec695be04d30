#include "prepared_header.h"

#include "student_words.h"
#include "workplace.h"

#include "raylab/base/error.h"
#include "raylab/base/process.h"
#include "raylab/report/provenance.h"

#include <algorithm>
#include <system_error>

namespace raylab::grading {

namespace fs = std::filesystem;

namespace {

constexpr double patience = 60;  // seconds; it takes one or two

fs::path prepared(const Exercise& exercise, const fs::path& folder) { return folder / (exercise.folder + ".gch"); }

}  // namespace

std::string declaring_header(const Exercise& exercise) {
    const auto stub = source_folder() / "exercises" / exercise.folder / (exercise.slot + ".cpp");
    const auto included = included_headers(stub);
    const auto header = std::ranges::find_if(included, [](const auto& name) { return name != unfinished_header; });
    if (header == included.end()) throw Error({stub.string()}, "the header that declares the function", "none");
    return *header;
}

void prepare_header(const Exercise& exercise, const fs::path& folder) {
    auto words = student_words();
    const auto compiler = words.front();
    words.erase(words.begin());
    const auto file = prepared(exercise, folder);
    words.insert(words.end(), {"-I", ".", "-x", "c++-header", declaring_header(exercise), "-o", file.string()});
    run_process(compiler, words, {.folder = source_folder() / "lib", .timeout = patience});
    std::error_code none;
    fs::permissions(file, fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read, none);
}

void share_prepared_header(const Exercise& exercise, const fs::path& folder, const fs::path& headers) {
    std::error_code not_linked;
    fs::create_hard_link(prepared(exercise, folder), headers / (declaring_header(exercise) + ".gch"), not_linked);
}

}  // namespace raylab::grading
