#pragma once

#include "raylab/base/error.h"
#include "raylab/geometry/vector.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace raylab {

/// The words of an NFF file, one after the other, without comments, and the line of the last one. Line ends separate
/// words like blanks, because the files of the Standard Procedural Databases break lines anywhere.
class NffTokens {
public:
    NffTokens(std::string_view text, std::string file);

    bool at_end() const { return next_begin_ == text_.size(); }
    bool number_follows() const;

    /// The next word. `expected` names it in the Error that is thrown where the file has ended.
    std::string_view word(const std::string& expected);

    double number(const std::string& expected);  // is finite and within a float's range
    double number_from(double smallest, double largest, const std::string& expected);
    int whole(int smallest, int largest, const std::string& expected);
    Vec3d vector(const std::string& expected);

    /// Throws an Error unless `count` things of at least `bytes` bytes each can still follow.
    void expect_room_for(int count, std::size_t bytes, const std::string& things) const;

    Place place() const { return {file_, line_}; }  // of the last word

private:
    void skip_to_word();
    std::string_view next_word() const;

    std::string_view text_;
    std::string file_;
    std::size_t next_begin_ = 0;
    int next_line_ = 1;
    int line_ = 1;
};

}  // namespace raylab
