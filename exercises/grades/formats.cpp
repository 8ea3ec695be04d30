#include "formats.h"

#include "raylab/base/error.h"
#include "raylab/base/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab::grading {

const std::vector<Format>& formats() {
    static const std::vector<Format> all{{"text", "for people", as_text},
                                         {"json", "everything that is known", as_json},
                                         {"gradescope", "Gradescope's results.json", as_gradescope},
                                         {"github", "a step of GitHub Classroom", as_github},
                                         {"junit", "JUnit's XML", as_junit},
                                         {"autolab", "Autolab's last lines", as_autolab},
                                         {"prairielearn", "PrairieLearn's results.json", as_prairielearn},
                                         {"tap", "Test Anything Protocol 14", as_tap}};
    return all;
}

const Format& format_of(const std::string& name) {
    const auto found = std::ranges::find(formats(), name, &Format::name);
    if (found != formats().end()) return *found;
    std::vector<std::string> names;
    for (const auto& format : formats()) names.push_back(format.name);
    throw Error(fmt::format("expected --format of {}, found {}", fmt::join(names, ", "), with_suggestion(name, names)));
}

}  // namespace raylab::grading
