#include "settings/provenance.hpp"

#include "settings/options.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::settings {

SampleCounts count_samples(const std::vector<int>& samples) {
    if (samples.empty()) return {};
    const auto [min, max] = std::ranges::minmax(samples);
    double sum = 0.0;
    for (const int count : samples) sum += count;
    return {sum / static_cast<double>(samples.size()), min, max};
}

std::vector<image::Attribute> attributes_of(const RenderSettings& settings, const RenderResult& outcome,
                                            const gl::ContextInfo& gl) {
    const auto& [unit, camera, samples, error, stopped_by, light_choices] = outcome;
    std::vector<image::Attribute> attributes{{"steradian:version", STERADIAN_VERSION},
                                             {"steradian:unit", unit},
                                             {"steradian:samples", std::to_string(samples.max)},
                                             {"steradian:camera", camera},
                                             {"steradian:GL_RENDERER", gl.renderer},
                                             {"steradian:GL_VERSION", gl.version}};
    if (samples.min < samples.max) {
        attributes.push_back({"steradian:samples_mean", fmt::format("{:.1f}", samples.mean)});
        attributes.push_back({"steradian:samples_min", std::to_string(samples.min)});
    }
    if (light_choices > 0) attributes.push_back({"steradian:light_choices", std::to_string(light_choices)});
    if (error) attributes.push_back({"steradian:error", fmt::format("{:.4g}", *error)});
    if (stopped_by) attributes.push_back({"steradian:stopped_by", render::name_of(*stopped_by)});
    if (stopped_by == render::StoppedBy::interruption) attributes.push_back({"steradian:interrupted", "yes"});
    for (const Option& option : all_options()) {
        if (!option.attribute.name) continue;
        const auto text = option.attribute.text ? option.attribute.text : option.value.write;
        if (std::string value = text(settings); !value.empty())
            attributes.push_back({fmt::format("steradian:{}", option.attribute.name), std::move(value)});
    }
    return attributes;
}

} // namespace sr::settings
