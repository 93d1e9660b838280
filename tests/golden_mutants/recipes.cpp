#include "golden_mutants/recipes.hpp"

#include "golden_mutants/change.hpp"

#include <cmath>
#include <map>

namespace sr::testing {
namespace {

using image::Image;

/// `f(pixel's colours)` in a rectangle.
template<typename Function>
void for_pixels(Image& image, int left, int top, int width, int height, const Function& f) {
    for (int y = std::max(top, 0); y < std::min(top + height, image.height); ++y)
        for (int x = std::max(left, 0); x < std::min(left + width, image.width); ++x)
            f(image.at(x, y).first(3));
}

void fill(Image& image, int left, int top, int width, int height, float value) {
    for_pixels(image, left, top, width, height, [value](auto pixel) { std::ranges::fill(pixel, value); });
}

/// A place where the picture has something to lose: the brightest of some.
std::pair<int, int> bright_place(const Image& image, int margin) {
    Random random(31);
    std::pair<int, int> best{margin, margin};
    float most = -1.0f;
    for (int k = 0; k < 64; ++k) {
        const int x =
            margin + static_cast<int>(random.uniform() * static_cast<float>(image.width - 2 * margin));
        const int y =
            margin + static_cast<int>(random.uniform() * static_cast<float>(image.height - 2 * margin));
        const float value = std::min(image.at(x, y)[1], 1.5f);
        if (value > most) best = {x, y};
        most = std::max(most, value);
    }
    return best;
}

/// A place with contrast: the greatest range of G in 5×5 pixels of some.
std::pair<int, int> busy_place(const Image& image) {
    Random random(32);
    std::pair<int, int> best{12, 12};
    float most = -1.0f;
    for (int k = 0; k < 1000; ++k) {
        const int x = 12 + static_cast<int>(random.uniform() * static_cast<float>(image.width - 24));
        const int y = 12 + static_cast<int>(random.uniform() * static_cast<float>(image.height - 24));
        float low = 1e9f, high = -1e9f;
        for (int v = -2; v <= 2; ++v)
            for (int u = -2; u <= 2; ++u) {
                low = std::min(low, image.at(x + u, y + v)[1]);
                high = std::max(high, std::min(image.at(x + u, y + v)[1], 2.0f));
            }
        if (high - low > most) best = {x, y};
        most = std::max(most, high - low);
    }
    return best;
}

void many_squares(Image& image, int count, int edge, float value) {
    Random random(33);
    for (int k = 0; k < count; ++k) {
        const int x = static_cast<int>(random.uniform() * static_cast<float>(image.width - edge));
        const int y = static_cast<int>(random.uniform() * static_cast<float>(image.height - edge));
        fill(image, x, y, edge, edge, value);
    }
}

/// A patch replaced by what lies `dx`, `dy` away.
void copy_patch(Image& image, int left, int top, int edge, int dx, int dy) {
    const Image right = image;
    for (int y = top; y < top + edge; ++y)
        for (int x = left; x < left + edge; ++x)
            std::ranges::copy(
                right.at(std::clamp(x + dx, 0, image.width - 1), std::clamp(y + dy, 0, image.height - 1)),
                image.at(x, y).begin());
}

void blur_patch(Image& image, int left, int top, int edge) {
    const Image right = image;
    for (int y = top; y < top + edge; ++y)
        for (int x = left; x < left + edge; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                float sum = 0.0f;
                for (int k = 0; k < 9; ++k) sum += right.at(x + k % 3 - 1, y + k / 3 - 1)[c];
                image.at(x, y)[c] = sum / 9.0f;
            }
}

/// Pixels of a patch exchanged at random, as where two surfaces fight for the same depth.
void shuffle_patch(Image& image, int left, int top, int edge) {
    Random random(34);
    for (int y = top; y < top + edge; ++y)
        for (int x = left; x < left + edge; ++x)
            if (random.uniform() < 0.5f)
                std::swap_ranges(image.at(x, y).begin(), image.at(x, y).end(),
                                 image.at(x + 1, y + 1).begin());
}

void dead_column(Image& image, float value) { fill(image, image.width * 5 / 9, 0, 1, image.height, value); }

void dead_row(Image& image, float value) { fill(image, 0, image.height * 5 / 9, image.width, 1, value); }

/// One row moved a pixel to the right.
void move_row(Image& image, int row) {
    const Image right = image;
    for (int x = 1; x < image.width; ++x) std::ranges::copy(right.at(x - 1, row), image.at(x, row).begin());
}

float mean_of(const Image& image, int left, int top, int edge, std::size_t channel) {
    float sum = 0.0f;
    for (int y = top; y < top + edge; ++y)
        for (int x = left; x < left + edge; ++x) sum += image.at(x, y)[channel];
    return sum / static_cast<float>(edge * edge);
}

void flatten_block(Image& image, int left, int top, int edge) {
    for (std::size_t c = 0; c < 3; ++c) {
        const float mean = mean_of(image, left, top, edge, c);
        for_pixels(image, left, top, edge, edge, [&](auto pixel) { pixel[c] = mean; });
    }
}

/// Seams: one row in 64 is darker.
void darken_seams(Image& image) {
    for (int y = 64; y < image.height; y += 64)
        for_pixels(image, 0, y, image.width, 1, [](auto pixel) {
            for (float& value : pixel) value *= 0.9f;
        });
}

} // namespace

std::vector<Recipe> damaged(Base base) {
    const float black = 0.0f, white = base == Base::render ? 5000.0f : 1.0f;
    std::vector<Recipe> list;
    const auto add = [&](const char* name, Change change, const char* diagnosis = "*") {
        list.push_back({base, name, false, [change](Mutant& m) { change(m.test); }, diagnosis});
    };
    const auto at_bright = [](auto change) {
        return [change](Image& i) {
            const auto [x, y] = bright_place(i, 12);
            change(i, x, y);
        };
    };
    const auto at_busy = [](auto change) {
        return [change](Image& i) {
            const auto [x, y] = busy_place(i);
            change(i, x - 4, y - 4);
        };
    };
    add("black_square_7", at_bright([=](Image& i, int x, int y) { fill(i, x, y, 7, 7, black); }));
    add("black_square_3", at_bright([=](Image& i, int x, int y) { fill(i, x, y, 3, 3, black); }));
    add("black_squares_30", [=](Image& i) { many_squares(i, 30, 7, black); });
    add("dead_pixel", at_bright([=](Image& i, int x, int y) { fill(i, x, y, 1, 1, black); }));
    add("fireflies_20", [=](Image& i) { many_squares(i, 20, 1, white == 1.0f ? 1.0f : 300.0f); });
    add("magenta_pixels", at_bright([=](Image& i, int x, int y) {
            for (int k = 0; k < 3; ++k)
                std::ranges::copy(std::array{1.0f, 0.0f, 1.0f}, i.at(x + 3 * k, y).begin());
        }));
    add("dead_column", [=](Image& i) { dead_column(i, black); });
    add("dead_row", [=](Image& i) { dead_row(i, black); });
    add("row_moved", [](Image& i) { move_row(i, i.height * 7 / 12); });
    add("block_flattened", at_busy([](Image& i, int x, int y) { flatten_block(i, x, y, 8); }));
    add("block_blurred", at_busy([](Image& i, int x, int y) { blur_patch(i, x, y, 9); }));
    add("block_from_elsewhere", at_busy([](Image& i, int x, int y) { copy_patch(i, x, y, 9, 40, 23); }));
    add("block_shifted", at_busy([](Image& i, int x, int y) { copy_patch(i, x, y, 9, 1, 1); }));
    add("block_shuffled", at_busy([](Image& i, int x, int y) { shuffle_patch(i, x, y, 9); }));
    add("seams", darken_seams);
    add("block_4_percent_darker", at_bright([](Image& i, int x, int y) {
            for_pixels(i, x - 6, y - 6, 12, 12, [](auto p) {
                for (float& v : p) v *= 0.96f;
            });
        }));
    add("block_without_green",
        at_bright([](Image& i, int x, int y) { for_pixels(i, x, y, 5, 5, [](auto p) { p[1] = 0.0f; }); }));
    add(
        "half_black_left", [](Image& i) { fill(i, 0, 0, i.width / 2, i.height, 0.0f); }, "black_in_part");
    add(
        "half_black_below", [](Image& i) { fill(i, 0, i.height / 2, i.width, i.height, 0.0f); },
        "black_in_part");
    return list;
}

std::vector<Recipe> recipes() {
    std::vector<Recipe> all;
    for (const Base base : {Base::render, Base::photo, Base::interface})
        for (Recipe& recipe : damaged(base)) all.push_back(std::move(recipe));
    for (auto* family : {wrong_renders, wrong_photos, wrong_interfaces, wrong_details, wrong_by_little,
                         harmless_recipes, fresh_recipes, unforeseen_recipes, single_pixels})
        for (Recipe& recipe : family()) all.push_back(std::move(recipe));
    return all;
}

std::string name_of(Base base) {
    return base == Base::render ? "render" : base == Base::photo ? "photo" : "interface";
}

Mutant made(const Recipe& recipe, Extent size) {
    static std::map<Base, Image> bases;
    static Extent of;
    if (size.width != of.width || size.height != of.height) bases.clear();
    of = size;
    if (!bases.contains(recipe.base))
        bases[recipe.base] = recipe.base == Base::render  ? render_base(size)
                             : recipe.base == Base::photo ? photo_base(size)
                                                          : interface_base(size);
    Mutant mutant{name_of(recipe.base) + "." + recipe.name,
                  bases[recipe.base],
                  bases[recipe.base],
                  recipe.passes,
                  recipe.diagnosis,
                  {},
                  {}};
    if (recipe.base != Base::render) mutant.options.encoding = compare::Encoding::display_referred;
    recipe.change(mutant);
    if (recipe.base != Base::render && mutant.options.bits == 8) round_to_codes(mutant.test); // as in a file
    return mutant;
}

} // namespace sr::testing
