#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 02` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(ray_sphere::inputs, ray_sphere::outputs, [](auto input, auto output) {
        ray_sphere::answer(&raylab::nearest_sphere_hit, input, output);
    });
}
