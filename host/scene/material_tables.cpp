// SPDX-License-Identifier: Apache-2.0
// Materials whose reflectance is a file's.
#include <cmath>
#include <cstring>
#include <filesystem>

#include "base/error.h"
#include "scene/materials.h"
#include "scene/measured_files.h"

namespace lobe {
namespace {

// A number whose bits are an index: the value of a row of kind `table`.
double as_row_value(std::uint32_t index) {
    float value;
    std::memcpy(&value, &index, sizeof value);
    return value;
}

void warn_of_gaps(const MeasuredBrdf& table, const Place& place, const ReadContext& context) {
    std::size_t reached = 0, missing = 0;
    for (std::size_t cell = 0; cell < table.cells(); ++cell) {
        const DirectionPair pair = directions_at(table, cell);
        if (!(pair.wo.z > 0 && pair.wi.z > 0)) continue;
        ++reached;
        missing += std::isnan(table.values[cell].x);
    }
    if (missing)
        context.warn(place,
                     std::to_string(missing) + " of " + std::to_string(reached) +
                         " cells above the horizon have no data: their neighbours' is taken");
}

}  // namespace

glm::dvec3 read_table(const Parameter& given, const ReadContext& context) {
    if (given.type != ParameterType::string || given.strings.size() != 1)
        fail(given.place,
             "parameter \"" + given.name + "\" wants one string, has " + given.spelling,
             "the file of a table");
    const std::string path = resolve_path(context, given.strings[0], given.values_place);
    std::error_code fault;
    const std::string file = std::filesystem::weakly_canonical(path, fault).string();
    auto& places = context.scene.table_places;
    const auto known = places.find(file);
    if (known != places.end()) return {as_row_value(known->second), 0, 0};
    MeasuredBrdf table = read_measured(path);
    warn_of_gaps(table, given.values_place, context);
    fill_gaps(table, path);
    const double albedo = largest_albedo(table);
    if (albedo > 1.01)
        context.warn(given.values_place, "the table reflects up to " +
                                             show(std::round(1000 * albedo) / 1000) +
                                             " times the light: a reflectance above one makes "
                                             "energy");
    auto& tables = context.scene.tables;
    const std::vector<float> numbers = lay_out(table);
    if (tables.size() + numbers.size() >= 0xffffffffu)
        fail(given.values_place, "the scene's tables hold more than 2^32 numbers");
    const auto index = static_cast<std::uint32_t>(tables.size());
    tables.insert(tables.end(), numbers.begin(), numbers.end());
    places[file] = index;
    return {as_row_value(index), 0, 0};
}

}  // namespace lobe
