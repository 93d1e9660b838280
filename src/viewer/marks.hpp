#pragma once
// The marks of a student's folder, found beside the window, and their panel.
#include <atomic>
#include <filesystem>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace sr::viewer {

/// A task as the panel shows it.
struct TaskMark {
    std::string id;
    std::string title;
    std::string status; // assets/assignment_result.schema.json; empty: not checked yet
    double points = 0.0;
    double of = 0.0;
    bool is_extra = false;
    bool is_endless = false;           // its check was ended
    std::vector<std::string> problems; // of the code: a text each, with the line and a hint
    std::vector<std::string> findings; // of its checks that failed
};

class Marks {
public:
    /// `program`: steradian, which checks in child processes.
    Marks(std::filesystem::path submission, std::filesystem::path program);
    ~Marks();
    Marks(const Marks&) = delete;
    Marks& operator=(const Marks&) = delete;

    /// Checks the files as they are now. A check that still runs is ended.
    void begin();
    bool is_checking() const { return ending_.valid(); }

    /// Takes what has been found since. Whether there is something new to draw.
    bool take();
    /// Whether a check has come to its end since the last time that it said so.
    bool take_end();

    /// What is wrong with the code, one problem below the other; empty: it compiles.
    std::string problems() const;
    /// The task whose check had to be ended; empty: all came to their end.
    std::string endless() const;
    /// Why nothing could be checked; empty: it could.
    const std::string& failure() const { return failure_; }

    void draw() const;

private:
    /// What a check writes and the window reads.
    struct Run {
        std::atomic<bool> is_stopped{false};
        std::mutex mutex;
        std::vector<TaskMark> found;
    };
    void draw_task(const TaskMark& task) const;

    std::filesystem::path submission_;
    std::filesystem::path program_;
    std::shared_ptr<Run> run_;
    std::future<std::string> ending_; // the failure, or nothing
    std::vector<TaskMark> tasks_;     // of the last check, replaced one by one
    std::size_t taken_ = 0;           // of run_->found
    std::string failure_;
    bool has_ended_ = false;
};

/// A text in the characters that the panels' font has: "π" as "pi".
std::string in_plain_letters(std::string text);

} // namespace sr::viewer
