#include "brdf/laws.hpp"
#include "brdf/parameters.hpp"
#include "brdf/pictures.hpp"
#include "python/gl_thread.hpp"
#include "python/values.hpp"
#include "settings/bad_setting.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <nanobind/stl/array.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <optional>
#include <utility>

namespace sr::python {
namespace {

using Parameters = std::map<std::string, std::vector<float>>; // one number, or three

void set_parameter(scene::Material& material, const std::string& key, const std::vector<float>& given) {
    const auto& all = brdf::parameters();
    const auto found = std::ranges::find(all, key, &brdf::TestedParameter::key);
    if (found == all.end()) {
        std::vector<std::string> keys;
        for (const brdf::TestedParameter& parameter : all) keys.push_back(parameter.key);
        throw settings::BadSetting(key, fmt::format("is none of {}", fmt::join(keys, ", ")));
    }
    const bool is_number = std::holds_alternative<float scene::Material::*>(found->member);
    if (given.size() != 1 && (is_number || given.size() != 3))
        throw settings::BadSetting(key, is_number ? "is one number" : "is one number, or R, G and B");
    for (const float value : given)
        if (!std::isfinite(value) || (is_number && !(found->min <= value && value <= found->max)))
            throw settings::BadSetting(
                key, fmt::format("{} is not a number from {:g} to {:g}", value, found->min, found->max));
    brdf::set(material, found->member,
              given.size() == 3 ? vec3(given[0], given[1], given[2]) : vec3(given[0]));
}

brdf::BrdfUnderTest tested_brdf(const std::string& name, const Parameters& parameters,
                                const std::string& metal, bool compensates) {
    auto tested = brdf::brdf_named(name, gl::Backend::automatic);
    if (!tested)
        throw settings::BadSetting("name",
                                   fmt::format("'{}' is none of {}, a .glsl file, a .binary file of MERL",
                                               name, fmt::join(brdf::builtin_names(), ", ")));
    if (!metal.empty() && !brdf::set_metal(*tested, metal))
        throw settings::BadSetting("metal", fmt::format("'{}' is not known", metal));
    for (const auto& [key, value] : parameters) set_parameter(tested->material, key, value);
    tested->has_energy_compensation = compensates;
    if (tested->is_delta())
        throw settings::BadSetting("name", fmt::format("'{}' is a delta, which has no values", name));
    return *std::move(tested);
}

/// A BRDF in Python. Its shaders are compiled at the first use.
class EvaluatedBrdf {
public:
    EvaluatedBrdf(const std::string& name, const Parameters& parameters, const std::string& metal,
                  bool compensates)
        : tested_(tested_brdf(name, parameters, metal, compensates)) {}
    ~EvaluatedBrdf() {
        if (evaluator_) GlThread::only().discard([last = std::move(evaluator_)] {});
    }
    EvaluatedBrdf(const EvaluatedBrdf&) = delete;
    EvaluatedBrdf& operator=(const EvaluatedBrdf&) = delete;

    /// Calls use(evaluator) on the GL thread.
    template<class Use>
    void with(const Use& use) {
        GlThread::only().run([&](Call&) {
            gl::Context& context = GlThread::only().context(gl::Backend::automatic, false);
            if (!evaluator_) evaluator_ = std::make_shared<brdf::BrdfEvaluator>(tested_);
            use(*evaluator_);
            context.require_silence();
        });
    }

