#include "compare/diagnose.hpp"

#include "compare/hypotheses/hypothesis.hpp"
#include "compare/planes.hpp"
#include "image/file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace sr::compare {
namespace {

using image::Image;

constexpr std::size_t max_pixels = 1 << 16;
constexpr std::size_t min_failing = 32; // fewer fit too many mistakes
constexpr double nearly_all = 0.9;      // of the compared pixels: then the whole image says more

/// At most `max_pixels` of the pixels, evenly spaced.
std::vector<std::size_t> sampled(const std::vector<std::size_t>& pixels) {
    if (pixels.size() <= max_pixels) return pixels;
    std::vector<std::size_t> sample;
    for (std::size_t k = 0; k < max_pixels; ++k) sample.push_back(pixels[k * pixels.size() / max_pixels]);
    return sample;
}

std::vector<float> as_light(const image::Image& image, std::size_t colors, Encoding encoding) {
    std::vector<float> light;
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < image.pixels.size(); i += channels)
        for (std::size_t c = 0; c < colors; ++c) {
            const float value = image.pixels[i + c];
            light.push_back(encoding == Encoding::display_referred ? srgb_decoded(value) : value);
        }
    return light;
}

/// True if the reference varies by half over these pixels, but for a share of them: otherwise any factor fits
/// any change.
bool varies(const DiagnosisInput& in, const std::vector<std::size_t>& pixels, double but_for) {
    std::vector<float> values;
    for (const std::size_t i : pixels)
        for (std::size_t c = 0; c < in.colors; ++c) values.push_back(in.r(i, c));
    std::ranges::sort(values);
    const auto left_out = static_cast<std::size_t>(but_for * static_cast<double>(values.size()));
    const float low = values[left_out], high = values[values.size() - 1 - left_out];
    return high > 1.5f * std::max(low, in.floor);
}

std::string region_text(const std::vector<std::size_t>& pixels, std::size_t width, std::size_t compared) {
    std::size_t left = width, right = 0;
    for (const std::size_t i : pixels) {
        left = std::min(left, i % width);
        right = std::max(right, i % width);
    }
    return fmt::format("in {:.2g} % of the pixels (columns {} to {}, rows {} to {})",
                       100.0 * static_cast<double>(pixels.size()) / static_cast<double>(compared), left,
                       right, pixels.front() / width, pixels.back() / width);
}

std::vector<std::size_t> significant(const AlignedImages& images, const PixelValues& z) {
    std::vector<std::size_t> pixels;
    for (std::size_t k = 0; k < z.size(); ++k)
        if (z[k] > 4.0f) pixels.push_back(images.compared[k]);
    return pixels;
}

/// All compared pixels; if the noise is known (z-scores), those that differ by more than four standard
/// errors.
DiagnosisInput whole_input(const AlignedImages& images, Encoding encoding, const PixelValues* z) {
    DiagnosisInput in;
    in.width = images.reference.width;
    in.height = images.reference.height;
    in.colors = static_cast<std::size_t>(images.colors);
    in.test = as_light(images.test, in.colors, encoding);
    in.reference = as_light(images.reference, in.colors, encoding);
    for (const PixelState pixel : images.pixels) in.known.push_back(pixel == PixelState::compared);
    in.fitted = sampled(images.compared);
    in.pixels = sampled(z ? significant(images, *z) : images.compared);
    in.has_noise = z != nullptr;
    in.floor = static_cast<float>(relative_floor(images));
    if (encoding == Encoding::display_referred) {
        in.max_value = 1.0f;
        in.floor = std::max(in.floor, srgb_decoded(4.0f / 255.0f)); // 8-bit codes are coarse below
    }
    in.where = "everywhere";
    return in;
}

/// The failing pixels alone, as the error map tells; absent if they are too few or too alike to tell one
/// mistake from another, or nearly all.
std::optional<DiagnosisInput> failing_input(const DiagnosisInput& whole, const AlignedImages& images,
                                            const image::Image& error) {
    std::vector<std::size_t> failing;
    for (const std::size_t i : images.compared)
        if (error.pixels[i] > 1.0f) failing.push_back(i);
    if (failing.size() < min_failing) return std::nullopt;
    if (static_cast<double>(failing.size()) > nearly_all * static_cast<double>(images.compared.size()))
        return std::nullopt;
    if (!varies(whole, failing, 0.1)) return std::nullopt;
    DiagnosisInput in = whole;
    in.is_whole = false;
    in.where = region_text(failing, static_cast<std::size_t>(whole.width), images.compared.size());
    in.pixels = in.fitted = sampled(failing);
    return in;
}

