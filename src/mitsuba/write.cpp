#include "mitsuba/write.hpp"

#include "core/error.hpp"
#include "mitsuba/emitters.hpp"
#include "mitsuba/new_folder.hpp"
#include "mitsuba/plugin_files.hpp"
#include "mitsuba/sensor.hpp"

namespace sr::mitsuba {
namespace {

void write_integrator(Xml& xml, const scene::Scene& scene) {
    xml.open("integrator", "direct"); // one point of an emitter and one of the BRDF a sample
    if (hides_emitters(scene)) xml.flag("hide_emitters", true);
    xml.close();
}

std::vector<std::string> collected(const Output& output) {
    std::vector<std::string> all = output.warnings;
    for (const auto* list : {&output.materials.warnings(), &output.textures.warnings()})
        all.insert(all.end(), list->begin(), list->end());
    return all;
}

} // namespace

std::vector<std::string> write(const Subject& subject, const std::filesystem::path& folder) {
    require(subject.width > 0 && subject.height > 0, "the picture has pixels");
    NewFolder place(folder);
    Output output{subject.scene, place.path()};
    output.xml.open("scene");
    write_integrator(output.xml, subject.scene);
    write_sensor(output.xml, subject.camera, subject.width, subject.height);
    write_instances(output);
    write_emitters(output);
    output.xml.close();
    write_text(place.path() / "scene.xml", output.xml.result());
    for (const PluginFile& file : plugin_files()) {
        make_folder((place.path() / file.name).parent_path());
        write_text(place.path() / file.name, file.text);
    }
    place.put_in_place();
    return collected(output);
}

} // namespace sr::mitsuba
