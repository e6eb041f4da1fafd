// SPDX-License-Identifier: Apache-2.0
// What is wrong with a user's own model, told as the user's fault and at a place in the user's
// file.
#pragma once

#include "base/error.h"
#include "scene/brdf_table.h"

namespace lobe {

class KernelText;

// The same error, with the exit code of faulty data (3) where its place is in no file of lobe's.
Error users_fault(const Error& error, const KernelText& kernels);

// Why a program that holds this model, and no other of the user's, does not build: a function that
// the contract wants and the file has not; else users_fault(), which for a place in lobe's own
// kernels says that the model does not fit there.
Error build_fault(const Error& error, const KernelText& kernels, const BrdfTable& model);

}  // namespace lobe
