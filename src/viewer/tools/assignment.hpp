#pragma once
// Assignment tool: marks of a student's folder, which child processes check, and the reference render.
#include "viewer/document/watch.hpp"
#include "viewer/tools/tool.hpp"

#include <atomic>
#include <filesystem>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace sr::viewer {

/// Marks of a task.
struct TaskMark {
    std::string id;
    std::string title;
    std::string status; // assets/assignment_result.schema.json; empty before the check
    double points = 0.0;
    double of = 0.0;
    bool is_extra = false;
    bool is_endless = false;           // its check did not end by itself
    std::vector<std::string> problems; // in the code, each with its line and a hint
    std::vector<std::string> findings; // of failed checks
};

/// Checker of a student's folder, on a thread.
class Checker {
public:
    /// `program`: steradian, which checks in child processes.
    Checker(std::filesystem::path submission, std::filesystem::path program);
    ~Checker();
    Checker(const Checker&) = delete;
    Checker& operator=(const Checker&) = delete;

    /// Begins to check the files. A check that still runs is stopped.
    void begin();
    bool is_checking() const { return ending_.valid(); }

    /// Takes new marks. @return true if there are any, or the check has ended
    bool take();
    /// Tells, once, that a check has ended.
    bool take_end();

    /// Problems in the code, one below the other; empty if it compiles.
    std::string problems() const;
    /// The task whose check did not end by itself; empty if there is none.
    std::string endless_task() const;
    /// The reason why nothing was checked; empty if there was none.
    const std::string& failure() const { return failure_; }

    void draw() const;

private:
    /// State that the thread writes.
    struct Run {
        std::atomic<bool> is_stopped{false};
        std::mutex mutex;
        std::vector<TaskMark> found;
    };
    void draw_task(const TaskMark& task) const;

    std::filesystem::path submission_;
    std::filesystem::path program_;
    std::shared_ptr<Run> run_;
    std::future<std::string> ending_; // the failure; empty if there was none
    std::vector<TaskMark> tasks_;     // of the last check, which a new check replaces one by one
    std::size_t taken_ = 0;           // of run_->found
    std::string failure_;
    bool has_ended_ = false;
};

class Assignment : public Tool {
public:
    explicit Assignment(Workspace& workspace);

    Changes update(double seconds) override;
    Changes draw(const Overlay& overlay) override;
    FilmSum reference_film() const override;
    Activity activity() const override;

private:
    Changes end_check();
    bool needs_reference() const;
    void draw_comparison();

    Checker checker_;
    Watch shader_watch_;
};

} // namespace sr::viewer
