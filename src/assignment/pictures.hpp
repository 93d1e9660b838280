#pragma once
// Pictures of an assignment's scenes, with some regions of the reference replaced.
#include "assignment/evaluation.hpp"
#include "assignment/finding.hpp"
#include "render/renderer.hpp"
#include "scene/prepare.hpp"

#include <memory>

namespace sr::assignment {

class Pictures {
public:
    /// Needs a current context for as long as it lives.
    Pictures(const Assignment& assignment, const Parameters& parameters)
        : assignment_(assignment), parameters_(parameters) {}

    /// The scene of an image check, in cd/m². Scenes stay uploaded. @throws ShaderError, Error
    image::Image rendered(const Check& check, const Codes& codes);

    /// Compares with the reference's picture, which is rendered once. @throws ShaderError, Error
    Finding check(const Check& check, const Codes& codes);

    /// The mistake of the task's that makes the same picture; else what `steradian compare` says; absent if
    /// neither explains it.
    std::optional<Named> diagnosed(const Task& task, const Check& check, const Finding& finding);

private:
    struct Shown {
        scene::RenderScene stage;
        std::unique_ptr<render::GpuScene> gpu;
    };
    const Shown& shown(const Check& check);
    const image::Image& reference(const Check& check);
    const image::Image& mistaken(const Task& task, const Check& check, const Variant& variant);

    const Assignment& assignment_;
    const Parameters& parameters_;
    std::map<std::string, Shown> shown_;
    std::map<const Check*, image::Image> references_;
    std::map<std::pair<const Check*, const Variant*>, image::Image> mistakes_;
};

} // namespace sr::assignment
