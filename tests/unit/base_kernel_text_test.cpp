// SPDX-License-Identifier: Apache-2.0
#include "base/kernel_text.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "support/temp_folder.h"

using namespace lobe;
using lobe::test::TempFolder;

TEST(KernelText, EmbeddedFilesAreThoseOfTheFolder) {
    const KernelText embedded, folder(std::string(LOBE_SOURCE_DIR) + "/kernels");
    const auto paths = embedded.list("");
    EXPECT_EQ(paths, folder.list(""));
    EXPECT_TRUE(std::is_sorted(paths.begin(), paths.end()));
    EXPECT_TRUE(std::count(paths.begin(), paths.end(), "shared/features.def"));
    for (const std::string& path : paths)
        EXPECT_TRUE(embedded.read(path) == folder.read(path)) << path;
}

TEST(KernelText, ListsByPrefix) {
    const auto paths = KernelText().list("brdf/");
    EXPECT_TRUE(std::count(paths.begin(), paths.end(), "brdf/brdf.h"));
    for (const std::string& path : paths) EXPECT_EQ(path.substr(0, 5), "brdf/");
}

TEST(KernelText, FolderTakesThePlaceOfTheEmbeddedFiles) {
    const TempFolder folder;
    folder.write("brdf/mine.h", "one");
    folder.write("notes.txt", "not a kernel");
    const KernelText kernels(folder.path());
    EXPECT_EQ(kernels.read("brdf/mine.h"), "one");
    EXPECT_EQ(kernels.list(""), std::vector<std::string>{"brdf/mine.h"});
    EXPECT_FALSE(kernels.has("brdf/brdf.h"));
}

TEST(KernelText, AddedTextsHideFiles) {
    const TempFolder folder;
    folder.write("brdf/a.h", "file");
    for (const std::string& root : {std::string(), folder.path()}) {
        KernelText kernels(root);
        const std::size_t count = kernels.list("").size();
        EXPECT_FALSE(kernels.has("../velvet.cl"));
        kernels.add("../velvet.cl", "mine");
        EXPECT_TRUE(kernels.has("../velvet.cl"));
        EXPECT_TRUE(kernels.added("../velvet.cl"));
        EXPECT_EQ(kernels.read("../velvet.cl"), "mine");
        EXPECT_EQ(kernels.list("../").size(), 1u);
        EXPECT_EQ(kernels.list("").size(), count + 1);
        const std::string known = kernels.list("brdf/").front();
        EXPECT_FALSE(kernels.added(known));
        kernels.add(known, "other");
        EXPECT_EQ(kernels.read(known), "other");
        EXPECT_EQ(kernels.list("").size(), count + 1);
    }
}

TEST(KernelText, RefusesWhatIsNotThere) {
    const TempFolder folder;
    folder.write("secret", "x");
    folder.write("kernels/a.h", "y");
    const KernelText kernels(folder.file("kernels"));
    EXPECT_THROW(KernelText(folder.file("none")), Error);
    EXPECT_THROW(KernelText().read("no.h"), Error);
    EXPECT_THROW(kernels.read("../secret"), Error);
    EXPECT_THROW(kernels.read(folder.file("secret")), Error);
}