    bool has_sampling() const { return tested_.has_sampling(); }

private:
    brdf::BrdfUnderTest tested_;
    std::shared_ptr<brdf::BrdfEvaluator> evaluator_;
};

std::vector<vec3> directions_of(const Rows& rows, const char* name) {
    if (rows.shape(1) != 3) throw settings::BadSetting(name, "has three numbers a direction");
    std::vector<vec3> directions;
    directions.reserve(rows.shape(0));
    for (std::size_t i = 0; i < rows.shape(0); ++i) {
        const vec3 v(rows(i, 0), rows(i, 1), rows(i, 2));
        const float length = glm::length(v);
        if (!(std::abs(length - 1.0f) < 1e-3f))
            throw settings::BadSetting(
                name, fmt::format("direction {} has the length {:g}: it is a unit vector", i, length));
        directions.push_back(v);
    }
    return directions;
}

nb::object f_r(EvaluatedBrdf& self, const Rows& wi, const Rows& wo) {
    const std::vector<vec3> in = directions_of(wi, "wi"), out = directions_of(wo, "wo");
    if (in.size() != out.size()) throw settings::BadSetting("wo", "has as many directions as wi");
    std::vector<brdf::DirectionPair> pairs;
    for (std::size_t i = 0; i < in.size(); ++i) pairs.push_back({in[i], out[i]});
    std::vector<float> values;
    if (!pairs.empty())
        self.with([&](brdf::BrdfEvaluator& evaluator) {
            for (const vec3 f : evaluator.evaluate(pairs)) values.insert(values.end(), {f.x, f.y, f.z});
        });
    return array_of(std::move(values), in.size(), 3);
}

nb::object albedo(EvaluatedBrdf& self, const Rows& wo, int count) {
    const std::vector<vec3> out = directions_of(wo, "wo");
    std::vector<float> values;
    if (!out.empty())
        self.with([&](brdf::BrdfEvaluator& evaluator) {
            for (const glm::dvec3 a : evaluator.albedos(out, count))
                values.insert(values.end(),
                              {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)});
        });
    return array_of(std::move(values), out.size(), 3);
}

nb::object samples(EvaluatedBrdf& self, const Triple& wo, const Rows& u) {
    if (!self.has_sampling()) throw settings::BadSetting("name", "this BRDF declares no sampling");
    if (u.shape(1) != 2) throw settings::BadSetting("u", "has two numbers a row");
    std::vector<vec2> numbers;
    for (std::size_t i = 0; i < u.shape(0); ++i) numbers.emplace_back(u(i, 0), u(i, 1));
    std::vector<float> values;
    if (!numbers.empty())
        self.with([&](brdf::BrdfEvaluator& evaluator) {
            for (const brdf::WeightedDirection& d : evaluator.samples(vector_of(wo), numbers))
                values.insert(values.end(), {d.wi.x, d.wi.y, d.wi.z, d.weight});
        });
    return array_of(std::move(values), numbers.size(), 4);
}

std::string polar_plot(EvaluatedBrdf& self, const std::string& title) {
    std::string svg;
    self.with([&](brdf::BrdfEvaluator& evaluator) { svg = brdf::draw_polar_plot(evaluator, title); });
    return svg;
}

nb::list laws(EvaluatedBrdf& self) {
    std::vector<brdf::Law> checked;
    self.with([&](brdf::BrdfEvaluator& evaluator) { checked = brdf::check_laws(evaluator); });
    nb::list list;
    for (const brdf::Law& law : checked) {
        nb::dict row;
        row["law"] = law.name;
        row["holds"] = law.holds();
        row["worst"] = law.worst;
        row["limit"] = law.limit;
        row["where"] = law.where;
        row["broken_by_definition"] = law.is_waived;
        list.append(row);
    }
    return list;
}

} // namespace

void bind_brdf(nb::module_& m) {
    nb::class_<EvaluatedBrdf>(m, "EvaluatedBrdf")
        .def(nb::init<const std::string&, const Parameters&, const std::string&, bool>())
        .def("f_r", &f_r)
        .def("albedo", &albedo)
        .def("samples", &samples)
        .def("polar_plot", &polar_plot)
        .def("laws", &laws);
    m.def("brdf_parameters", [] {
        nb::list list;
        for (const brdf::TestedParameter& parameter : brdf::parameters())
            list.append(nb::make_tuple(parameter.key, parameter.help));
        return list;
    });
}

} // namespace sr::python
