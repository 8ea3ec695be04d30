#include "raylab/report/plane/plane_text.h"

#include <string_view>

namespace raylab {

std::vector<PlaneTextRun> plane_text_runs(const std::string& words) {
    using Level = PlaneTextRun::Level;
    std::vector<PlaneTextRun> runs;
    PlaneTextRun now;
    const auto end_run = [&] {
        if (!now.words.empty()) runs.push_back(now);
        now.words.clear();
    };
    std::string_view rest = words;
    const auto turns = [&](std::string_view stars, bool& face) {
        if (!rest.starts_with(stars)) return false;
        const std::string_view after = rest.substr(stars.size());
        const bool opens = !after.empty() && after[0] != ' ' && after[0] != '*' && after.find(stars) != after.npos;
        if (!face && !opens) return false;
        end_run();
        face = !face;
        rest = after;
        return true;
    };
    const auto shifts = [&](std::string_view sign, Level to) {
        if (now.level != Level::base || !rest.starts_with(sign) || rest.find('}') == std::string_view::npos)
            return false;
        end_run();
        now.level = to;
        rest = rest.substr(sign.size());
        return true;
    };
    while (!rest.empty()) {
        if (turns("**", now.bold) || turns("*", now.italic)) continue;
        if (shifts("_{", Level::below) || shifts("^{", Level::above)) continue;
        if (now.level != Level::base && rest[0] == '}') {
            end_run();
            now.level = Level::base;
        } else {
            now.words += rest[0];
        }
        rest.remove_prefix(1);
    }
    end_run();
    return runs;
}

}  // namespace raylab
