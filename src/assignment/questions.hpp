#pragma once
// Questions about a submission. Each answer comes from making the change that the question asks about.
#include "assignment/code_changes.hpp"
#include "assignment/mark.hpp"
#include "assignment/scene_changes.hpp"

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>

namespace sr::assignment {

class Examiner {
public:
    /// Needs a current context during its lifetime. `tasks`: those whose code has marks.
    Examiner(const Assignment& assignment, const Submission& submission, const std::string& student,
             const std::vector<std::string>& tasks, const std::string& seed);

    // Each question: {"kind", "task", "title", "ask", "answer": [lines], "facts", "pictures": [{"caption",
    // "png"}]}. @throws Error with the reason why there is none
    nlohmann::ordered_json pixel_question();
    nlohmann::ordered_json parameter_question();
    nlohmann::ordered_json law_question();
    nlohmann::ordered_json replacement_question();

private:
    struct Place {
        int x = 0, y = 0;
        std::optional<std::size_t> dark; // a light that adds nothing there
    };
    struct TaskChange {
        const Task* task = nullptr;
        CodeChange change;
    };

    Submission alone(const Task& task, const CodeChange* change = nullptr) const;
    Codes with(const TaskChange& change) const;
    std::vector<TaskChange> shuffled_changes(const Task* only = nullptr);
    std::optional<image::Image> rendered(const Codes& codes);
    std::optional<vec3> value_at(const Place& place, const Codes& codes, int first, int end);
    Place interesting_place();
    nlohmann::ordered_json deciding_lines(const Place& place, vec3 L_o, vec3 before,
                                          nlohmann::ordered_json& answer);
    std::optional<nlohmann::ordered_json> effect_of(const SceneChange& change);
    std::optional<nlohmann::ordered_json> law_of(const Task& task, const Check& check);
    render::RenderOptions options_of(const Codes& codes) const;
    const scene::RenderScene& stage();

    const Assignment& assignment_;
    std::string student_;
    Parameters parameters_;
    ReferenceValues known_;
    Pictures pictures_;
    Marker marker_;
    Codes codes_; // of all tasks that have marks
    std::vector<const Task*> tasks_;
    Check view_; // what is rendered
    std::mt19937 random_;
    std::optional<image::Image> film_; // by codes_
};

} // namespace sr::assignment
