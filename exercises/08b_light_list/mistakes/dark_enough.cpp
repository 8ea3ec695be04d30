// hint: hardly_dark
// Gathers shadow. From 99 hundredths on it is said to be full.
#include "raylab/accelerator/light_buffer/light_through_list.h"

double raylab::light_through_list(const AskedLightList& list) {
    double shadow = list.depth > list.filled ? 1 : 0;
    int i = 0;
    while (shadow <= 0.99 && i != list.entries && list.begin(i) <= list.depth) {
        shadow = 1 - (1 - shadow) * list.through(i);
        ++i;
    }
    return shadow > 0.99 ? 0 : 1 - shadow;
}
