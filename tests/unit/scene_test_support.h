// SPDX-License-Identifier: Apache-2.0
// Scenes as text, and what reading them gives or complains of.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "base/error.h"
#include "scene/read.h"
#include "support/temp_folder.h"

namespace lobe::test {

// The models that pbrt's materials need, and one of our own with every kind of parameter.
inline const std::vector<BrdfTable>& models() {
    static const std::vector<BrdfTable> tables = [] {
        const auto table = [](const std::string& name, const std::string& rows) {
            return parse_brdf_table("brdf/" + name + ".h",
                                    "#define " + name + "_parameters(P) \\\n" + rows + "\n");
        };
        return std::vector<BrdfTable>{
            table("conductor",
                  "P(color, eta, 0.2, 0, 10000, \"\") P(color, k, 3.9, 0, 10000, \"\") "
                  "P(number, alpha_x, 0.1, 0, 10, \"\") "
                  "P(number, alpha_y, 0.1, 0, 10, \"\")"),
            table("lambert", "P(color, kd, 0.25, 0, inf, \"\")"),
            table("mirror", "P(color, kr, 0.9, 0, inf, \"\")"),
            table("modified_phong",
                  "P(color, kd, 0.25, 0, inf, \"\") P(color, ks, 0.25, 0, inf, \"\") "
                  "P(number, n, 100, 0, inf, \"\") "
                  "P(choice, normalize, 0, 0, 1, \"false|true: albedos\")"),
            table("oren_nayar",
                  "P(color, kd, 0.25, 0, inf, \"\") P(number, sigma, 20, 0, 90, \"\")"),
            table("plastic",
                  "P(color, kd, 0.25, 0, inf, \"\") P(color, ks, 0.25, 0, inf, \"\") "
                  "P(number, alpha, 0.1, 0, 10, \"\") P(number, eta, 1.5, 0.1, 10, \"\")"),
            table("test_model",
                  "P(color, kd, 0.25, 0, inf, \"\") P(number, n, 100, 0, 1000, \"\") "
                  "P(integer, order, 2, 1, 8, \"\") "
                  "P(choice, lobe, 0, 0, 2, \"clamp|abs|listing: reading\")"),
        };
    }();
    return tables;
}

inline Scene read_text(const std::string& text, const ReadOptions& options = {}) {
    const TempFolder folder;
    return read_scene(folder.write("s.pbrt", text), models(), options);
}

// A scene of version 4 or 3 with these lines in its world; its first line is line 2.
inline std::string world4(const std::string& lines) {
    return "Film \"rgb\" WorldBegin\n" + lines + "\n";
}
inline std::string world3(const std::string& lines) {
    return "Film \"image\" WorldBegin\n" + lines + "\nWorldEnd\n";
}

// The fault that reading `text` ends in: "LINE:COL: what | hint"; "" if there is none.
inline std::string fault_of(const std::string& text, const ReadOptions& options = {}) {
    try {
        read_text(text, options);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::scene);
        const std::size_t name = error.where().find("s.pbrt:");
        const std::string where =
            name == std::string::npos ? error.where() : error.where().substr(name + 7);
        return where + ": " + error.what() + " | " + error.hint();
    }
    return "";
}

}  // namespace lobe::test

// The fault is at LINE:COL and speaks of `part`.
#define EXPECT_FAULT(text, line_column, part)                               \
    do {                                                                    \
        const std::string fault = lobe::test::fault_of(text);               \
        EXPECT_EQ(fault.substr(0, fault.find(": ")), line_column) << fault; \
        EXPECT_NE(fault.find(part), std::string::npos) << fault;            \
    } while (false)
