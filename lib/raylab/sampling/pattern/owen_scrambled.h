#pragma once

#include <cstdint>

namespace raylab {

/// Scrambles a number whose bits are reversed: bit 0 is worth 1/2. Each bit is flipped or not, as a hash of the more
/// valuable bits says; so halves change places, quarters within them, and so on, and what was evenly spread stays so
/// (Owen, "Randomly Permuted (t,m,s)-Nets and (t,s)-Sequences", 1995). Products with even numbers carry information
/// only upwards, as that needs (Laine and Karras, "Stratified Sampling for Stochastic Transparency", 2011; Burley,
/// "Practical Hash-Based Owen Scrambling", JCGT 9(4), 2020; the constants are those of Vegdahl, 2021).
constexpr std::uint32_t owen_scrambled(std::uint32_t reversed, std::uint32_t key) {
    reversed ^= reversed * 0x3d20adeau;
    reversed += key;
    reversed *= (key >> 16) | 1;
    reversed ^= reversed * 0x05526c56u;
    reversed ^= reversed * 0x53a22864u;
    return reversed;
}

}  // namespace raylab
