#include "seeds.h"

#include "sha256.h"

#include "raylab/base/common_options.h"
#include "raylab/base/error.h"
#include "raylab/base/file.h"

#include <fmt/format.h>

#include <random>

namespace raylab::grading {

namespace {

constexpr std::size_t shortest_key = 16, longest_key = 4096;  // bytes

std::uint64_t seed_from(std::string_view bytes) {
    std::uint64_t number = 0;
    for (const char byte : bytes.substr(0, 8)) number = number << 8 | static_cast<unsigned char>(byte);
    return number & largest_seed;
}

}  // namespace

std::uint64_t fresh_seed() {
    std::random_device device;
    return (std::uint64_t{device()} << 32 | device()) & largest_seed;
}

std::uint64_t seed_by_key(const std::string& key, const std::string& exercise, const std::string& student) {
    return seed_from(hmac_sha256(key, exercise + "\n" + student));
}

std::string read_course_key(const std::filesystem::path& file) {
    auto key = read_file(file, longest_key);
    if (key.size() < shortest_key)
        throw Error({file.string()}, fmt::format("a key of at least {} bytes", shortest_key),
                    fmt::format("{}", key.size()));
    return key;
}

}  // namespace raylab::grading
