// SPDX-License-Identifier: Apache-2.0
// Rays a second, by class, against Embree on the same rays and cores.
// bench_rays [--rounds N] [--json FILE] [TRIANGLES...]
//
// Where its memory happens to lie makes Embree up to a third slower or faster for as long as its
// scene lives: each round builds all scenes anew, and ratios are to Embree's best round.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/statistics.h"
#include "rays/tracers.h"
#include "study/bench/growth_scenes.h"

using namespace lobe;
using namespace lobe::bench;

namespace {

constexpr unsigned side = 1024, passes = 9;

struct Options {
    unsigned rounds = 3;
    std::string json;
    std::vector<unsigned> triangles;
};

// Of one tracer and one class: the median rate of each round, Mrays/s.
struct Rates {
    std::vector<double> rounds;
    std::size_t met = 0;
    double best() const { return *std::max_element(rounds.begin(), rounds.end()); }
    double middle() const { return median(rounds); }
};

using Table = std::map<std::string, std::map<std::string, Rates>>;  // by class, by tracer

void measure_round(const Mesh& mesh, Table& table) {
    const test::EmbreeScene fast(mesh, test::EmbreeMode::fast);
    const test::EmbreeScene robust(mesh, test::EmbreeMode::robust);
    const LobeScene scene(mesh);
    std::vector<std::unique_ptr<Tracer>> tracers;
    tracers.push_back(lobe_tracer("lobe", scene, LobeCall::single));
    tracers.push_back(lobe_tracer("together", scene, LobeCall::packets));
    tracers.push_back(
        lobe_tracer("portable", scene, LobeCall::single, "#define LOBE_PORTABLE_LANES\n"));
    tracers.push_back(embree_tracer("embree", fast, EmbreeCall::single));
    tracers.push_back(embree_tracer("robust", robust, EmbreeCall::single));
    tracers.push_back(embree_tracer("packets", fast, EmbreeCall::packets));
    for (const RayClass& rays : ray_classes(mesh, robust, side)) {
        std::vector<std::vector<double>> rates(tracers.size());
        for (unsigned pass = 0; pass <= passes; ++pass)
            for (std::size_t i = 0; i < tracers.size(); ++i) {
                const Pass result = tracers[i]->trace(rays);
                table[rays.name][tracers[i]->name()].met = result.met;
                if (pass > 0)  // the first warms up
                    rates[i].push_back(1e-6 * double(rays.rays.size()) / result.seconds);
            }
        for (std::size_t i = 0; i < tracers.size(); ++i)
            table[rays.name][tracers[i]->name()].rounds.push_back(median(rates[i]));
    }
}

void print(unsigned triangles, const Table& table) {
    std::printf("%u triangles, Mrays/s\n%-12s %8s %8s %8s %8s %8s %8s %9s %9s %9s %9s\n", triangles,
                "", "lobe", "together", "portable", "embree", "robust", "packets", "/ embree",
                "/ robust", "port./emb", "tog./pack");
    for (const auto& [name, row] : table) {
        const double lobe = row.at("lobe").middle(), embree = row.at("embree").best();
        const double together = row.at("together").middle(), packets = row.at("packets").best();
        const double portable = row.at("portable").middle(), robust = row.at("robust").best();
        std::printf("%-12s %8.2f %8.2f %8.2f %8.2f %8.2f %8.2f %9.3f %9.3f %9.3f %9.3f\n",
                    name.c_str(), lobe, together, portable, embree, robust, packets, lobe / embree,
                    lobe / robust, portable / embree, together / packets);
    }
    std::fflush(stdout);
}

nlohmann::json to_json(const Table& table) {
    nlohmann::json json;
    for (const auto& [name, row] : table)
        for (const auto& [tracer, rates] : row)
            json[name][tracer] = {{"mrays_per_s", rates.rounds}, {"met", rates.met}};
    return json;
}

Options parse(int count, char** words) {
    Options o;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        if (word == "--rounds" && i + 1 < count)
            o.rounds = unsigned(std::atoi(words[++i]));
        else if (word == "--json" && i + 1 < count)
            o.json = words[++i];
        else if (std::atoi(words[i]) > 0)
            o.triangles.push_back(unsigned(std::atoi(words[i])));
        else
            throw Error(ExitCode::usage, "'" + word + "' is not understood", "",
                        "bench_rays [--rounds N] [--json FILE] [TRIANGLES...]");
    }
    if (o.triangles.empty()) o.triangles = {66000, 1000000, 10000000};
    return o;
}

}  // namespace

int main(int count, char** words) {
    try {
        const Options o = parse(count, words);
        nlohmann::json json;
        for (const unsigned triangles : o.triangles) {
            const Mesh mesh = torus_in_a_room(triangles);
            Table table;
            for (unsigned round = 0; round < o.rounds; ++round) measure_round(mesh, table);
            print(unsigned(mesh.triangles.size()), table);
            json[std::to_string(triangles)] = to_json(table);
        }
        if (!o.json.empty()) std::ofstream(o.json) << json.dump(2) << "\n";
        test::TestDevice().TearDown();
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.message().c_str());
        return static_cast<int>(error.code());
    }
}
