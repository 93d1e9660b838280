#pragma once
// The files of plugin/, which every exported folder gets as they are.
#include <string>
#include <vector>

namespace sr::mitsuba {

struct PluginFile {
    std::string name;
    std::string text;
};

/// README.md, render.py and steradian_mitsuba.py as they were when the program was built.
std::vector<PluginFile> plugin_files();

} // namespace sr::mitsuba
