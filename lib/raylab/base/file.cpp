#include "raylab/base/file.h"

#include "raylab/base/error.h"

#include <unistd.h>

#include <atomic>
#include <fstream>

namespace raylab {

namespace fs = std::filesystem;

std::string read_file(const fs::path& path, std::size_t limit) {
    std::error_code problem;
    const auto status = fs::status(path, problem);
    if (!fs::exists(status)) throw Error({path.string()}, "a file", "nothing there");
    if (!fs::is_regular_file(status)) throw Error({path.string()}, "a file", "something that is no regular file");
    const auto size = fs::file_size(path, problem);
    if (problem) throw Error({path.string()}, "a readable file", problem.message());
    if (size > limit)
        throw Error({path.string()}, "at most " + std::to_string(limit) + " bytes", std::to_string(size) + " bytes");
    std::string bytes(size, '\0');
    std::ifstream file(path, std::ios::binary);
    if (!file.read(bytes.data(), static_cast<std::streamsize>(size)))
        throw Error({path.string()}, "a readable file", "one that cannot be read");
    return bytes;
}

void write_file(const fs::path& path, std::string_view bytes) {
    write_file_with(path, [&](const fs::path& beside) {
        std::ofstream file(beside, std::ios::binary);
        file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        file.close();
        if (!file) throw Error({path.string()}, "to write " + std::to_string(bytes.size()) + " bytes", "a failing disk");
    });
}

void write_file_with(const fs::path& path, const std::function<void(const fs::path&)>& write) {
    static std::atomic<unsigned> count = 0;
    const auto name = "." + path.stem().string() + "." + std::to_string(getpid()) + "." + std::to_string(count++) +
                      path.extension().string();
    const auto beside = path.parent_path() / name;
    std::error_code problem;
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), problem);
    if (problem) throw Error({path.string()}, "a folder that can be made", problem.message());
    try {
        write(beside);
        fs::rename(beside, path);
    } catch (const fs::filesystem_error& error) {
        fs::remove(beside, problem);
        throw Error({path.string()}, "a place that can be written", error.code().message());
    } catch (...) {
        fs::remove(beside, problem);
        throw;
    }
}

}  // namespace raylab
