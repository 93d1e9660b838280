#pragma once
// Image checks: pictures of an assignment's scenes, with some regions of the reference replaced.
#include "assignment/value_check.hpp"
#include "render/renderer.hpp"
#include "scene/prepare.hpp"

#include <memory>

namespace sr::assignment {

class Pictures {
public:
    /// A scene that is uploaded.
    struct Shown {
        scene::RenderScene stage;
        std::unique_ptr<render::GpuScene> gpu;
    };

    /// Needs a current context during its lifetime.
    Pictures(const Assignment& assignment, const Parameters& parameters, ReferenceValues& known)
        : assignment_(assignment), parameters_(parameters), known_(known) {}

    /// Renders the scene of an image check [cd/m²]. Scenes stay uploaded. @throws ShaderError, Error
    image::Image render(const Check& check, const Codes& codes);

    /// Compares with the reference's picture, which is rendered once. @throws ShaderError, Error
    Finding check(const Check& check, const Codes& codes);

    /// Finds the mistake of the task that makes the same picture, or else the diagnosis of `steradian
    /// compare`.
    /// @return absent if neither explains it
    std::optional<Named> diagnose(const Task& task, const Check& check, const Finding& finding);

    /// Renders the reference, and with `mistakes` the typical mistakes of a task.
    void compute_references(const Task& task, const Check& check, bool mistakes);

    /// The scene of an image check.
    const Shown& shown(const Check& check);

private:
    const image::Image& reference(const Check& check);
    image::Image known_picture(const Check& check, const Codes& codes);
    /// Null if one of its loops was stopped.
    const image::Image* mistaken(const Task& task, const Check& check, const Variant& variant);

    const Assignment& assignment_;
    const Parameters& parameters_;
    ReferenceValues& known_;
    std::map<std::string, Shown> shown_;
    std::map<const Check*, image::Image> references_;
    std::map<std::pair<const Check*, const Variant*>, std::optional<image::Image>> mistakes_;
};

} // namespace sr::assignment
