#pragma once
// The files of plugin/, which every exported folder gets as they are.
#include <string>
#include <vector>

namespace sr::mitsuba {

struct PluginFile {
    std::string name; // may begin with a folder: "steradian_mitsuba/phong.py"
    std::string text;
};

/// README.md, render.py and the package steradian_mitsuba as they were when the program was built.
std::vector<PluginFile> plugin_files();

} // namespace sr::mitsuba
