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

TEST_CASE("of a picture whose rays are spread no light, lobe or ray that it needs is said to be left out") {
    const Needs lit = needs_of(scene_of(emitter + red + sphere("emitter") + floor("red")));
    CHECK(matches(lit.paths, "LDE") == 1);
    CHECK(mentions(lit.asked, "diffuse lobe"));
    CHECK(mentions(lit.asked, "shadow rays to surfaces"));
    CHECK_FALSE(mentions(lit.left_out, "shadow rays"));
    CHECK(mentions(lit.left_out, "reflected rays"));
    // A glossy surface answers to a point, if nothing is diffuse.
    const Needs glossy = needs_of(scene_of(gloss + light + floor("satin")));
    CHECK(matches(glossy.paths, "LSE") == 1);
    CHECK(mentions(glossy.asked, "shadow rays to points"));
    CHECK(mentions(glossy.asked, "any depth"));
    const Needs dark = needs_of(scene_of(lens + red + sphere("red")));
    CHECK(mentions(dark.left_out, "shadow rays"));
}

TEST_CASE("paths say that they leave out the ambient term and highlights, and find points by rough mirrors") {
    const std::string shiny = "[background]\nambient = [1, 1, 1]\n[material.shiny]\nambient = [0.1, 0.1, 0.1]\n"
                              "diffuse = [0.5, 0.5, 0.5]\nspecular = [0.3, 0.3, 0.3]\n";
    const Needs needs = needs_of(scene_of(path + shiny + light + sphere("shiny")));
    CHECK(names(needs.unreached) == Names{"ambient term", "highlights"});
    CHECK_FALSE(mentions(needs.asked, "ambient term"));
    CHECK(matches(needs.paths, "LDDDE") == 1);
    CHECK(names(needs_of(scene_of(path + gloss + red + light + floor("red") + sphere("satin"))).unreached).empty());
    // Of distributed rays diffuse surfaces send none to a mirror, whether it is sharp or not.
    CHECK(names(needs_of(scene_of(gloss + red + light + floor("red") + sphere("satin"))).unreached) ==
          Names{"light by mirrors", "diffuse to diffuse"});
}
