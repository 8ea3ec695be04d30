#include "raylab/scene/check_shape.h"
#include "raylab/scene/toml/read_parts.h"

namespace raylab::toml_file {

namespace {

AffineSteps read_scale(const Node& step) {
    const auto& value = step.value("scale");
    if (std::holds_alternative<Value::Array>(value.data)) return AffineSteps::scale(vector_of(value));
    const double factor = number_of(value);
    return AffineSteps::scale({factor, factor, factor});
}

AffineSteps read_rotation(const Node& rotation) {
    const auto axis = rotation.vector("axis");
    if (axis == Vec3d{0, 0, 0}) throw Error(rotation.place("axis"), "an axis that is not zero", "[0, 0, 0]");
    return AffineSteps::rotate(axis, rotation.number("degrees"));
}

// A matrix is given as three rows of four numbers, so that TOML shows it as it looks on paper.
AffineSteps read_matrix(const Node& step) {
    const auto& numbers = std::get<Value::Array>(step.value("matrix").data);
    const auto column = [&](std::size_t j) {
        return Vec3d{number_of(numbers.at(j)), number_of(numbers.at(4 + j)), number_of(numbers.at(8 + j))};
    };
    AffineSteps result;
    result.columns = {column(0), column(1), column(2)};
    result.translation = column(3);
    return result;
}

AffineSteps read_step(const Node& step) {
    if (step.has("translate")) return AffineSteps::translate(step.vector("translate"));
    if (step.has("scale")) return read_scale(step);
    if (step.has("rotate")) return read_rotation(step.table("rotate"));
    return read_matrix(step);
}

}  // namespace

AffineSteps read_transform(const Node& node, const char* key) {
    AffineSteps result;
    for (const auto& step : node.tables(key)) result = result.then(read_step(step));
    check_placement(result.rounded(), node.place(key));
    return result;
}

}  // namespace raylab::toml_file
