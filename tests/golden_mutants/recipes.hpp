#pragma once
// Mutants of the three bases at any size: mostly damage to a few pixels, which must not pass because the
// frame around it is large.
#include "golden_mutants/bases.hpp"
#include "golden_mutants/mutants.hpp"

#include <functional>
#include <string>
#include <vector>

namespace sr::testing {

enum class Base { render, photo, interface };

using Change = std::function<void(image::Image&)>;

/// How a mutant is made of a base.
struct Recipe {
    Base base = Base::render;
    std::string name;
    bool passes = false;
    std::function<void(Mutant&)> change; // of a mutant whose test and reference are the base
    std::string diagnosis = any_diagnosis;
};

/// Damage that any picture can take.
std::vector<Recipe> damaged(Base base);
/// Mistakes of a renderer.
std::vector<Recipe> wrong_renders();
/// Mistakes of a photograph's processing.
std::vector<Recipe> wrong_photos();
/// Mistakes of a user interface.
std::vector<Recipe> wrong_interfaces();
/// Dotted lines, cut strokes, damage in layers, and damage beside known noise or a mask.
std::vector<Recipe> wrong_details();
/// Mistakes of a pixel or two, or of little contrast, in all bases.
std::vector<Recipe> wrong_by_little();
/// Differences that are no mistake.
std::vector<Recipe> harmless_recipes();
/// Both kinds, in all bases. Each verdict was written before the comparator first saw the mutant.
std::vector<Recipe> fresh_recipes();
/// Both kinds, in all bases: of kinds that no rule was made in sight of. Their verdicts were written
/// before the comparator first saw them, too.
std::vector<Recipe> unforeseen_recipes();
/// Pixels at edges that fall to the other side, and single pixels that are damaged. Their verdicts were
/// written before the comparator first saw them, too.
std::vector<Recipe> single_pixels();
/// All of the above.
std::vector<Recipe> recipes();

/// The mutant of a recipe. Bases are kept from one call to the next of the same size.
Mutant made(const Recipe& recipe, Extent size);

/// "render", "photo", "interface".
std::string name_of(Base base);

} // namespace sr::testing
