// SPDX-License-Identifier: Apache-2.0
// The verbs below `lobe brdf`: the laboratory of reflectance models.
#pragma once

#include "app/command.h"
#include "scene/brdf_table.h"

namespace lobe {

Command add_brdf_list(CLI::App& verb);
Command add_brdf_check(CLI::App& verb);
Command add_brdf_new(CLI::App& verb);
Command add_brdf_table(CLI::App& verb);
Command add_brdf_plot(CLI::App& verb);
Command add_brdf_doc(CLI::App& verb);
Command add_brdf_fit(CLI::App& verb);
Command add_brdf_trial(CLI::App& verb);

// lobe brdf check --extremes: the report on stiff and extreme cases; gives the exit code.
int run_brdf_extremes(const CommonOptions& common, const KernelText& kernels,
                      const std::vector<const BrdfTable*>& models, bool reduced);

// The model of that name, or Error (usage) with the nearest one.
const BrdfTable& find_brdf(const std::vector<BrdfTable>& models, const std::string& name);

}  // namespace lobe
