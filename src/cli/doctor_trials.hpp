#pragma once
// Trials of `steradian doctor`, each in a process of its own: a driver that crashes costs one line.
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace sr::cli {

/// Runs the trial `name` in this process and writes its result to `file`, as a JSON object.
///   egl, osmesa, window  opens the backend and renders a Lambert plane under a point light
///   exr, hdr             writes a picture and reads it back, by OpenEXR or OpenImageIO
///   confinement          lists the protections that this system lacks
/// The result has "works", and "failure" where that is false. @throws Error for another name
void run_doctor_trial(const std::string& name, const std::filesystem::path& file);

/// Runs the trial in a child process, whose files lie in `folder`. A child that crashes or takes more than a
/// minute is a result with a "failure".
nlohmann::ordered_json result_of_trial(const std::string& name, const std::filesystem::path& folder);

} // namespace sr::cli
