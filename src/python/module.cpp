// The module steradian._native: what the Python files beside it are made of.
#include "assignment/check.hpp"
#include "assignment/mark.hpp"
#include "assignment/submission.hpp"
#include "core/limits.hpp"
#include "core/output.hpp"
#include "core/program.hpp"
#include "python/gl_thread.hpp"
#include "python/values.hpp"
#include "settings/bad_setting.hpp"

#include <exception>
#include <fmt/format.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace sr::python {
namespace {

/// Checks a student's folder or archive in child processes, as `steradian assignment check` does.
/// @return the result as JSON, and the report as a page
nb::tuple check_assignment(const std::string& submission, double time_limit, const std::string& graded_as,
                           const std::string& hidden, const std::string& student) {
    assignment::CheckOptions options;
    options.program = program_file();
    options.time_limit = time_limit;
    options.keeps_pictures = true;
    if (!graded_as.empty()) {
        options.grading.emplace();
        options.grading->assignment = std::filesystem::absolute(assignment::assignment_named(graded_as));
        if (!hidden.empty()) options.grading->hidden = std::filesystem::absolute(hidden);
        options.grading->student = student;
    }
    std::string json, page;
    Call call([&](Call& self) {
        options.stop = self.stop();
        const auto result = assignment::check_submission(submission, options);
        if (!result) return;
        json = assignment::without_pictures(*result).dump(-1, ' ', false,
                                                          nlohmann::ordered_json::error_handler_t::replace);
        page = assignment::report_html(*result);
    });
    {
        const std::jthread checking([&] { call.work(); });
        call.wait(nb::none());
    }
    return nb::make_tuple(json, page);
}

/// Turns our errors into exceptions of Python.
void translate(const std::exception_ptr& thrown, void* error_type) {
    try {
        std::rethrow_exception(thrown);
    } catch (const settings::BadSetting& error) {
        PyErr_SetString(PyExc_ValueError, fmt::format("{}: {}", error.key(), error.what()).c_str());
    } catch (const Error& error) {
        PyErr_SetString(static_cast<PyObject*>(error_type), error.what());
    }
}

} // namespace

void bind_assignment(nb::module_& m) { m.def("check_assignment", &check_assignment); }

} // namespace sr::python

NB_MODULE(_native, m) {
    using namespace sr::python;
    m.doc() = "The parts of Steradian that Python calls.";
    m.attr("__version__") = STERADIAN_VERSION;
    m.def("start", [](nb::handle error_type, nb::object remark_handler, const std::string& program) {
        nb::register_exception_translator(translate, error_type.inc_ref().ptr());
        set_remark_handler(std::move(remark_handler));
        sr::set_program_file(program);
        sr::set_limits_from_environment();
    });
    m.def("end", [] {
        GlThread::only().end();
        set_remark_handler(nb::object());
    });
    bind_lights(m);
    bind_images(m);
    bind_scene(m);
    bind_brdf(m);
    bind_assignment(m);
}
