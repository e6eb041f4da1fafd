// SPDX-License-Identifier: Apache-2.0
// Parameters that are colours: rgb, xyz, black bodies, sampled and named spectra, textures.
#include <cmath>

#include "scene/colour.h"
#include "scene/metals.h"
#include "scene/parameters.h"

namespace lobe {

namespace {

glm::dvec3 three(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

// A light's spectrum has luminance one in version 4, whatever its shape.
glm::dvec3 as_light(const ReadContext& context, const glm::dvec3& xyz, ColourUse use) {
    return rgb_from_xyz(use == ColourUse::light && context.v4() && xyz.y > 0 ? xyz / xyz.y : xyz);
}

glm::dvec3 sampled(const ReadContext& context, const Parameter& parameter, ColourUse use) {
    const std::vector<double>& pairs = parameter.numbers;
    for (std::size_t i = 2; i < pairs.size(); i += 2)
        if (!(pairs[i] > pairs[i - 2]))
            fail(place_of_value(parameter, i),
                 "wavelengths of a spectrum must increase (" + show(pairs[i]) + " nm)");
    return as_light(context, xyz_from_samples(pairs), use);
}

// [T scale] in version 3, with the brightest wavelength at `scale`; [T] in version 4.
glm::dvec3 blackbody(const ReadContext& context, const Parameter& parameter, ColourUse use) {
    const std::vector<double>& v = parameter.numbers;
    const std::size_t wanted = context.v4() ? 1 : 2;
    if (v.size() != wanted)
        fail(parameter.place,
             "a blackbody wants " + std::to_string(wanted) + " number" + (wanted == 1 ? "" : "s") +
                 ", has " + std::to_string(v.size()),
             context.v4() ? "[ kelvin ] in version 4" : "[ kelvin scale ] in version 3");
    if (!(v[0] > 0)) fail(parameter.values_place, "a blackbody of " + show(v[0]) + " K");
    const glm::dvec3 rgb = as_light(context, xyz_from_blackbody(v[0]), use);
    // out of the gamut at low temperatures
    return glm::max(rgb, glm::dvec3(0)) * (wanted == 2 ? v[1] : 1.0);
}

glm::dvec3 named_spectrum(const Parameter& parameter) {
    std::vector<std::string> names;
    if (parameter.strings.size() != 1) fail(parameter.place, "one spectrum name was expected");
    const std::string& name = parameter.strings[0];
    for (const Metal& metal : metals) {
        const std::string stem = "metal-" + std::string(metal.name);
        const std::string file = std::string(metal.name) + ".";  // pbrt-v3's "spds/Cu.eta.spd"
        const std::string last = name.substr(name.find_last_of('/') + 1);
        if (name == stem + "-eta" || last == file + "eta.spd") return metal.eta;
        if (name == stem + "-k" || last == file + "k.spd") return metal.k;
        names.push_back(stem + "-eta");
        names.push_back(stem + "-k");
    }
    const bool is_file = name.find('.') != std::string::npos;
    if (is_file)
        fail(parameter.values_place,
             "spectrum files (\"" + name + "\") are understood but not supported yet",
             "give rgb values, or a named metal such as \"metal-Cu-eta\"");
    fail(parameter.values_place, "unknown spectrum \"" + name + "\"", suggestion(name, names));
}

}  // namespace

glm::dvec3 Parameters::colour_of(const Parameter& parameter, ColourUse use) {
    switch (parameter.type) {
        case ParameterType::number:
        case ParameterType::integer:
            return glm::dvec3(number_of(parameter));
        case ParameterType::texture:
            return texture(parameter).value;
        case ParameterType::blackbody:
            return blackbody(context_, parameter, use);
        case ParameterType::spectrum:
            return parameter.numbers.empty() ? named_spectrum(parameter)
                                             : sampled(context_, parameter, use);
        case ParameterType::rgb:
        case ParameterType::xyz:
            break;
        default:
            wrong_type(parameter, "a colour");
    }
    if (parameter.numbers.size() != 3) wrong_type(parameter, "one colour");
    const glm::dvec3 value = three(parameter.numbers);
    return parameter.type == ParameterType::xyz ? rgb_from_xyz(value) : value;
}

}  // namespace lobe
