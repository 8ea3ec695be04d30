#include "isolation_json.h"

#include <nlohmann/json.hpp>

namespace raylab::grading {

nlohmann::ordered_json to_json(const Isolation& isolation) {
    return {{"level", static_cast<int>(isolation.level)},
            {"landlock", isolation.landlock},
            {"seccomp", isolation.level >= Level::system_calls},
            {"own_user", isolation.own_user}};
}

}  // namespace raylab::grading
