// SPDX-License-Identifier: Apache-2.0
// The device must lay out the shared structs as the host does. layout.def lists every member; the
// build makes it from the headers themselves (tests/support/layout_table.cmake).
#include <gtest/gtest.h>

#include <cstddef>

#include "base/files.h"
#include "shared/frame.h"
#include "shared/types.h"
#include "support/probe.h"

using namespace lobe;
using namespace lobe::test;

namespace {

struct Entry {
    const char* name;
    std::size_t value;
};

// The table as the host's compiler sees it, in the order in which the kernel writes.
#define LAYOUT_STRUCT(type) {"sizeof(" #type ")", sizeof(type)},
#define LAYOUT_MEMBER(type, member)                           \
    {"offset of " #type "." #member, offsetof(type, member)}, \
        {"sizeof " #type "." #member, sizeof(type::member)},
const std::vector<Entry> host_layout = {
#include "layout.def"
};
#undef LAYOUT_STRUCT
#undef LAYOUT_MEMBER

#define LAYOUT_STRUCT(type) {#type, sizeof(type)},
#define LAYOUT_MEMBER(type, member)
const std::vector<Entry> structs = {
#include "layout.def"
};
#undef LAYOUT_STRUCT
#undef LAYOUT_MEMBER

}  // namespace

TEST(Layout, DeviceAgreesWithHost) {
    ASSERT_GT(host_layout.size(), 200u);
    const Program program =
        build_probe("probe/layout.cl", {{"layout.def", read_file(LOBE_LAYOUT_TABLE)}});
    Buffer<cl_uint> out(test_device(), host_layout.size());
    run_probe(program, "layout", 1, out);
    const std::vector<cl_uint> device_layout = out.read_all();
    for (std::size_t i = 0; i < host_layout.size(); ++i)
        EXPECT_EQ(device_layout[i], host_layout[i].value) << host_layout[i].name;
}

TEST(Layout, StructsAreWholeRows) {
    for (const Entry& entry : structs) EXPECT_EQ(entry.value % 16, 0u) << entry.name;
}

// Members follow one another without holes: nothing is left to a compiler's padding.
TEST(Layout, StructsHaveNoPadding) {
    std::size_t end = 0, size = 0;
    for (std::size_t i = 0; i < host_layout.size(); ++i) {
        const std::string name = host_layout[i].name;
        if (name.compare(0, 7, "sizeof(") == 0) {
            EXPECT_EQ(end, size) << "before " << name;
            size = host_layout[i].value;
            end = 0;
        } else {
            EXPECT_EQ(host_layout[i].value, end) << name;
            end += host_layout[++i].value;
        }
    }
    EXPECT_EQ(end, size);
}
