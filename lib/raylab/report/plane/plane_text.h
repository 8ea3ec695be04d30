#pragma once

#include <string>
#include <vector>

// The words of a drawing hold a few signs of markup: *italic*, **bold**, k_{r} with a subscript, x^{2} with a
// superscript. A star is markup only where it stands at a word and a later one ends it: "2 * 3" stays.

namespace raylab {

/// A part of a line of text that looks the same throughout.
struct PlaneTextRun {
    enum class Level { base, below, above };

    std::string words;
    bool italic = false, bold = false;
    Level level = Level::base;

    /// Sub- and superscripts are smaller.
    double size() const { return level == Level::base ? 1 : 0.72; }
    /// How far the run stands below the baseline, in heights of a capital.
    double drop() const { return level == Level::base ? 0 : level == Level::below ? 0.3 : -0.5; }

    bool operator==(const PlaneTextRun&) const = default;
};

std::vector<PlaneTextRun> plane_text_runs(const std::string& words);

}  // namespace raylab
