#include "raylab/radiosity/cache/cache_file.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

namespace {

constexpr std::size_t hash_digits = 32;

// A file that a machine of the other byte order wrote begins otherwise.
constexpr std::uint32_t byte_order = 0x01020304;

}  // namespace

void CacheWriter::put_bytes(std::string_view bytes) {
    hash_.add(bytes);
    file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void CacheReader::get_bytes(std::span<char> bytes) {
    check_left(bytes.size(), 1);
    file_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    left_ -= bytes.size();
    hash_.add({bytes.data(), bytes.size()});
}

void CacheReader::check_left(std::uint64_t count, std::size_t bytes_each) const {
    if (count > left_ / bytes_each)
        throw Error(fmt::format("expected {} more numbers of {} bytes, found {} bytes", count, bytes_each, left_));
}

void write_cache_file(const std::filesystem::path& path, const std::string& head,
                      const std::function<void(CacheWriter&)>& body) {
    write_file_with(path, [&](const std::filesystem::path& temporary) {
        std::ofstream file(temporary, std::ios::binary);
        CacheWriter writer(file);
        writer.put_bytes(head + "\n");
        writer.put_one(byte_order);
        body(writer);
        file << writer.digits();
        if (!file.flush()) throw Error({path.string()}, "room for a file of the cache", "none");
    });
}

void read_cache_file(const std::filesystem::path& path, const std::string& head,
                     const std::function<void(CacheReader&)>& body) {
    std::ifstream file(path, std::ios::binary);
    std::error_code problem;
    const auto size = std::filesystem::file_size(path, problem);
    if (!file || problem) throw Error("expected a file that can be read, found another");
    CacheReader reader(file, size < hash_digits ? 0 : size - hash_digits);
    std::string first(std::min<std::uint64_t>(head.size() + 1, reader.left()), '\0');
    reader.get_bytes(first);
    if (first != head + "\n") throw Error("expected a file that begins with \"" + head + "\", found another");
    if (reader.get_one<std::uint32_t>() != byte_order)
        throw Error("expected numbers in this machine's byte order, found the other");
    body(reader);
    if (reader.left() > 0) throw Error(fmt::format("expected its end, found {} more bytes", reader.left()));
    std::string digits(hash_digits, '\0');
    file.read(digits.data(), hash_digits);
    if (digits != reader.digits())
        throw Error(fmt::format("expected bytes of the hash {}, found {}", digits, reader.digits()));
}

}  // namespace raylab
