#include "sha256.h"

#include <nettle/hmac.h>
#include <nettle/sha2.h>

namespace raylab::grading {

namespace {

const std::uint8_t* octets(std::string_view bytes) { return reinterpret_cast<const std::uint8_t*>(bytes.data()); }

std::uint8_t* octets(std::string& bytes) { return reinterpret_cast<std::uint8_t*>(bytes.data()); }

}  // namespace

std::string sha256(std::string_view bytes) {
    sha256_ctx state;
    sha256_init(&state);
    sha256_update(&state, bytes.size(), octets(bytes));
    std::string hash(SHA256_DIGEST_SIZE, '\0');
    sha256_digest(&state, hash.size(), octets(hash));
    return hash;
}

std::string hmac_sha256(std::string_view key, std::string_view bytes) {
    hmac_sha256_ctx state;
    hmac_sha256_set_key(&state, key.size(), octets(key));
    hmac_sha256_update(&state, bytes.size(), octets(bytes));
    std::string hash(SHA256_DIGEST_SIZE, '\0');
    hmac_sha256_digest(&state, hash.size(), octets(hash));
    return hash;
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

}  // namespace raylab::grading
