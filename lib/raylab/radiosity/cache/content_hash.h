#pragma once

#include <string>
#include <string_view>
#include <type_traits>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace raylab {

/// A number of 128 bits that stands for bytes: xxHash's XXH3, which is as fast as memory. It finds damage and tells
/// contents apart. Whoever wants two contents of one number can make them: it is no defence.
class ContentHash {
public:
    ContentHash() { XXH3_128bits_reset(&state_); }

    void add(std::string_view bytes) { XXH3_128bits_update(&state_, bytes.data(), bytes.size()); }

    /// The bytes of a number, or of a struct of numbers without gaps, as this machine has them.
    template <class Value>
    void add_value(const Value& value) {
        static_assert(std::is_trivially_copyable_v<Value>);
        add({reinterpret_cast<const char*>(&value), sizeof value});
    }

    /// 32 hexadecimal digits.
    std::string digits() const;

private:
    XXH3_state_t state_;
};

}  // namespace raylab
