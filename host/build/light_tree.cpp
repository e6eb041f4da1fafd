// SPDX-License-Identifier: Apache-2.0
#include "build/light_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/gtc/constants.hpp>

#include "base/error.h"

namespace lobe {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int bins = 12;  // along an axis, between which a range of lights may be cut

// Some of the lights, by their place in a list that the builder sorts.
struct Range {
    std::size_t first = 0, last = 0;
    LightBounds bounds;
    std::size_t size() const { return last - first; }
};

class Builder {
  public:
    explicit Builder(const std::vector<BoundedLight>& lights) : lights_(lights) {
        for (const BoundedLight& l : lights) {
            const bool second = l.completes;
            if (second) tree_.lights.back().flags |= LOBE_LIGHT_FIRST_HALF;
            tree_.lights.push_back(l.light);
            tree_.lights.back().place = LOBE_NONE;
            if (second) tree_.lights.back().flags |= LOBE_LIGHT_SECOND_HALF;
            bounds_.push_back(l.bounds);
            if (second) bounds_[bounds_.size() - 2] = joined(bounds_[bounds_.size() - 2], l.bounds);
        }
    }

    LightTree make() {
        std::vector<Range> roots;
        for (const bool distant : {false, true}) {
            const std::size_t first = order_.size();
            for (std::size_t i = 0; i < lights_.size(); ++i)
                if (bounds_[i].distant == distant && bounds_[i].intensity > 0 &&
                    !lights_[i].completes)
                    order_.push_back(i);
            if (order_.size() > first) roots.push_back(range(first, order_.size()));
        }
        if (roots.empty()) return {};
        if (order_.size() > 1)
            add_node(roots, LOBE_NONE);
        else
            tree_.root = leaf(order_[0]);
        return std::move(tree_);
    }

  private:
    const LightBounds& bounds(std::size_t at) const { return bounds_[order_[at]]; }
    static LobeUint leaf(std::size_t light) { return LOBE_LEAF | static_cast<LobeUint>(light); }

    Range range(std::size_t first, std::size_t last) const {
        Range r{first, last, bounds(first)};
        for (std::size_t i = first + 1; i < last; ++i) r.bounds = joined(r.bounds, bounds(i));
        return r;
    }

    // Opens the costliest of a node's ranges until it has its children.
    unsigned add_node(std::vector<Range> children, LobeUint parent) {
        while (children.size() < LOBE_WIDTH) {
            const auto costliest = std::max_element(
                children.begin(), children.end(), [](const Range& a, const Range& b) {
                    return std::make_pair(a.size() > 1, light_cost(a.bounds)) <
                           std::make_pair(b.size() > 1, light_cost(b.bounds));
                });
            if (costliest->size() == 1) break;
            const auto [left, right] = cut(*costliest);
            *costliest = left;
            children.push_back(right);
        }
        const auto number = static_cast<unsigned>(tree_.nodes.size());
        tree_.nodes.emplace_back();
        tree_.nodes.back().parent = parent;
        for (unsigned lane = 0; lane < children.size(); ++lane) {
            const LobeUint place = LOBE_WIDTH * number + lane;
            LobeUint child;
            if (children[lane].size() == 1) {
                const std::size_t light = order_[children[lane].first];
                tree_.lights[light].place = place;
                if (tree_.lights[light].flags & LOBE_LIGHT_FIRST_HALF)
                    tree_.lights[light + 1].place = place;
                child = leaf(light);
            } else {
                child = add_node({children[lane]}, place);
            }
            set_child(tree_.nodes[number], lane, children[lane], child);
        }
        return number;
    }

    void set_child(LobeLightNode& node, unsigned lane, const Range& range, LobeUint child) const {
        const LightBounds& b = range.bounds;
        const glm::dvec3 centre = b.centre();
        double radius = b.radius();
        const bool sphere =
            range.size() == 1 && lights_[order_[range.first]].light.kind == LOBE_LIGHT_SPHERE;
        if (sphere) radius = 0.5 * (b.high.x - b.low.x);  // not of the box about it
        for (int axis = 0; axis < 3; ++axis) {
            node.centre[axis][lane] = static_cast<float>(centre[axis]);
            node.axis[axis][lane] = static_cast<float>(b.axis[axis]);
        }
        if (b.distant) radius = range.size() == 1 ? 0 : 2;
        // A little more than all, for what rounding may lose.
        node.radius[lane] = static_cast<float>(radius * (1 + 1e-6) + 1e-6);
        node.near[lane] = b.distant ? 0 : 1;
        // What is about the receiver counts as if from the sphere's rim: undo that for directions.
        const double far = b.distant ? std::max(1.0, radius * radius) : 1;
        node.intensity[lane] = static_cast<float>(b.intensity * far);
        const bool everywhere = b.spread >= glm::pi<double>();
        node.spread_cosine[lane] = everywhere ? -2 : static_cast<float>(std::cos(b.spread));
        node.spread_sine[lane] = everywhere ? 0 : static_cast<float>(std::sin(b.spread));
        node.child[lane] = child;
    }

