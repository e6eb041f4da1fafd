// SPDX-License-Identifier: Apache-2.0
#include "build/bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "build/bvh_tree.h"

namespace lobe {
namespace {

// Boxes grow by this, in units of the largest coordinate (one): the kernels' plane test is one fma
// on a rounded product, which moves a plane by less than 4 * 2^-24 of it.
constexpr float enlargement = 1e-6f;
constexpr float infinity = std::numeric_limits<float>::infinity();

Bounds triangle_bounds(const LobeTriangle& t, const std::vector<LobeVertex>& vertices) {
    Bounds b{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    for (unsigned index : {t.v0, t.v1, t.v2}) {
        const LobeVertex& v = vertices[index];
        const float p[3] = {v.px, v.py, v.pz};
        for (int axis = 0; axis < 3; ++axis) {
            b.lo[axis] = std::min(b.lo[axis], p[axis]);
            b.hi[axis] = std::max(b.hi[axis], p[axis]);
        }
    }
    return b;
}

Bounds sphere_bounds(const LobeSphere& s) {
    return {{s.x - s.radius, s.y - s.radius, s.z - s.radius},
            {s.x + s.radius, s.y + s.radius, s.z + s.radius}};
}

class Layout {
  public:
    Layout(const std::vector<LobeTriangle>& triangles, const std::vector<LobeVertex>& vertices,
           const std::vector<LobeSphere>& spheres)
        : triangles_(triangles), vertices_(vertices), spheres_(spheres) {
        for (const LobeTriangle& t : triangles) bounds_.push_back(triangle_bounds(t, vertices));
        for (const LobeSphere& s : spheres) bounds_.push_back(sphere_bounds(s));
    }

    Bvh make() {
        const BvhTree tree(bounds_);
        const TreeNode* root = tree.root();
        if (!root) {
            add_node();
            bvh_.depth = 1;
        } else if (root->leaf) {
            add_leaf_pair(static_cast<const TreeLeaf&>(*root), 1);
        } else {
            add_branch(static_cast<const TreeBranch&>(*root), 1);
        }
        return std::move(bvh_);
    }

  private:
    // A node of empty boxes; returns its index.
    unsigned add_node() {
        LobeNode node{};
        for (int axis = 0; axis < 3; ++axis) {
            std::fill_n(node.plane[2 * axis], LOBE_WIDTH, infinity);
            std::fill_n(node.plane[2 * axis + 1], LOBE_WIDTH, -infinity);
        }
        std::fill_n(node.child, LOBE_WIDTH, LOBE_NONE);
        bvh_.nodes.push_back(node);
        return static_cast<unsigned>(bvh_.nodes.size() - 1);
    }

    void set_child(unsigned node, unsigned lane, const Bounds& box, unsigned child) {
        LobeNode& n = bvh_.nodes[node];
        for (int axis = 0; axis < 3; ++axis) {
            n.plane[2 * axis][lane] = box.lo[axis] - enlargement;
            n.plane[2 * axis + 1][lane] = box.hi[axis] + enlargement;
        }
        n.child[lane] = child;
    }

    unsigned add_branch(const TreeBranch& branch, unsigned depth) {
        bvh_.depth = std::max(bvh_.depth, depth);
        const unsigned node = add_node();
        for (unsigned i = 0; i < branch.count; ++i) {
            const TreeNode* child = branch.children[i];
            const unsigned reference =
                child->leaf ? add_leaf(static_cast<const TreeLeaf&>(*child), depth)
                            : add_branch(static_cast<const TreeBranch&>(*child), depth + 1);
            set_child(node, i, branch.bounds[i], reference);
        }
        return node;
    }

    // A leaf holds one kind of shape; one that has both becomes a node of two leaves.
    unsigned add_leaf(const TreeLeaf& leaf, unsigned depth) {
        const auto [triangles, spheres] = split(leaf);
        if (!triangles.empty() && !spheres.empty()) return add_leaf_pair(leaf, depth + 1);
        return triangles.empty() ? add_spheres(spheres) : add_triangles(triangles);
    }

    unsigned add_leaf_pair(const TreeLeaf& leaf, unsigned depth) {
        bvh_.depth = std::max(bvh_.depth, depth);
        const unsigned node = add_node();
        const auto [triangles, spheres] = split(leaf);
        unsigned lane = 0;
        if (!triangles.empty())
            set_child(node, lane++, around(triangles), add_triangles(triangles));
        if (!spheres.empty()) set_child(node, lane++, around(spheres), add_spheres(spheres));
        return node;
    }

    std::pair<std::vector<unsigned>, std::vector<unsigned>> split(const TreeLeaf& leaf) const {
        std::pair<std::vector<unsigned>, std::vector<unsigned>> kinds;
        for (unsigned i = 0; i < leaf.count; ++i) {
            const unsigned p = leaf.primitives[i];
            (p < triangles_.size() ? kinds.first : kinds.second).push_back(p);
        }
        // The builder's threads may hand primitives over in any order: the layout must not depend
        // on it.
        std::sort(kinds.first.begin(), kinds.first.end());
        std::sort(kinds.second.begin(), kinds.second.end());
        return kinds;
    }

    Bounds around(const std::vector<unsigned>& primitives) const {
        Bounds box = bounds_[primitives[0]];
        for (unsigned p : primitives) {
            for (int axis = 0; axis < 3; ++axis) {
                box.lo[axis] = std::min(box.lo[axis], bounds_[p].lo[axis]);
                box.hi[axis] = std::max(box.hi[axis], bounds_[p].hi[axis]);
            }
        }
        return box;
    }

    static unsigned leaf_reference(std::size_t first, std::size_t blocks, unsigned kind) {
        if (first > LOBE_LEAF_INDEX || blocks > LOBE_LEAF_BLOCKS)
            throw Error(ExitCode::scene, "the scene has more leaves than the kernels can name");
        return LOBE_LEAF | kind | static_cast<unsigned>(blocks - 1) << LOBE_LEAF_SHIFT |
               static_cast<unsigned>(first);
    }

    unsigned add_triangles(const std::vector<unsigned>& primitives) {
        auto& leaves = bvh_.triangle_leaves;
        const std::size_t first = leaves.size();
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            const std::size_t lane = i % LOBE_WIDTH;
            if (lane == 0) {
                leaves.push_back({});
                std::fill_n(&leaves.back().vertex[0][0][0], 9 * LOBE_WIDTH, std::nanf(""));
                std::fill_n(leaves.back().primitive, LOBE_WIDTH, LOBE_NONE);
            }
            LobeTriangleLeaf& leaf = leaves.back();
            const LobeTriangle& t = triangles_[primitives[i]];
            leaf.primitive[lane] = primitives[i];
            const unsigned corners[3] = {t.v0, t.v1, t.v2};
            for (int corner = 0; corner < 3; ++corner) {
                const LobeVertex& v = vertices_[corners[corner]];
                leaf.vertex[corner][0][lane] = v.px;
                leaf.vertex[corner][1][lane] = v.py;
                leaf.vertex[corner][2][lane] = v.pz;
            }
        }
        return leaf_reference(first, leaves.size() - first, 0);
    }

    unsigned add_spheres(const std::vector<unsigned>& primitives) {
        auto& leaves = bvh_.sphere_leaves;
        const std::size_t first = leaves.size();
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            const std::size_t lane = i % LOBE_WIDTH;
            if (lane == 0) {
                leaves.push_back({});
                std::fill_n(leaves.back().radius, LOBE_WIDTH, std::nanf(""));
                std::fill_n(leaves.back().primitive, LOBE_WIDTH, LOBE_NONE);
            }
            LobeSphereLeaf& leaf = leaves.back();
            const LobeSphere& s = spheres_[primitives[i] - triangles_.size()];
            leaf.primitive[lane] = primitives[i];
            leaf.centre[0][lane] = s.x;
            leaf.centre[1][lane] = s.y;
            leaf.centre[2][lane] = s.z;
            leaf.radius[lane] = s.radius;
        }
        return leaf_reference(first, leaves.size() - first, LOBE_LEAF_SPHERES);
    }

    const std::vector<LobeTriangle>& triangles_;
    const std::vector<LobeVertex>& vertices_;
    const std::vector<LobeSphere>& spheres_;
    std::vector<Bounds> bounds_;
    Bvh bvh_;
};

}  // namespace

Bvh build_bvh(const std::vector<LobeTriangle>& triangles, const std::vector<LobeVertex>& vertices,
              const std::vector<LobeSphere>& spheres) {
    return Layout(triangles, vertices, spheres).make();
}

}  // namespace lobe
