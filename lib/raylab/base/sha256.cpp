#include "raylab/base/sha256.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace raylab {

namespace {

using Words = std::array<std::uint32_t, 8>;
constexpr std::size_t block_bytes = 64;

// The standard's constants are the first 32 bits behind the point of the roots of the first primes.
struct HashConstants {
    Words square_roots{};
    std::array<std::uint32_t, 64> cube_roots{};

    HashConstants() {
        const auto bits = [](double root) { return static_cast<std::uint32_t>((root - std::floor(root)) * 0x1p32); };
        std::size_t found = 0;
        for (int number = 2; found < cube_roots.size(); ++number) {
            bool prime = true;
            for (int divisor = 2; divisor * divisor <= number; ++divisor) prime = prime && number % divisor != 0;
            if (!prime) continue;
            if (found < square_roots.size()) square_roots[found] = bits(std::sqrt(number));
            cube_roots[found++] = bits(std::cbrt(number));
        }
    }
};

const HashConstants& constants() {
    static const HashConstants all;
    return all;
}

std::array<std::uint32_t, 64> schedule(std::string_view block) {
    std::array<std::uint32_t, 64> w{};
    for (std::size_t i = 0; i < block_bytes; ++i)
        w[i / 4] = w[i / 4] << 8 | static_cast<std::uint32_t>(static_cast<unsigned char>(block[i]));
    for (std::size_t i = 16; i < w.size(); ++i) {
        const auto before = w[i - 15], lately = w[i - 2];
        w[i] = w[i - 16] + (std::rotr(before, 7) ^ std::rotr(before, 18) ^ before >> 3) + w[i - 7] +
               (std::rotr(lately, 17) ^ std::rotr(lately, 19) ^ lately >> 10);
    }
    return w;
}

// Section 6.2.2, with the standard's letters.
Words after_block(const Words& before, std::string_view block) {
    const auto w = schedule(block);
    auto [a, b, c, d, e, f, g, h] = before;
    for (std::size_t i = 0; i < w.size(); ++i) {
        const auto t1 = h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + ((e & f) ^ (~e & g)) +
                        constants().cube_roots[i] + w[i];
        const auto t2 = (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
        h = g, g = f, f = e, e = d + t1, d = c, c = b, b = a, a = t1 + t2;
    }
    const Words last{a, b, c, d, e, f, g, h};
    Words sum = before;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += last[i];
    return sum;
}

std::string in_bytes(std::uint64_t number, std::size_t count) {
    std::string bytes(count, '\0');
    for (std::size_t i = 0; i < count; ++i) bytes[count - 1 - i] = static_cast<char>(number >> (8 * i) & 0xff);
    return bytes;
}

}  // namespace

std::string sha256(std::string_view bytes) {
    Words words = constants().square_roots;
    const std::size_t whole = bytes.size() / block_bytes * block_bytes;
    for (std::size_t at = 0; at < whole; at += block_bytes) words = after_block(words, bytes.substr(at, block_bytes));
    // One bit, zeros, and the number of bits fill the last block, or the last two.
    std::string rest(bytes.substr(whole));
    rest += '\x80';
    const std::size_t blocks = rest.size() + 8 <= block_bytes ? 1 : 2;
    rest.resize(blocks * block_bytes - 8, '\0');
    rest += in_bytes(std::uint64_t{8} * bytes.size(), 8);
    for (std::size_t at = 0; at < rest.size(); at += block_bytes)
        words = after_block(words, std::string_view(rest).substr(at, block_bytes));
    std::string hash;
    for (const auto word : words) hash += in_bytes(word, 4);
    return hash;
}

std::string hmac_sha256(std::string_view key, std::string_view bytes) {
    std::string inner = key.size() > block_bytes ? sha256(key) : std::string(key);
    inner.resize(block_bytes, '\0');
    std::string outer = inner;
    for (auto& byte : inner) byte = static_cast<char>(byte ^ 0x36);
    for (auto& byte : outer) byte = static_cast<char>(byte ^ 0x5c);
    return sha256(outer + sha256(inner.append(bytes)));
}

std::string hexadecimal(std::string_view bytes) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const char byte : bytes) {
        const auto value = static_cast<unsigned char>(byte);
        text += {digits[value >> 4], digits[value & 15]};
    }
    return text;
}

}  // namespace raylab