    // Cuts a range of two lights or more where the two parts cost least.
    std::pair<Range, Range> cut(const Range& all) {
        const auto half = [&](std::size_t middle) {
            return std::make_pair(range(all.first, middle), range(middle, all.last));
        };
        const glm::dvec3 size = centres(all).second - centres(all).first;
        int best_axis = -1, best_bin = 0;
        double least = infinity;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(size[axis] > 0)) continue;
            const double stretch = std::max({size.x, size.y, size.z}) / size[axis];
            const auto costs = cut_costs(all, axis);
            for (int bin = 0; bin < bins - 1; ++bin) {
                if (!(costs[bin] * stretch < least)) continue;
                least = costs[bin] * stretch;
                best_axis = axis;
                best_bin = bin;
            }
        }
        if (best_axis < 0) return half(all.first + all.size() / 2);  // all in one place
        const auto middle = std::stable_partition(
            order_.begin() + all.first, order_.begin() + all.last,
            [&, low = centres(all).first](std::size_t light) {
                return bin_of(bounds_[light], best_axis, low, size) <= best_bin;
            });
        const auto at = static_cast<std::size_t>(middle - order_.begin());
        return half(at == all.first || at == all.last ? all.first + all.size() / 2 : at);
    }

    std::pair<glm::dvec3, glm::dvec3> centres(const Range& all) const {
        glm::dvec3 low(infinity), high(-infinity);
        for (std::size_t i = all.first; i < all.last; ++i) {
            low = glm::min(low, bounds(i).centre());
            high = glm::max(high, bounds(i).centre());
        }
        return {low, high};
    }

    static int bin_of(const LightBounds& b, int axis, const glm::dvec3& low,
                      const glm::dvec3& size) {
        const double at = (b.centre()[axis] - low[axis]) / size[axis];
        return std::clamp(static_cast<int>(bins * at), 0, bins - 1);
    }

    // Of cutting behind each bin; infinity where a part would be empty.
    std::array<double, bins> cut_costs(const Range& all, int axis) const {
        const auto [low, high] = centres(all);
        std::array<LightBounds, bins> bin{};
        std::array<bool, bins> filled{};
        for (std::size_t i = all.first; i < all.last; ++i) {
            const int b = bin_of(bounds(i), axis, low, high - low);
            bin[b] = filled[b] ? joined(bin[b], bounds(i)) : bounds(i);
            filled[b] = true;
        }
        std::array<double, bins> costs;
        costs.fill(infinity);
        for (int at = 0; at < bins - 1; ++at) {
            const double below = cost_of(bin, filled, 0, at + 1);
            costs[at] = below + cost_of(bin, filled, at + 1, bins);
        }
        return costs;
    }

    static double cost_of(const std::array<LightBounds, bins>& bin,
                          const std::array<bool, bins>& filled, int first, int last) {
        LightBounds all;
        bool any = false;
        for (int b = first; b < last; ++b) {
            if (!filled[b]) continue;
            all = any ? joined(all, bin[b]) : bin[b];
            any = true;
        }
        return any ? light_cost(all) : infinity;
    }

    const std::vector<BoundedLight>& lights_;
    std::vector<LightBounds> bounds_;  // of each light; of first halves, of both
    std::vector<std::size_t> order_;   // those to choose among, range by range
    LightTree tree_;
};

}  // namespace

LightTree make_light_tree(const std::vector<BoundedLight>& lights) {
    if (lights.size() > LOBE_LEAF_INDEX)
        throw Error(ExitCode::scene, "the scene has more than 2^28 lights", "",
                    "each triangle of a shining mesh is a light");
    return Builder(lights).make();
}

}  // namespace lobe
