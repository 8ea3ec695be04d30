#include "raylab/base/error.h"
#include "raylab/base/utf8.h"
#include "raylab/image/color.h"
#include "raylab/image/draw.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <cmath>
#include <memory>

namespace raylab {

namespace {

constexpr double fixed = 64;  // FreeType counts pixels in 64ths

// The font's glyphs. Nothing is hinted: a glyph is its outline at any size and any place between pixels, so that a
// text's width grows with its height exactly.
class Font {
public:
    Font() {
        const auto check = [](FT_Error problem, const char* expected) {
            if (problem != 0) throw Error({RAYLAB_FONT}, expected, "an unreadable file");
        };
        FT_Library library = nullptr;
        check(FT_Init_FreeType(&library), "FreeType");
        library_.reset(library);
        FT_Face face = nullptr;
        check(FT_New_Face(library, RAYLAB_FONT, 0, &face), "the font of labels");
        face_.reset(face);
        check(FT_Load_Char(face, 'H', FT_LOAD_NO_SCALE), "a font with capitals");
        capital_ = static_cast<double>(face->glyph->metrics.horiBearingY);
    }

    struct Placed {
        FT_UInt glyph;
        double x;  // in units in which a capital is 1 high
    };
    struct Line {
        std::vector<Placed> glyphs;
        double width;
    };
    Line line(std::string_view text) const {
        Line line{{}, 0};
        FT_UInt before = 0;
        while (!text.empty()) {
            constexpr std::uint32_t replacement = 0xfffd;
            const Utf8Character character = first_character(text);
            text.remove_prefix(character.bytes);
            const FT_UInt glyph = FT_Get_Char_Index(face_.get(), character.valid ? character.code : replacement);
            FT_Vector kerning{};
            FT_Get_Kerning(face_.get(), before, glyph, FT_KERNING_UNSCALED, &kerning);
            line.width += capitals(kerning.x);
            line.glyphs.push_back({glyph, line.width});
            FT_Load_Glyph(face_.get(), glyph, FT_LOAD_NO_SCALE);
            line.width += capitals(face_->glyph->metrics.horiAdvance);
            before = glyph;
        }
        return line;
    }

    // The coverage of the pixels that a glyph touches when its origin is at this point.
    const FT_GlyphSlot& drawn(FT_UInt glyph, Point2 origin, double height) const {
        const double em = height * face_->units_per_EM / capital_;
        FT_Set_Char_Size(face_.get(), 0, std::lround(fixed * em), 0, 0);
        FT_Load_Glyph(face_.get(), glyph, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP);
        const auto within = [](double x) { return std::lround(fixed * (x - std::floor(x))); };
        FT_Outline_Translate(&face_->glyph->outline, within(origin.x), -within(origin.y));
        FT_Render_Glyph(face_->glyph, FT_RENDER_MODE_NORMAL);
        return face_->glyph;
    }

private:
    double capitals(FT_Pos font_units) const { return static_cast<double>(font_units) / capital_; }

    struct Done {
        void operator()(FT_Library library) const { FT_Done_FreeType(library); }
        void operator()(FT_Face face) const { FT_Done_Face(face); }
    };
    std::unique_ptr<std::remove_pointer_t<FT_Library>, Done> library_;
    std::unique_ptr<std::remove_pointer_t<FT_Face>, Done> face_;
    double capital_ = 0;  // the height of a capital in the font's units
};

// One for each thread, because FreeType draws into the face.
const Font& font() {
    thread_local const Font font;
    return font;
}

// Mixes in code values, for which fonts are drawn: mixed as light, black letters on white look thin.
Pixel mixed(const Pixel& under, const Pixel& over, double cover) {
    const auto channel = [cover](float from, float to) {
        const double code = srgb_from_linear(unit_clamped(from)), end = srgb_from_linear(unit_clamped(to));
        return static_cast<float>(linear_from_srgb(code + cover * (end - code)));
    };
    return {channel(under.r, over.r), channel(under.g, over.g), channel(under.b, over.b)};
}

void paint(Image& image, int left, int top, const FT_Bitmap& bitmap, const Pixel& color) {
    for (int row = 0; row < static_cast<int>(bitmap.rows); ++row)
        for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
            const int x = left + column, y = top + row, cover = bitmap.buffer[row * bitmap.pitch + column];
            if (x < 0 || y < 0 || x >= image.width() || y >= image.height() || cover == 0) continue;
            image.at(x, y) = mixed(image.at(x, y), color, cover / 255.0);
        }
}

}  // namespace

double text_width(const std::string& text, double height) { return height * font().line(text).width; }

void draw_text(Image& image, Point2 at, double height, const std::string& text, const Pixel& color, Anchor anchor) {
    const Font::Line line = font().line(text);
    if (anchor != Anchor::left) at.x -= height * line.width * (anchor == Anchor::center ? 0.5 : 1.0);
    for (const auto& [glyph, x] : line.glyphs) {
        const Point2 origin{at.x + height * x, at.y};
        const FT_GlyphSlot& drawn = font().drawn(glyph, origin, height);
        paint(image, static_cast<int>(std::floor(origin.x)) + drawn->bitmap_left,
              static_cast<int>(std::floor(origin.y)) - drawn->bitmap_top, drawn->bitmap, color);
    }
}

}  // namespace raylab
