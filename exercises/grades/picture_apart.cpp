#include "picture_apart.h"

#include "landlock.h"
#include "process_limits.h"
#include "submission.h"
#include "system_calls.h"

#include "raylab/base/file.h"
#include "raylab/base/printable.h"
#include "raylab/base/process.h"
#include "raylab/base/temporary.h"
#include "raylab/base/with_all_replaced.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/image/picture_files/openimageio.h"

#include <sys/prctl.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace raylab::grading {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t largest_file = std::size_t{256} << 20;     // bytes
constexpr std::size_t largest_picture = std::size_t{512} << 20;  // of its pixels
constexpr double patience = 62;                                  // seconds, of which the processor's are 15
constexpr std::uint64_t decoders_memory = std::uint64_t{6} << 30;
constexpr unsigned decoders_user = 1'999'999'999;

struct PictureSize {
    std::int32_t width, height;
};

void shut_in(const fs::path& folder, const Isolation& isolation) {
    bound({.seconds = 15, .memory = decoders_memory, .file = 0, .processes = 64, .open_files = 256});
    if (isolation.own_user) become_user(decoders_user, folder);
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
        throw std::system_error(errno, std::generic_category(), "PR_SET_NO_NEW_PRIVS");
    if (isolation.level >= Level::files) close_other_files({.readable = {folder}, .writable = {}});
    filter_system_calls(Work::load_and_answer);
}

std::string bytes_of(const Image& image) {
    const PictureSize size{image.width(), image.height()};
    std::string bytes(sizeof size + image.pixels().size() * sizeof(Pixel), '\0');
    std::memcpy(bytes.data(), &size, sizeof size);
    std::memcpy(bytes.data() + sizeof size, image.pixels().data(), bytes.size() - sizeof size);
    return bytes;
}

// What comes back is not believed: its size has to be that of the pixels.
ForeignPicture picture_in(const std::string& bytes) {
    PictureSize size{};
    if (bytes.size() < sizeof size) return {{}, "the picture's decoder answered nothing"};
    std::memcpy(&size, bytes.data(), sizeof size);
    const auto pixels = static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
    if (size.width < 0 || size.height < 0 || bytes.size() != sizeof size + pixels * sizeof(Pixel))
        return {{}, "the picture's decoder answered no picture"};
    ForeignPicture picture{.image = Image(size.width, size.height)};
    const char* next = bytes.data() + sizeof size;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x, next += sizeof(Pixel))
            std::memcpy(&picture.image.at(x, y), next, sizeof(Pixel));
    return picture;
}

}  // namespace

ForeignPicture read_picture_apart(const fs::path& file, const Isolation& isolation) {
    if (auto link = fault_of_link(file); !link.empty()) return {{}, std::move(link)};
    std::error_code missing;
    if (!fs::is_regular_file(file, missing)) return {{}, "there is no picture " + printable(file.filename().string())};
    if (fs::file_size(file, missing) > largest_file) return {{}, "the picture's file is larger than 256 MB"};
    const ScratchFolder scratch;
    const auto copy = scratch.path() / ("picture" + file.extension().string());
    fs::copy_file(file, copy);
    const auto result = run_in_copy(
        [&] {
            // What both have to open files for is done before.
            openimageio::functions();
            const MemoryLimit limit;
            shut_in(scratch.path(), isolation);
            return bytes_of(read_image(copy, limit));
        },
        {.timeout = patience, .output_limit = largest_picture});
    if (result.succeeded()) return picture_in(result.output);
    const auto reason = result.end == ProcessResult::End::exited ? result.errors : to_string(result);
    return {{}, on_one_line(printable_lines(with_all_replaced(reason, copy.string(), "the picture")))};
}

}  // namespace raylab::grading