// A hypothesis explains the difference if a fifth of it is left, or a tenth with more degrees of freedom:
// numbers are fitted, or the pixels were chosen because they differ.
constexpr double max_residual = 0.2;
constexpr double max_residual_of_fits = 0.1;
constexpr double max_residual_in_noise = 0.35; // of fits to all pixels
constexpr int max_freedom_without_fits = 2;
// Pixels chosen because noise does not explain them differ by more than the mistake itself: a fit to them is
// wrong, a hypothesis with nothing to fit is not.
constexpr std::size_t min_significant = 32;
constexpr double as_good = 0.02; // residuals this near to the best explain as much

/// True if it leaves little enough of the difference. Noise leaves more, whatever is fitted.
bool explains(const Hypothesis& hypothesis, bool has_noise) {
    const bool fits = hypothesis.degrees_of_freedom > max_freedom_without_fits;
    const double limit = !fits ? max_residual : has_noise ? max_residual_in_noise : max_residual_of_fits;
    return hypothesis.diagnosis.residual <= limit;
}

/// The hypothesis with the fewest degrees of freedom of those that explain as much as the best one.
std::optional<Diagnosis> best_of(Hypotheses tried, bool has_noise = false) {
    std::erase_if(tried, [has_noise](const Hypothesis& h) { return !explains(h, has_noise); });
    if (tried.empty()) return std::nullopt;
    const auto residual_of = [](const Hypothesis& h) { return h.diagnosis.residual; };
    const double least = residual_of(std::ranges::min(tried, {}, residual_of));
    std::erase_if(tried, [&](const Hypothesis& h) { return residual_of(h) > least + as_good; });
    return std::ranges::min(
               tried, {},
               [&](const Hypothesis& h) { return std::pair(h.degrees_of_freedom, residual_of(h)); })
        .diagnosis;
}

bool fails(float error) { return !(error <= 1.0f); } // NaN too

/// Values that do not fit into a half float: one image has them, the other has its largest number or
/// infinity, and no other pixel fails.
std::optional<Diagnosis> half_overflow(const Image& error, const Image& test, const Image& reference,
                                       const std::string& layer) {
    const auto ends = [](float value) { return std::abs(value) >= image::max_half; };
    const Image t = extract(test, layer_of(test, layer)->colors),
                r = extract(reference, layer_of(reference, layer)->colors);
    const auto channels = static_cast<std::size_t>(r.channels);
    if (t.channels != r.channels) return std::nullopt;
    std::size_t overflows = 0;
    bool is_of_test = true;
    for (std::size_t i = 0; i < error.pixels.size(); ++i) {
        if (!fails(error.pixels[i])) continue;
        for (std::size_t c = i * channels; c < (i + 1) * channels; ++c) {
            const float a = t.pixels[c], b = r.pixels[c];
            if (a == b) continue;
            const bool test_ends = std::isinf(a) || std::abs(a) == image::max_half;
            const bool reference_ends = std::isinf(b) || std::abs(b) == image::max_half;
            if (!ends(a) || !ends(b) || (!test_ends && !reference_ends)) return std::nullopt;
            is_of_test = test_ends;
            ++overflows;
        }
    }
    if (overflows == 0) return std::nullopt;
    return Diagnosis{
        "half_overflow",
        fmt::format("{} values of the {} do not fit into a half float, which ends at 65504: write "
                    "32-bit floats",
                    overflows, is_of_test ? "test" : "reference"),
        0.0,
        {}};
}

/// True if two colours differ by no more than the default limits.
bool agree(float t, float r, double floor, Encoding encoding) {
    const float limit = encoding == Encoding::display_referred
                            ? 0.0079f
                            : 0.01f * std::max(std::abs(r), static_cast<float>(floor));
    return std::abs(t - r) <= limit;
}

/// Alpha is gone from the test, or the same everywhere, and the colours agree.
std::optional<Diagnosis> lost_alpha(const Failure& failure) {
    const AlignedImages& images = failure.images;
    if (lacks_alpha(failure.test, failure.reference, failure.options.layer)
        && std::ranges::none_of(failure.error.pixels, fails))
        return Diagnosis{"alpha_lost", "the test has no alpha, the colours agree", 0.0, {}};
    if (images.reference.channels == images.colors) return std::nullopt;
    constexpr float same_alpha = 0.002f; // half a code of 8 bits
    const auto alpha = static_cast<std::size_t>(images.colors);
    const float first = images.test_at(images.compared.front())[alpha];
    const double floor = relative_floor(images);
    bool varies = false;
    for (const std::size_t i : images.compared) {
        if (std::abs(images.test_at(i)[alpha] - first) > same_alpha) return std::nullopt;
        varies = varies || std::abs(images.reference_at(i)[alpha] - first) > same_alpha;
        for (std::size_t c = 0; c < alpha; ++c)
            if (!agree(images.test_at(i)[c], images.reference_at(i)[c], floor, failure.options.encoding))
                return std::nullopt;
    }
    if (!varies) return std::nullopt;
    return Diagnosis{"alpha_lost",
                     fmt::format("alpha is {:.4g} everywhere in the test, the colours agree", first),
                     0.0,
                     {}};
}

