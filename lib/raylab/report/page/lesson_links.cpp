#include "raylab/report/page/lesson_links.h"

#include "raylab/base/error.h"
#include "raylab/report/provenance.h"

#include <algorithm>

namespace raylab {

namespace fs = std::filesystem;

LessonLinks::LessonLinks(const fs::path& readme, ChapterRun::Place place) : readme_(readme), place_(place) {}

std::string LessonLinks::target(const std::string& link) {
    if (link.starts_with("#") || link.starts_with("https://")) return link;
    const auto hash = std::min(link.find('#'), link.size());
    const auto path = (readme_.parent_path() / link.substr(0, hash)).lexically_normal();
    if (!fs::exists(path)) throw Error({readme_.string()}, "a link to what is there", link);
    const auto chapters = source_folder() / "chapters";
    if (path == chapters / "README.md") return place_ == ChapterRun::Place::in_book ? "../index.html" : "";
    if (path.filename() == "README.md" && path.parent_path().parent_path() == chapters)
        return place_ == ChapterRun::Place::in_book
                   ? "../" + path.parent_path().filename().string() + "/index.html" + link.substr(hash)
                   : "";
    if (!fs::is_regular_file(path)) return "";
    if (std::ranges::find(sources_, path) == sources_.end()) sources_.push_back(path);
    return source_copy(path);
}

const fs::path& LessonLinks::file(const std::string& target) const {
    const auto found = std::ranges::find(sources_, target, source_copy);
    if (found == sources_.end()) throw Error({readme_.string()}, "a link to a file of the repository", target);
    return *found;
}

std::string source_copy(const fs::path& source) {
    const auto name = source.filename().string();
    return "source/" + (name == "README.md" ? source.parent_path().filename().string() + "_" : "") + name + ".txt";
}

}  // namespace raylab
