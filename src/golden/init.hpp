#pragma once
// The first suite of a project.
#include <filesystem>
#include <string>
#include <vector>

namespace sr::golden {

struct InitOptions {
    std::vector<std::filesystem::path> sources; // scenes or pictures, or folders of them
    std::filesystem::path output = "golden";    // folder of the suite; made if it is not there
};

struct InitResult {
    std::filesystem::path suite;
    int tests = 0;
    bool is_of_pictures = false;
};

/// Writes OUTPUT/suite.json, .gitattributes (goldens by Git LFS), github-actions.yml and gitlab-ci.yml: all
/// or none. Each scene (.gltf, .glb) becomes a test that renders it. Where there is no scene, each picture
/// becomes a test that takes the picture as the project's own program writes it.
/// Each file becomes one test, also if it is found twice; goldens and the output folders of runs are left
/// out. The files for CI systems name the suite as seen from the Git repository, or as given where there is
/// none.
/// @throws Error if there is neither a scene nor a picture, there are more than 1000, a shell would need
/// quotes for the suite's path, one of the files is there already, or one cannot be written.
InitResult write_first_suite(const InitOptions& options);

} // namespace sr::golden
