#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace raylab {

/// A number of 128 bits that stands for bytes: FNV-1a (Fowler, Noll and Vo; RFC 9923), but eight bytes at a time as
/// long as there are so many, in an eighth of the time. So it is the same only for bytes that are added in the same
/// pieces. It finds damage and tells contents apart. Whoever wants two contents of one number can make them: it is no
/// defence.
class ContentHash {
public:
    void add(std::string_view bytes) {
        for (; bytes.size() >= sizeof(std::uint64_t); bytes.remove_prefix(sizeof(std::uint64_t))) {
            std::uint64_t word;
            std::memcpy(&word, bytes.data(), sizeof word);
            state_ = (state_ ^ word) * prime;
        }
        for (const char byte : bytes) state_ = (state_ ^ static_cast<unsigned char>(byte)) * prime;
    }

    /// The bytes of a number, or of a struct of numbers without gaps, as this machine has them.
    template <class Value>
    void add_value(const Value& value) {
        static_assert(std::is_trivially_copyable_v<Value>);
        add({reinterpret_cast<const char*>(&value), sizeof value});
    }

    /// 32 hexadecimal digits.
    std::string digits() const;

private:
    __extension__ using Number = unsigned __int128;
    static constexpr Number prime = (Number{1} << 88) + 0x13b;
    Number state_ = (Number{0x6c62272e07bb0142} << 64) + 0x62b821756295c58d;
};

}  // namespace raylab
