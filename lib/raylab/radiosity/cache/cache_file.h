#pragma once

#include "raylab/radiosity/cache/content_hash.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// A file of a cache: a line that says what it is, numbers in this machine's byte order, and the hash of all that.

namespace raylab {

/// Writes the numbers of a file, between its head and its hash.
class CacheWriter {
public:
    explicit CacheWriter(std::ofstream& file) : file_(file) {}

    template <class Value>
    void put(std::span<const Value> values) {
        put_bytes({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
    }
    template <class Value>
    void put_one(const Value& value) {
        put(std::span<const Value>(&value, 1));
    }
    template <class Value>
    void put_list(const std::vector<Value>& values) {
        put_one<std::uint64_t>(values.size());
        put(std::span<const Value>(values));
    }
    void put_bytes(std::string_view bytes);
    std::string digits() const { return hash_.digits(); }

private:
    std::ofstream& file_;
    ContentHash hash_ = {};
};

/// Reads them back. What is not there throws an Error: nothing that is read may be used before the hash was compared.
class CacheReader {
public:
    CacheReader(std::ifstream& file, std::uint64_t bytes) : file_(file), left_(bytes) {}

    template <class Value>
    void get(std::span<Value> values) {
        get_bytes({reinterpret_cast<char*>(values.data()), values.size_bytes()});
    }
    template <class Value>
    Value get_one() {
        Value value;
        get(std::span<Value>(&value, 1));
        return value;
    }
    template <class Value>
    std::vector<Value> get_list() {
        const auto count = get_one<std::uint64_t>();
        check_left(count, sizeof(Value));
        std::vector<Value> values(count);
        get(std::span<Value>(values));
        return values;
    }
    void get_bytes(std::span<char> bytes);
    /// Throws an Error where fewer than `count` values are left, before memory is taken for them.
    void check_left(std::uint64_t count, std::size_t bytes_each) const;
    std::uint64_t left() const { return left_; }
    std::string digits() const { return hash_.digits(); }

private:
    std::ifstream& file_;
    std::uint64_t left_;
    ContentHash hash_ = {};
};

/// Writes a cache file whole or not at all. `head` is one line without its end.
void write_cache_file(const std::filesystem::path& path, const std::string& head,
                      const std::function<void(CacheWriter&)>& body);

/// Reads one. It throws an Error, which says why, for a file that has another head, is too short or too long, or whose
/// hash is not that of its bytes.
void read_cache_file(const std::filesystem::path& path, const std::string& head,
                     const std::function<void(CacheReader&)>& body);

}  // namespace raylab
