#include "compare/hypotheses/hypothesis.hpp"
#include "compare/planes.hpp"

#include <array>
#include <fmt/format.h>
#include <numbers>

namespace sr::compare {
namespace {

struct NamedFactor {
    double factor; // test = factor × reference
    const char* name;
    const char* meaning;
};

constexpr std::array named_factors{
    NamedFactor{std::numbers::pi, "pi_missing", "a division by π is missing"},
    NamedFactor{1.0 / std::numbers::pi, "pi_twice", "a division by π too many"},
    NamedFactor{2.0, "factor_two", "a factor of two too much"},
    NamedFactor{0.5, "factor_half", "a factor of two is missing"},
    NamedFactor{2.0 * std::numbers::pi, "two_pi_missing", "a division by 2π is missing"},
    NamedFactor{0.5 / std::numbers::pi, "two_pi_twice", "a division by 2π too many"},
    NamedFactor{4.0 * std::numbers::pi, "four_pi_missing", "a division by 4π is missing"},
    NamedFactor{0.25 / std::numbers::pi, "four_pi_twice", "a division by 4π too many"},
    NamedFactor{683.0, "lumens_for_watts", "683 lm/W applied once too often"},
    NamedFactor{1.0 / 683.0, "watts_for_lumens", "683 lm/W is missing"}};
constexpr double same_factor = 0.003;         // relative: 3.12 is not π
constexpr double same_factor_in_noise = 0.01; // the error of a median is larger

/// The median; 0 of no values.
float median(std::vector<float> values) {
    if (values.empty()) return 0.0f;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// True if two values tell a factor: above the floor, and not clipped by a screen.
bool tells(const DiagnosisInput& in, float t, float r) {
    return r > in.floor && t > 0.0f && r < 0.98f * in.max_value && t < 0.98f * in.max_value;
}

/// The median of t / r over the channels from `first` up to `last`; 1 if no pixel tells.
float fitted_factor(const DiagnosisInput& in, std::size_t first, std::size_t last) {
    std::vector<float> ratios;
    for (const std::size_t i : in.fitted)
        for (std::size_t c = first; c < last; ++c)
            if (tells(in, in.t(i, c), in.r(i, c))) ratios.push_back(in.t(i, c) / in.r(i, c));
    return ratios.empty() ? 1.0f : median(std::move(ratios));
}

void add_factor(const DiagnosisInput& in, Hypotheses& out) {
    const float fitted = fitted_factor(in, 0, in.colors);
    for (const NamedFactor& named : named_factors) {
        const double same = in.has_noise ? same_factor_in_noise : same_factor;
        if (std::abs(static_cast<double>(fitted) / named.factor - 1.0) > same) continue;
        const auto k = static_cast<float>(named.factor);
        const double left = residual(in, [&](std::size_t i, std::size_t c) { return k * in.r(i, c); });
        out.push_back({{named.name,
                        fmt::format("test = {:.5g} × reference {}: {}", k, in.where, named.meaning),
                        left,
                        {}},
                       1});
    }
    const double left = residual(in, [&](std::size_t i, std::size_t c) { return fitted * in.r(i, c); });
    out.push_back({{"exposure",
                    fmt::format("test = {:.4g} × reference {}: {:+.2f} EV of exposure or intensity", fitted,
                                in.where, std::log2(fitted)),
                    left,
                    {}},
                   3,
                   true});
}

void add_gains(const DiagnosisInput& in, Hypotheses& out) {
    std::array<float, 3> gains{};
    for (std::size_t c = 0; c < 3; ++c) gains[c] = fitted_factor(in, c, c + 1);
    const auto [low, high] = std::ranges::minmax(gains);
    if (high < 1.01f * low) return; // one factor says it all
    const double left = residual(in, [&](std::size_t i, std::size_t c) { return gains[c] * in.r(i, c); });
    out.push_back({{"channel_gains",
                    fmt::format("test = ({:.4g}, {:.4g}, {:.4g}) × reference {}: a tint or a white balance",
                                gains[0], gains[1], gains[2], in.where),
                    left,
                    {}},
                   5,
                   true});
}

void add_offset(const DiagnosisInput& in, Hypotheses& out) {
    std::array<float, 3> offsets{};
    for (std::size_t c = 0; c < in.colors; ++c) {
        std::vector<float> differences;
        for (const std::size_t i : in.pixels)
            if (in.t(i, c) < 0.98f * in.max_value) differences.push_back(in.t(i, c) - in.r(i, c));
        offsets[c] = median(std::move(differences));
    }
    const bool adds = offsets[0] > 0.0f || offsets[1] > 0.0f || offsets[2] > 0.0f;
    const double left = residual(in, [&](std::size_t i, std::size_t c) { return offsets[c] + in.r(i, c); });
    out.push_back({{adds ? "ambient_added" : "offset",
                    fmt::format("test = reference + ({:.4g}, {:.4g}, {:.4g}) {}: {}", offsets[0],
                                offsets[in.colors / 2], offsets[in.colors - 1], in.where,
                                adds ? "a constant, such as an ambient term" : "a black level"),
                    left,
                    {}},
                   5});
}

} // namespace

void hypotheses_blank(const DiagnosisInput& in, Hypotheses& out) {
    constexpr double most = 0.5; // of the reference has another colour: a line that is missing leaves less
    std::array<float, 3> first{};
    for (std::size_t c = 0; c < in.colors; ++c) first[c] = in.t(in.fitted.front(), c);
    bool is_black = true, is_uniform = true, reference_is_uniform = true;
    std::size_t others = 0;
    for (const std::size_t i : in.fitted) {
        bool is_other = false;
        for (std::size_t c = 0; c < in.colors; ++c) {
            is_black = is_black && std::abs(in.t(i, c)) <= 1e-3f * in.floor;
            is_uniform = is_uniform && in.t(i, c) == first[c];
            reference_is_uniform = reference_is_uniform && in.r(i, c) == in.r(in.fitted.front(), c);
            is_other = is_other || in.distance(in.r(i, c), first[c]) > 0.01f;
        }
        others += is_other;
    }
    const bool reference_is_other =
        !reference_is_uniform && static_cast<double>(others) >= most * static_cast<double>(in.fitted.size());
    if (is_black)
        out.push_back(
            {{"black", "test is black everywhere: nothing was drawn, or no light is on", 0.0, {}}, 0});
    else if (is_uniform && reference_is_other)
        out.push_back(
            {{"uniform",
              fmt::format("test is ({:.4g}, {:.4g}, {:.4g}) everywhere: a clear colour or a sentinel",
                          first[0], first[in.colors / 2], first[in.colors - 1]),
              0.0,
              {}},
             0});
}

void hypotheses_factors(const DiagnosisInput& in, Hypotheses& out) {
    add_factor(in, out);
    if (!in.is_whole) return; // too many tints fit a few pixels
    if (in.colors == 3) add_gains(in, out);
    add_offset(in, out);
}

namespace {

/// The exponent of t = r^exponent: the median of log t / log r; 1 if no pixel tells.
float fitted_exponent(const DiagnosisInput& in) {
    constexpr float min_log = 0.2f; // nearer to 1 a power changes too little
    std::vector<float> exponents;
    for (const std::size_t i : in.fitted)
        for (std::size_t c = 0; c < in.colors; ++c)
            if (tells(in, in.t(i, c), in.r(i, c)) && std::abs(std::log(in.r(i, c))) > min_log)
                exponents.push_back(std::log(in.t(i, c)) / std::log(in.r(i, c)));
    return exponents.empty() ? 1.0f : median(std::move(exponents));
}

void add_gamma(const DiagnosisInput& in, Hypotheses& out) {
    const float exponent = fitted_exponent(in);
    const float gamma = exponent < 1.0f ? 1.0f / exponent : exponent;
    if (!(gamma > 1.03f) || gamma > 4.0f) return;
    const double left = residual(
        in, [&](std::size_t i, std::size_t c) { return std::pow(std::max(in.r(i, c), 0.0f), exponent); });
    const bool is_applied = exponent < 1.0f;
    out.push_back({{is_applied ? "gamma_applied" : "gamma_missing",
                    is_applied ? fmt::format("test = reference^(1/{:.3g}) {}: a gamma of {:.3g} applied",
                                             gamma, in.where, gamma)
                               : fmt::format("test = reference^{:.3g} {}: a gamma of {:.3g} missing", gamma,
                                             in.where, gamma),
                    left,
                    {}},
                   3,
                   true});
}

/// Clipped at the test's largest value.
void add_clipped(const DiagnosisInput& in, Hypotheses& out) {
    float level = 0.0f, brightest = 0.0f;
    for (const std::size_t i : in.pixels)
        for (std::size_t c = 0; c < in.colors; ++c) {
            level = std::max(level, in.t(i, c));
            brightest = std::max(brightest, in.r(i, c));
        }
    if (level <= in.floor || brightest < 1.01f * level) return;
    const double left =
        residual(in, [&](std::size_t i, std::size_t c) { return std::min(in.r(i, c), level); });
    const float shown = in.max_value == 1.0f ? srgb_encoded_unclamped(level) : level;
    out.push_back(
        {{"clamped", fmt::format("test = the reference clipped at {:.4g} {}", shown, in.where), left, {}},
         3});
}

/// The values of one channel of the test, if they are few.
std::vector<float> levels_of(const DiagnosisInput& in, std::size_t channel, bool of_test) {
    constexpr std::size_t max_levels = 256;
    std::vector<float> levels;
    for (const std::size_t i : in.pixels) {
        const float value = of_test ? in.t(i, channel) : in.r(i, channel);
        const auto at = std::ranges::lower_bound(levels, value);
        if (at == levels.end() || *at != value) levels.insert(at, value);
        if (levels.size() > max_levels) return {};
    }
    return levels;
}

/// Values rounded to a few levels, on the scale that they are stored in.
void add_bands(const DiagnosisInput& in, Hypotheses& out) {
    std::array<std::vector<float>, 3> levels;
    std::size_t count = 0;
    for (std::size_t c = 0; c < in.colors; ++c) {
        levels[c] = levels_of(in, c, true);
        const std::size_t before = levels_of(in, c, false).size(); // 0: very many
        if (levels[c].size() < 2 || (before > 0 && before < 3 * levels[c].size())) return;
        count = std::max(count, levels[c].size());
    }
    const auto stored = [&in](float value) {
        return in.max_value == 1.0f ? srgb_encoded_unclamped(value) : value;
    };
    const double left = residual(in, [&](std::size_t i, std::size_t c) {
        const float value = in.r(i, c);
        const auto above = std::ranges::lower_bound(levels[c], value);
        if (above == levels[c].begin()) return *above;
        if (above == levels[c].end()) return levels[c].back();
        const float below = *std::prev(above);
        return stored(value) - stored(below) < stored(*above) - stored(value) ? below : *above;
    });
    out.push_back(
        {{"banded",
          fmt::format("test = the reference rounded to {} levels {}: too few bits", count, in.where),
          left,
          {}},
         4});
}

} // namespace

void hypotheses_blank_part(const DiagnosisInput& in, Hypotheses& out) {
    const auto width = static_cast<std::size_t>(in.width);
    std::size_t left = width, right = 0, top = in.known.size() / width, bottom = 0, count = 0;
    const auto is_black = [&in](std::size_t i) {
        for (std::size_t c = 0; c < in.colors; ++c)
            if (std::abs(in.t(i, c)) > 1e-3f * in.floor) return false;
        return true;
    };
    for (const std::size_t i : in.pixels) {
        bool was_black = true;
        for (std::size_t c = 0; c < in.colors; ++c) was_black = was_black && in.r(i, c) <= in.floor;
        if (was_black || !is_black(i)) continue;
        left = std::min(left, i % width);
        right = std::max(right, i % width);
        top = std::min(top, i / width);
        bottom = std::max(bottom, i / width);
        ++count;
    }
    if (count < 16) return; // too few for a shape
    const double rest = residual(in, [&](std::size_t i, std::size_t c) {
        const bool is_inside =
            i % width >= left && i % width <= right && i / width >= top && i / width <= bottom;
        return is_inside ? 0.0f : in.r(i, c);
    });
    out.push_back({{"black_in_part",
                    fmt::format("test is black in columns {} to {}, rows {} to {}: a part was not drawn",
                                left, right, top, bottom),
                    rest,
                    {}},
                   3});
}

void hypotheses_curves(const DiagnosisInput& in, Hypotheses& out) {
    const auto add_curve = [&](const char* name, const char* statement, auto curve) {
        const double left = residual(in, [&](std::size_t i, std::size_t c) { return curve(in.r(i, c)); });
        out.push_back({{name, fmt::format("test = {} {}", statement, in.where), left, {}}, 2});
    };
    const auto clamped = [](float value) { return std::clamp(value, 0.0f, 1.0f); };
    add_curve("srgb_applied", "the sRGB code of the reference", srgb_encoded_unclamped);
    add_curve("srgb_applied", "the sRGB code of the reference, clamped to 1,",
              [&](float r) { return srgb_encoded_unclamped(clamped(r)); });
    add_curve("srgb_applied_twice", "the sRGB code of the sRGB code of the reference",
              [](float r) { return srgb_encoded_unclamped(srgb_encoded_unclamped(r)); });
    add_curve("srgb_applied_twice", "the sRGB code of the sRGB code of the reference, clamped to 1,",
              [&](float r) { return srgb_encoded_unclamped(srgb_encoded_unclamped(clamped(r))); });
    add_curve("srgb_missing", "the reference as if it were an sRGB code, decoded,", srgb_decoded);
    if (in.max_value > 1.0f) add_curve("clamped", "the reference clamped to 0..1", clamped);
    add_gamma(in, out);
    if (!in.is_whole) return; // too many curves fit a few pixels
    add_clipped(in, out);
    add_bands(in, out);
}

void hypotheses_channel_orders(const DiagnosisInput& in, Hypotheses& out) {
    if (in.colors != 3) return;
    constexpr std::array<const char*, 3> letters{"R", "G", "B"};
    std::array<std::size_t, 3> order{0, 1, 2};
    while (std::ranges::next_permutation(order).found) {
        const double left = residual(in, [&](std::size_t i, std::size_t c) { return in.r(i, order[c]); });
        out.push_back({{"channels_swapped",
                        fmt::format("test's R, G, B are the reference's {}, {}, {} {}", letters[order[0]],
                                    letters[order[1]], letters[order[2]], in.where),
                        left,
                        {}},
                       2});
    }
}

} // namespace sr::compare
