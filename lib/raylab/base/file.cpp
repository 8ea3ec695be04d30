#include "raylab/base/file.h"

#include "raylab/base/error.h"
#include "raylab/base/outputs.h"

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

void write_file(const OutputFile& file, std::string_view bytes) {
    if (file.together) return file.together->write(file.path, bytes);
    Outputs alone({.files = {file.path}});
    alone.write(file.path, bytes);
    alone.commit();
}

void write_file_with(const OutputFile& file, const std::function<void(const fs::path&)>& write) {
    if (file.together) return file.together->write_with(file.path, write);
    Outputs alone({.files = {file.path}});
    alone.write_with(file.path, write);
    alone.commit();
}

}  // namespace raylab
