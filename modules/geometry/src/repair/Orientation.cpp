// SPDX-License-Identifier: BSD-3-Clause
#include "Orientation.h"

#include <array>

namespace palpate::geometry {

namespace {

constexpr std::uint32_t kNoTriangle = 0xffffffffu;
constexpr std::uint8_t kKeep = 0, kTurn = 1, kNotReached = 2;

/// Neighbour across an edge of two triangles.
struct Link
{
    std::uint32_t neighbour = kNoTriangle;
    bool isSameWay = false; ///< both traverse the edge in the same direction, i.e. inconsistently
};

void add(std::array<Link, 3>& links, const Link& link)
{
    for (Link& slot : links) {
        if (slot.neighbour == kNoTriangle) {
            slot = link;
            return;
        }
    }
}

} // namespace

std::vector<std::uint32_t> trianglesToReverse(std::size_t triangleCount, const EdgeTable& edges,
                                              const std::vector<std::uint32_t>& componentOf,
                                              std::vector<Component>& components)
{
    std::vector<std::array<Link, 3>> links(triangleCount);
    edges.forEach([&links](const EdgeUse* uses, std::size_t count) {
        if (count == 2) {
            const bool isSameWay = uses[0].isForward == uses[1].isForward;
            add(links[uses[0].triangle], {uses[1].triangle, isSameWay});
            add(links[uses[1].triangle], {uses[0].triangle, isSameWay});
        }
    });
    std::vector<std::uint8_t> facing(triangleCount, kNotReached);
    std::vector<std::uint32_t> turned, patch;
    for (std::uint32_t seed = 0; seed < triangleCount; ++seed) {
        Component& component = components[componentOf[seed]];
        if (component.isConsistent || facing[seed] != kNotReached) {
            continue;
        }
        patch.assign(1, seed);
        facing[seed] = kKeep;
        std::size_t turn = 0;
        for (std::size_t i = 0; i < patch.size(); ++i) {
            const std::uint8_t own = facing[patch[i]];
            turn += own == kTurn ? 1 : 0;
            for (const Link& link : links[patch[i]]) {
                if (link.neighbour == kNoTriangle) {
                    continue;
                }
                const auto wanted = static_cast<std::uint8_t>(link.isSameWay ? own ^ 1 : own);
                if (facing[link.neighbour] == kNotReached) {
                    facing[link.neighbour] = wanted;
                    patch.push_back(link.neighbour);
                } else if (facing[link.neighbour] != wanted) {
                    component.isOrientable = false;
                }
            }
        }
        const std::uint8_t minority = 2 * turn > patch.size() ? kKeep : kTurn;
        for (const std::uint32_t t : patch) {
            if (facing[t] == minority) {
                turned.push_back(t);
            }
        }
    }
    std::erase_if(turned, [&](std::uint32_t t) { return !components[componentOf[t]].isOrientable; });
    return turned;
}

} // namespace palpate::geometry
