#include "cli/commands.hpp"
#include "cli/version.hpp"
#include "core/error.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <new>

int main(int argc, char** argv) {
    using namespace sr::cli;
    CLI::App app{"Steradian: a real-time renderer for direct illumination in physical units.\n"
                 "Every pixel is L_o = L_e + Σ ∫ f_r L_e V cosθ dω, in cd/m²."};
    app.set_version_flag("--version", name_and_version());
    app.require_subcommand(1);
    app.footer("Examples:\n"
               "  steradian view scene.glb                         a window to look around in\n"
               "  steradian render scene.glb -o picture.png        a picture with automatic exposure\n"
               "  steradian render scene.glb -o radiance.exr       the same, as radiance in cd/m²\n"
               "  steradian probe scene.glb --pixel 640,360        the equation at a pixel, term by term\n"
               "  steradian info                                   what OpenGL this machine offers\n"
               "  steradian render --help                          everything that render can do\n\n"
               "Exit status: 0 done, 1 a difference or a failed check, 2 usage, 3 a file, shader or driver "
               "is at fault.");
    add_view_command(app);
    add_render_command(app);
    add_probe_command(app);
    add_info_command(app);
    add_expand_command(app);
    add_compare_command(app);
    add_golden_command(app);
    add_export_command(app);
    add_brdf_command(app);
    try {
        app.parse(argc, argv);
        return done;
    } catch (const CLI::RuntimeError& ended) { // a command's own exit status
        return ended.get_exit_code();
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? done : usage;
    } catch (const sr::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "out of memory: choose a smaller --size or a smaller scene\n");
    }
    return worlds_fault;
}
