#pragma once

#include "exercise.h"

#include <filesystem>
#include <optional>
#include <string>

namespace raylab {

/// A student's file for one exercise, and what its last check said.
class WatchedExercise {
public:
    /// Its file is the stub in the exercise's folder.
    explicit WatchedExercise(const grading::Exercise& exercise);
    WatchedExercise(const grading::Exercise& exercise, const std::filesystem::path& file);

    /// Checks the file if it was saved since the last look; whether it was.
    bool look();
    /// Lets the next look check the file, saved or not.
    void forget() { saved_.reset(); }

    std::string name() const { return exercise_->folder; }
    std::string file() const;  // as a person would type it
    std::string readme() const;
    bool passed() const { return passed_; }
    /// Whether the stub has become more than a stub.
    bool is_begun() const;

    /// The first thing that is wrong: where it does not compile, the compiler's first message; else the first wrong
    /// case.
    std::string in_short() const { return in_short_; }
    std::string at_length() const { return at_length_; }  // all that the check says
    /// Yours beside the reference's picture, as text for this terminal; none: it shows none, or there is none.
    std::string preview() const { return preview_; }
    /// What the check thinks is wrong, then the exercise's own hints one after the other.
    std::string hint(std::size_t which) const;

private:
    const grading::Exercise* exercise_;
    std::filesystem::path file_;
    std::optional<std::filesystem::file_time_type> saved_;
    bool passed_ = false;
    std::string in_short_, at_length_, hint_, preview_;
};

}  // namespace raylab