/// The share of the difference that lies in failing pixels.
double failing_share(const DiagnosisInput& in, const Image& error) {
    double all = 0.0, failing = 0.0;
    for (const std::size_t i : in.fitted)
        for (std::size_t c = 0; c < in.colors; ++c) {
            const auto distance = static_cast<double>(in.distance(in.t(i, c), in.r(i, c)));
            all += distance;
            failing += error.pixels[i] > 1.0f ? distance : 0.0;
        }
    return all > 0.0 ? failing / all : 0.0;
}

/// The mistakes of a whole image that may be the cause.
Hypotheses tried_on_all(const DiagnosisInput& in, const Failure& failure) {
    constexpr double small_part = 0.01; // a picture of one colour with a lamp is still of one colour
    Hypotheses tried;
    hypotheses_blank(in, tried);
    hypotheses_blank_part(in, tried);
    hypotheses_factors(in, tried);
    hypotheses_curves(in, tried);
    hypotheses_channel_orders(in, tried);
    hypotheses_geometric(in, tried);
    if (failure.options.layer.empty() && failure.options.encoding == Encoding::scene_referred) {
        hypotheses_lights(in, failure.reference, tried);
        hypotheses_terms(in, failure.reference, tried);
    }
    if (failure.z)
        std::erase_if(tried, [](const Hypothesis& h) {
            return h.degrees_of_freedom > max_freedom_without_fits && !h.fits_all_pixels;
        });
    if (!varies(in, in.fitted, small_part))
        std::erase_if(tried,
                      [](const Hypothesis& h) { return h.degrees_of_freedom > max_freedom_without_fits; });
    return tried;
}

/// The mistake that explains the failing pixels, where it acts within a pixel.
std::optional<Diagnosis> cause_of_failing(const DiagnosisInput& whole, const Failure& failure) {
    const auto failing = failing_input(whole, failure.images, failure.error);
    if (!failing) return std::nullopt;
    Hypotheses local;
    hypotheses_blank_part(*failing, local);
    hypotheses_factors(*failing, local);
    hypotheses_curves(*failing, local);
    hypotheses_channel_orders(*failing, local);
    std::erase_if(local, [](const Hypothesis& h) { return h.diagnosis.residual > max_residual_of_fits; });
    return best_of(local);
}

} // namespace

std::optional<Diagnosis> diagnose(const Failure& failure) {
    constexpr double most_of_it = 0.5;
    const AlignedImages& images = failure.images;
    if (auto found = half_overflow(failure.error, failure.test, failure.reference, failure.options.layer))
        return found;
    if (auto found = lost_alpha(failure)) return found;
    const DiagnosisInput whole = whole_input(images, failure.options.encoding, failure.z);
    if (whole.floor == 0.0f) return std::nullopt; // a black reference explains nothing
    if (failure.z && whole.pixels.size() < min_significant) return std::nullopt;
    const bool is_of_all =
        failure.z || failure.is_wrong_as_a_whole || failing_share(whole, failure.error) >= most_of_it;
    if (is_of_all)
        if (auto found = best_of(tried_on_all(whole, failure), failure.z != nullptr)) return found;
    if (failure.z) return std::nullopt;
    return cause_of_failing(whole, failure);
}

std::optional<Diagnosis> diagnose_unequal_sizes(const Image& test, const Image& reference,
                                                const CompareOptions& options) {
    const auto test_layer = layer_of(test, options.layer),
               reference_layer = layer_of(reference, options.layer);
    if (!test_layer || !reference_layer || test_layer->colors.size() != reference_layer->colors.size())
        return std::nullopt;
    const Image t = extract(test, test_layer->colors), r = extract(reference, reference_layer->colors);
    Hypotheses tried;
    if (t.width == r.height && t.height == r.width) hypotheses_turned(t, r, tried);
    if (t.width != r.width || t.height != r.height) hypotheses_resized(t, r, tried);
    return best_of(tried);
}

} // namespace sr::compare
