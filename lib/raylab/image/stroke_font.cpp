#include "raylab/image/stroke_font.h"

#include <algorithm>
#include <string_view>

namespace raylab {

namespace {

struct Entry {
    char character;
    // Points as pairs of base-36 digits (x, y); y = 4 is the baseline; a space begins a new stroke.
    std::string_view strokes;
};

constexpr Entry font[] = {
    {'A', "044g84 1878"},
    {'B', "040g5g7e7c5a0a 5a88866404"},
    {'C', "8d6g2g0e06246487"},
    {'D', "040g5g8d875404"},
    {'E', "8g0g0484 0a6a"},
    {'F', "8g0g04 0a6a"},
    {'G', "8d6g2g0e062464868a5a"},
    {'H', "040g 848g 0a8a"},
    {'I', "242g 0444 0g4g"},
    {'J', "6g66442406"},
    {'K', "040g 8g09 3b84"},
    {'L', "0g0474"},
    {'M', "040g58aga4"},
    {'N', "040g848g"},
    {'O', "2g0e062464868e6g2g"},
    {'P', "040g6g8e8c6a0a"},
    {'Q', "2g0e062464868e6g2g 5783"},
    {'R', "040g6g8e8c6a0a 4a84"},
    {'S', "8e6g2g0e0c2a6a8886642406"},
    {'T', "0g8g 4g44"},
    {'U', "0g062464868g"},
    {'V', "0g448g"},
    {'W', "0g346e94cg"},
    {'X', "0g84 048g"},
    {'Y', "0g4a8g 4a44"},
    {'Z', "0g8g0484"},
    {'a', "7c74 7a5c2c0a06245476"},
    {'b', "0g04 0a2c5c7a76542406"},
    {'c', "7a5c2c0a06245476"},
    {'d', "7g74 7a5c2c0a06245476"},
    {'e', "08787a5c2c0a06245475"},
    {'f', "5g4g2e24 0c5c"},
    {'g', "7c72502001 7a5c2c0a06245476"},
    {'h', "0g04 0a2c5c7a74"},
    {'i', "0c04 0g0f"},
    {'j', "2c2200 2g2f"},
    {'k', "0g04 6c07 2964"},
    {'l', "0g04"},
    {'m', "0c04 0a2c4c5a54 5a7c9caaa4"},
    {'n', "0c04 0a2c5c7a74"},
    {'o', "2c0a062454767a5c2c"},
    {'p', "0c00 0a2c5c7a76542406"},
    {'q', "7c70 7a5c2c0a06245476"},
    {'r', "0c04 0a2c5c"},
    {'s', "6b5c2c0b096765541405"},
    {'t', "2g264454 0c5c"},
    {'u', "0c06245476 7c74"},
    {'v', "0c346c"},
    {'w', "0c245b84ac"},
    {'x', "0c74 047c"},
    {'y', "0c34 6c10"},
    {'z', "0c6c0464"},
    {'0', "2g0e062454767e5g2g"},
    {'1', "0d3g34"},
    {'2', "0d0e2g5g7e7c0474"},
    {'3', "0g7g3b5b7976542406"},
    {'4', "545g0888"},
    {'5', "7g0g0a2b5b7976542406"},
    {'6', "6g3f0b06245476795b2b09"},
    {'7', "0g7g24"},
    {'8', "2a0c0e2g5g7e7c5a2a0806245476785a"},
    {'9', "7b59290b0e2g5g7e794514"},
    {'.', "0405"},
    {',', "1402"},
    {':', "0405 0b0c"},
    {';', "1402 1b1c"},
    {'-', "0959"},
    {'+', "0969 3c36"},
    {'=', "0b6b 0767"},
    {'/', "026g"},
    {'(', "3h0d0531"},
    {')', "0h3d3501"},
    {'[', "3h0h0131"},
    {']', "0h3h3101"},
    {'_', "0282"},
    {'<', "6d0965"},
    {'>', "0d6905"},
    {'%', "8g04 1g0e1c2c3e2g1g 68566474867868"},
    {'*', "3e38 0d69 6d09"},
    {'!', "0g08 0504"},
    {'?', "0e2g5g7e7c4a48 4544"},
    {'\'', "0g0d"},
    {'"', "0g0d 3g3d"},
    {'^', "0d3g6d"},
    {'|', "0h01"},
    {'~', "092b587a"},
    {' ', ""},
};

constexpr double baseline = 4, letter_gap = 4, space = 6;

double digit(char c) { return c <= '9' ? c - '0' : c - 'a' + 10; }

}  // namespace

Glyph glyph(char character) {
    const auto* entry = std::ranges::find(font, character, &Entry::character);
    if (entry == std::ranges::end(font)) return glyph('?');
    if (entry->strokes.empty()) return {{}, space};
    Glyph result{{{}}, 0};
    for (std::size_t i = 0; i < entry->strokes.size(); ++i) {
        if (entry->strokes[i] == ' ') {
            result.strokes.emplace_back();
            continue;
        }
        const double x = digit(entry->strokes[i]), y = digit(entry->strokes[i + 1]) - baseline;
        ++i;
        result.strokes.back().push_back({x, y});
        result.advance = std::max(result.advance, x + letter_gap);
    }
    return result;
}

}  // namespace raylab
