#include "answering.h"
#include "arguments.h"

// The student's program: cases in, answers out. `raylab check 03` starts it and judges its answers.
int main() {
    using namespace raylab::grading;
    return answer_cases(ray_triangle::inputs, ray_triangle::outputs,
                        [](auto input, auto output) { ray_triangle::answer(&raylab::triangle_hit, input, output); });
}
