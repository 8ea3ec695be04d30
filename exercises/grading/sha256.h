#pragma once

#include <string>
#include <string_view>

// The hash SHA-256 (FIPS 180-4), by the library nettle: which file was graded, whether cases have changed, and seeds
// that nobody can foretell.

namespace raylab::grading {

/// The 32 bytes of a text's hash.
std::string sha256(std::string_view bytes);

/// The 32 bytes of a text's hash under a key (HMAC, RFC 2104): without the key nobody can tell them.
std::string hmac_sha256(std::string_view key, std::string_view bytes);

/// Bytes as hexadecimal digits.
std::string hexadecimal(std::string_view bytes);

}  // namespace raylab::grading
