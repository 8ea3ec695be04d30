#include "catch.h"
#include "needs_scenes.h"

#include "raylab/scene/needs.h"

#include <algorithm>

// Tests of what `raylab needs` says of scenes whose rays are spread.

using namespace raylab;
using namespace pieces;

namespace {

std::vector<std::string> names(const std::vector<Note>& notes) {
    std::vector<std::string> all;
    for (const Note& note : notes) all.push_back(note.what);
    return all;
}

using Names = std::vector<std::string>;

const std::string emitter = "[material.emitter]\nemission = [1, 1, 1]\n",
                  gloss = "[material.satin]\nkr = 0.5\ngloss = 20\n",
                  lens = "[camera]\nlens = { radius = 0.1, focus = 4 }\n", path = "[render]\nmodel = \"path\"\n";

}  // namespace

TEST_CASE("a scene that spreads nothing asks for Whitted's model, and no number is named") {
    const Needs needs = needs_of(scene_of(red + light + sphere("red")));
    CHECK(needs.model == RenderModel::whitted);
    CHECK(needs.dimensions.empty());
    CHECK(needs.unreached.empty());
}

TEST_CASE("each dimension is named where the scene uses it, and only there") {
    CHECK(names(needs_of(scene_of(lens + red + light + sphere("red"))).dimensions) == Names{"pixel", "lens"});
    CHECK(names(needs_of(scene_of(emitter + red + sphere("emitter") + floor("red"))).dimensions) ==
          Names{"pixel", "light"});
    CHECK(names(needs_of(scene_of(gloss + light + floor("satin"))).dimensions) == Names{"pixel", "lobe"});
    CHECK(names(needs_of(scene_of(path + red + light + sphere("red"))).dimensions) == Names{"pixel", "diffuse"});
}

TEST_CASE("light that no strategy finds is named: from points, through glass and by mirrors") {
    CHECK(names(needs_of(scene_of(path + red + light + sphere("red"))).unreached).empty());
    CHECK(names(needs_of(scene_of(path + glass + red + light + floor("red") + sphere("glass"))).unreached) ==
          Names{"light through glass", "light by mirrors"});
    CHECK(names(needs_of(scene_of(path + mirror + emitter + red + floor("red") + sphere("mirror") + sphere("emitter")))
                    .unreached) == Names{"caustics of area lights"});
    CHECK(names(needs_of(scene_of(lens + red + light + sphere("red"))).unreached) == Names{"diffuse to diffuse"});
}
