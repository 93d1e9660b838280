#pragma once
// Question to the person, which stays until one of its answers is chosen.
#include <functional>
#include <string>
#include <vector>

namespace sr::viewer {

struct Answer {
    int key = 0; // a letter, as GLFW numbers keys; 0 for Esc
    std::string text;
    std::function<void()> act{}; // nothing happens without it
};

/// Enter gives the first answer, Esc the last one.
struct Question {
    std::string text;
    std::vector<Answer> answers;
    bool is_shown = false; // a key that was typed before answers nothing

    /// The answer that a key gives; null if it gives none.
    const Answer* answer_of(int key) const;
};

/// Draws the question over all else. @return the answer whose button was clicked; null if none was
const Answer* draw_question(const Question& question);

} // namespace sr::viewer
