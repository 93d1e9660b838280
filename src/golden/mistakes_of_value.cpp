#include "golden/mistakes.hpp"
#include "golden/screen.hpp"

#include <array>
#include <fmt/format.h>
#include <numbers>

namespace sr::golden {
namespace {

struct NamedFactor {
    double factor; // test = factor × reference
    const char* name;
    const char* meaning;
};

constexpr double pi = std::numbers::pi;
constexpr std::array named_factors{NamedFactor{pi, "pi_missing", "a division by π is missing"},
                                   NamedFactor{1.0 / pi, "pi_twice", "a division by π too many"},
                                   NamedFactor{2.0, "factor_two", "a factor of two too much"},
                                   NamedFactor{0.5, "factor_half", "a factor of two is missing"},
                                   NamedFactor{2.0 * pi, "two_pi_missing", "a division by 2π is missing"},
                                   NamedFactor{0.5 / pi, "two_pi_twice", "a division by 2π too many"},
                                   NamedFactor{4.0 * pi, "four_pi_missing", "a division by 4π is missing"},
                                   NamedFactor{0.25 / pi, "four_pi_twice", "a division by 4π too many"},
                                   NamedFactor{683.0, "lumens_for_watts", "683 lm/W applied once too often"},
                                   NamedFactor{1.0 / 683.0, "watts_for_lumens", "683 lm/W is missing"}};
constexpr double same_factor = 0.01; // relative: what a median still misses in a noisy image

/// Whether a value tells a factor: above the floor, and not where a screen clips.
bool tells(const Evidence& e, float t, float r) {
    return r > e.floor && t > 0.0f && r < 0.98f * e.most && t < 0.98f * e.most;
}

/// The median of t / r over the channels from `first` up to `last`; 1 where nothing tells.
float fitted_factor(const Evidence& e, std::size_t first, std::size_t last) {
    std::vector<float> ratios;
    for (const std::size_t i : e.fitted)
        for (std::size_t c = first; c < last; ++c)
            if (tells(e, e.t(i, c), e.r(i, c))) ratios.push_back(e.t(i, c) / e.r(i, c));
    return ratios.empty() ? 1.0f : median(std::move(ratios));
}

void try_factor(const Evidence& e, Trials& trials) {
    const float fitted = fitted_factor(e, 0, e.colors);
    for (const NamedFactor& named : named_factors) {
        if (std::abs(static_cast<double>(fitted) / named.factor - 1.0) > same_factor) continue;
        const auto k = static_cast<float>(named.factor);
        const double rest = residual(e, [&](std::size_t i, std::size_t c) { return k * e.r(i, c); });
        trials.push_back({{named.name,
                           fmt::format("test = {:.5g} × reference {}: {}", k, e.where, named.meaning),
                           rest,
                           {}},
                          1});
    }
    const double rest = residual(e, [&](std::size_t i, std::size_t c) { return fitted * e.r(i, c); });
    trials.push_back({{"exposure",
                       fmt::format("test = {:.4g} × reference {}: {:+.2f} EV of exposure or intensity",
                                   fitted, e.where, std::log2(fitted)),
                       rest,
                       {}},
                      3});
}

void try_gains(const Evidence& e, Trials& trials) {
    std::array<float, 3> gains{};
    for (std::size_t c = 0; c < 3; ++c) gains[c] = fitted_factor(e, c, c + 1);
    const auto [low, high] = std::ranges::minmax(gains);
    if (high < 1.01f * low) return; // one factor says it all
    const double rest = residual(e, [&](std::size_t i, std::size_t c) { return gains[c] * e.r(i, c); });
    trials.push_back(
        {{"channel_gains",
          fmt::format("test = ({:.4g}, {:.4g}, {:.4g}) × reference {}: a tint or a white balance", gains[0],
                      gains[1], gains[2], e.where),
          rest,
          {}},
         5});
}

void try_offset(const Evidence& e, Trials& trials) {
    std::array<float, 3> offsets{};
    for (std::size_t c = 0; c < e.colors; ++c) {
        std::vector<float> differences;
        for (const std::size_t i : e.pixels)
            if (e.t(i, c) < 0.98f * e.most) differences.push_back(e.t(i, c) - e.r(i, c));
        offsets[c] = median(std::move(differences));
    }
    const bool adds = offsets[0] > 0.0f || offsets[1] > 0.0f || offsets[2] > 0.0f;
    const double rest = residual(e, [&](std::size_t i, std::size_t c) { return offsets[c] + e.r(i, c); });
    trials.push_back({{adds ? "ambient_added" : "offset",
                       fmt::format("test = reference + ({:.4g}, {:.4g}, {:.4g}) {}: {}", offsets[0],
                                   offsets[e.colors / 2], offsets[e.colors - 1], e.where,
                                   adds ? "a constant, such as an ambient term" : "a black level"),
                       rest,
                       {}},
                      5});
}

} // namespace

void try_blank(const Evidence& e, Trials& trials) {
    std::array<float, 3> first{};
    for (std::size_t c = 0; c < e.colors; ++c) first[c] = e.t(e.pixels.front(), c);
    bool is_black = true, is_uniform = true, reference_is_uniform = true;
    for (const std::size_t i : e.pixels)
        for (std::size_t c = 0; c < e.colors; ++c) {
            is_black = is_black && std::abs(e.t(i, c)) <= 1e-3f * e.floor;
            is_uniform = is_uniform && e.t(i, c) == first[c];
            reference_is_uniform = reference_is_uniform && e.r(i, c) == e.r(e.pixels.front(), c);
        }
    if (is_black)
        trials.push_back(
            {{"black", "test is black everywhere: nothing was drawn, or no light is on", 0.0, {}}, 0});
    else if (is_uniform && !reference_is_uniform)
        trials.push_back(
            {{"uniform",
              fmt::format("test is ({:.4g}, {:.4g}, {:.4g}) everywhere: a clear colour or a sentinel",
                          first[0], first[e.colors / 2], first[e.colors - 1]),
              0.0,
              {}},
             0});
}

void try_factors(const Evidence& e, Trials& trials) {
    try_factor(e, trials);
    if (!e.is_whole) return; // a few pixels fit too many tints
    if (e.colors == 3) try_gains(e, trials);
    try_offset(e, trials);
}

void try_curves(const Evidence& e, Trials& trials) {
    const auto try_curve = [&](const char* name, const char* statement, auto curve) {
        const double rest = residual(e, [&](std::size_t i, std::size_t c) { return curve(e.r(i, c)); });
        trials.push_back({{name, fmt::format("test = {} {}", statement, e.where), rest, {}}, 2});
    };
    const auto clamped = [](float value) { return std::clamp(value, 0.0f, 1.0f); };
    const auto power = [](float value, float exponent) { return std::pow(std::max(value, 0.0f), exponent); };
    try_curve("srgb_applied", "the sRGB code of the reference", srgb_encoded_unclamped);
    try_curve("srgb_applied", "the sRGB code of the reference, clamped to 1,",
              [&](float r) { return srgb_encoded_unclamped(clamped(r)); });
    try_curve("srgb_applied_twice", "the sRGB code of the sRGB code of the reference",
              [](float r) { return srgb_encoded_unclamped(srgb_encoded_unclamped(r)); });
    try_curve("srgb_applied_twice", "the sRGB code of the sRGB code of the reference, clamped to 1,",
              [&](float r) { return srgb_encoded_unclamped(srgb_encoded_unclamped(clamped(r))); });
    try_curve("srgb_missing", "the reference as if it were an sRGB code, decoded,", srgb_decoded);
    try_curve("gamma_applied", "reference^(1/2.2)", [&](float r) { return power(r, 1.0f / 2.2f); });
    try_curve("gamma_missing", "reference^2.2", [&](float r) { return power(r, 2.2f); });
    if (e.most > 1.0f) try_curve("clamped", "the reference clamped to 0..1", clamped);
}

void try_channel_orders(const Evidence& e, Trials& trials) {
    if (e.colors != 3) return;
    constexpr std::array<const char*, 3> letters{"R", "G", "B"};
    std::array<std::size_t, 3> order{0, 1, 2};
    while (std::ranges::next_permutation(order).found) {
        const double rest = residual(e, [&](std::size_t i, std::size_t c) { return e.r(i, order[c]); });
        trials.push_back({{"channels_swapped",
                           fmt::format("test's R, G, B are the reference's {}, {}, {} {}", letters[order[0]],
                                       letters[order[1]], letters[order[2]], e.where),
                           rest,
                           {}},
                          2});
    }
}

} // namespace sr::golden
