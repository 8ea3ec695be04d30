#pragma once

#include "raylab/experiment/measure/measure.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

// How one run of a chapter's program was asked for.

namespace raylab {

/// The title of a chapter and the question it answers.
struct ChapterTitle {
    std::string folder;    // "02_spheres_and_quadrics"
    std::string title;     // "Spheres and quadrics"
    std::string question;  // "Where does a ray hit an implicit surface?"
};

/// The options of a chapter: --out DIR, --quick, --threads N, --seed S, --scene FILE, --only PART, --figure NAME,
/// --case NAME, --rows, --json FILE, --yours SLOT.
struct ChapterRun {
    enum class Effort { full, quick };
    // The folder for its files, which are moved to DIR/02_spheres_and_quadrics in the end.
    std::filesystem::path out = {};
    std::filesystem::path scene = {};   // the chapter's scene.toml unless --scene names another
    std::filesystem::path lesson = {};  // the chapter's README.md unless --lesson names another
    std::string figure = {};            // the only figure that is wanted; empty: all
    Effort effort = Effort::full;
    int threads = 0;  // 0: all cores
    std::uint64_t seed = 1;
    std::string yours = {};  // the slot with a student's function in it, "light_cell"; empty: none

    /// Whether the chapter is part of the lab book: `tour` sets it, with the folders of the neighbouring chapters
    /// (empty: none).
    enum class Place { alone, in_book } place = Place::alone;
    std::string previous, next;

    /// Whether this slot has a student's function in it, which is shown among the methods as `yours`. A method that
    /// asks no slot has "" here: it is nobody's, also where no slot is named.
    bool is_yours(std::string_view slot) const { return !slot.empty() && yours == slot; }
    /// The name of a method that asks this slot: `yours`, or its own.
    std::string name_of(std::string_view slot, const std::string& own) const { return is_yours(slot) ? "yours" : own; }

    /// `full` in a full run, `quick` in a quick one.
    template <class T>
    T sized(T full_size, T quick_size) const {
        return effort == Effort::full ? full_size : quick_size;
    }

    /// How methods are timed: a quick run is just accurate enough to tell the fast ones from the slow ones.
    MeasureOptions timing() const { return sized<MeasureOptions>({}, {.repeats = 3, .shortest = 0.0005}); }
};

}  // namespace raylab
