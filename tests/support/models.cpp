#include "support/models.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>

namespace sr::testing {

namespace fs = std::filesystem;

fs::path source_folder() { return STERADIAN_SOURCE_DIR; }

fs::path assets_folder() { return source_folder() / "assets"; }

std::optional<fs::path> models_folder() {
    const char* variable = std::getenv("STERADIAN_MODELS");
    const fs::path folder =
        variable ? fs::path(variable) : source_folder().parent_path() / "shared" / "models";
    if (!fs::is_directory(folder)) return std::nullopt;
    return folder;
}

std::optional<fs::path> packaged_models_folder() {
    const fs::path folder = STERADIAN_PACKAGED_MODELS;
    if (!fs::is_directory(folder)) return std::nullopt;
    return folder;
}

std::vector<fs::path> models_below(const fs::path& folder) {
    std::vector<fs::path> models;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".glb" || entry.path().extension() == ".gltf")
            models.push_back(entry.path());
    std::ranges::sort(models);
    return models;
}

fs::path scratch_folder(const std::string& name) {
    const ::testing::TestInfo* test = ::testing::UnitTest::GetInstance()->current_test_info();
    require(test != nullptr, "a test is running");
    const fs::path folder = fs::path(STERADIAN_BINARY_DIR) / "scratch"
                            / (std::string(test->test_suite_name()) + "." + test->name()) / name;
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

} // namespace sr::testing
