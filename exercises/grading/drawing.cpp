#include "drawing.h"

#include <algorithm>
#include <iterator>

namespace raylab::grading {

std::vector<Case> cases_of(const Picture& picture) {
    if (picture.draw) return picture.all_cases();
    std::vector<Case> all;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            auto pixel = picture.cases(x, y);
            std::ranges::move(pixel, std::back_inserter(all));
        }
    return all;
}

Image drawn(const Exercise& exercise, std::span<const double> answers) {
    const auto& picture = exercise.picture;
    if (picture.draw) {
        const bool complete = answers.size() >= picture.all_cases().size() * exercise.outputs;
        return complete ? picture.draw(answers) : Image(picture.width, picture.height);
    }
    const auto a_pixel = picture.cases(0, 0).size() * exercise.outputs;
    Image image(picture.width, picture.height);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width && answers.size() >= a_pixel; ++x) {
            image.at(x, y) = picture.shade(x, y, answers.first(a_pixel));
            answers = answers.subspan(a_pixel);
        }
    return image;
}

}  // namespace raylab::grading
