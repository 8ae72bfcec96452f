// SPDX-License-Identifier: BSD-3-Clause
#include "law/SharedContact.h"

#include "law/Foot.h"
#include "law/Law.h"
#include "probe/ConstrainedPoint.h"

#include <algorithm>
#include <utility>

namespace palpate::haptics::law {

namespace {

/// Minimum depth at which a law is evaluated, as a fraction of the spring. In an acute groove the HIP can be in front
/// of an active plane; the initial slope of the law is used there.
constexpr double kLeastDepth = 1e-6;

/// Contribution of one structure to a contact.
struct Part
{
    std::size_t plane;               ///< index of the structure's first plane
    Vec3 push_W = Vec3::Zero();      ///< P_S [mm]
    double lambda_mm = 0.0;          ///< sum of the structure's multipliers
    double secant_N_per_mm = 0.0;    ///< k_S
    double stiffness_N_per_mm = 0.0; ///< force divided by push, at most k_S
    Vec3 aside_W = Vec3::Zero();     ///< lateral force from the gradients of the maps [N]
    Vec3 damper_W = Vec3::Zero();    ///< damper force if the structure were alone [N]
    Contact contact;
};

/// Contributions of all structures that push.
struct Parts
{
    std::array<Part, 3> of;
    std::size_t count = 0;
    Vec3 push_W = Vec3::Zero(); ///< sum of the pushes [mm]
    double lambda_mm = 0.0;     ///< sum of the multipliers

    /// Decomposes a spring into the active planes.
    Parts(std::span<const ActiveConstraint> planes, const Vec3& spring_W) noexcept
    {
        std::array<internal::HalfSpace, 3> spaces;
        for (std::size_t i = 0; i < planes.size(); ++i) {
            spaces[i] = {planes[i].n_W, 0.0};
        }
        const internal::ConstrainedPoint held = internal::constrainedPoint(
            -spring_W, std::span<const internal::HalfSpace>(spaces).first(planes.size()), 0.0);
        std::array<double, 3> each_mm{};
        for (std::size_t i = 0; i < static_cast<std::size_t>(held.count); ++i) {
            each_mm[held.active[i]] = held.lambda_mm[i];
        }
        for (std::size_t i = 0; i < planes.size(); ++i) {
            if (each_mm[i] > 0.0) {
                add(planes, i, each_mm[i]);
            }
        }
    }

  private:
    void add(std::span<const ActiveConstraint> planes, std::size_t plane, double by_mm) noexcept
    {
        const auto end = of.begin() + static_cast<std::ptrdiff_t>(count);
        auto part = std::find_if(of.begin(), end, [&](const Part& known) {
            return planes[known.plane].structure == planes[plane].structure;
        });
        if (part == end) {
            part->plane = plane;
            ++count;
        }
        const Vec3 push = by_mm * planes[plane].n_W;
        part->push_W += push;
        part->lambda_mm += by_mm;
        push_W += push;
        lambda_mm += by_mm;
    }
};

/// Sorts up to three elements.
template<class Number>
void sortBy(std::span<Part> parts, const Number& number) noexcept
{
    for (std::size_t i = 1; i < parts.size(); ++i) {
        for (std::size_t j = i; j > 0 && number(parts[j]) < number(parts[j - 1]); --j) {
            std::swap(parts[j], parts[j - 1]);
        }
    }
}

/// Evaluates the law of a structure as if it were alone, at its own depth and foot.
/// @param touch  with the depth and direction of the part
/// @param part  receives force and contact
void askLaw(const Touch& touch, Part& part) noexcept
{
    const Foot foot(touch);
    const MappedTouch mapped{touch, foot};
    const Vec3 spring_W =
        touch.structure.maps.hasFelt() ? Sum<TransmissionSpring>::force(mapped) : Sum<MapSpring>::force(mapped);
    const double along_N = spring_W.dot(touch.up_W);
    part.secant_N_per_mm = along_N / touch.depth_mm;
    // The stored energy of a part is the energy of its law times its fraction of the push: W_S(lambda_S) at a right
    // angle, and the common energy where the planes are nearly parallel.
    part.aside_W = std::min(1.0, part.push_W.norm() / touch.depth_mm) * (spring_W - along_N * touch.up_W);
    part.damper_W = WithMaps<>::force(mapped);
}

/// Distributes the force by levels of stiffness: sets `stiffness_N_per_mm` of each part.
/// @pre sorted by ascending secant stiffness
void levelStiffness(std::span<Part> parts, const Vec3& all_W) noexcept
{
    for (std::size_t j = 0; j < parts.size(); ++j) {
        Vec3 push_W = Vec3::Zero();
        for (const Part& part : parts.subspan(j)) {
            push_W += part.push_W;
        }
        const double length2 = push_W.squaredNorm(), along = all_W.dot(push_W);
        // In an acute groove the multipliers exceed the depths. Only the part that reaches behind the planes counts.
        const double reached = along >= length2 ? 1.0 : std::max(0.0, along / length2);
        const double more = parts[j].secant_N_per_mm - (j > 0 ? parts[j - 1].secant_N_per_mm : 0.0);
        for (Part& part : parts.subspan(j)) {
            part.stiffness_N_per_mm += more * reached;
        }
    }
}

} // namespace

SharedContact sharedContact(const HapticScene& scene, std::span<const ActiveConstraint> planes,
                            std::span<const internal::Facet> facets, const Vec3& p_WG, const Vec3& push_W,
                            const Motion& hip) noexcept
{
    SharedContact shared;
    Parts all(planes, push_W);
    const double length = all.push_W.norm(), spring = push_W.norm();
    if (!(length > 0.0)) {
        return shared;
    }
    const std::span<Part> parts = std::span(all.of).first(all.count);
    for (Part& part : parts) {
        const ActiveConstraint& plane = planes[part.plane];
        const HapticStructure& on = scene.structures()[plane.structure];
        Contact& contact = part.contact;
        contact.p_WG = p_WG;
        contact.n_W = part.push_W.normalized();
        contact.depth_mm = std::max(0.0, push_W.dot(contact.n_W));
        contact.stiffnessScale = 1.0;
        contact.structure = plane.structure;
        contact.triangle = on.surface->sourceTriangle(plane.triangle);
        // With friction, the law acts along the whole spring, as for a single structure.
        const double depth = std::max(kLeastDepth, all.push_W.dot(contact.n_W) / length) * spring;
        const Vec3 own_W = depth * contact.n_W;
        askLaw({on, facets[part.plane], scene.fingertip_mm(), p_WG, own_W, depth, contact.n_W, hip, planes,
                contact.stiffnessScale},
               part);
    }
    sortBy(parts, [](const Part& part) { return part.secant_N_per_mm; });
    levelStiffness(parts, all.push_W);
    const Vec3 rest_W = push_W - all.push_W;
    for (Part& part : parts) {
        const double share = part.lambda_mm / all.lambda_mm;
        part.contact.f_W = part.stiffness_N_per_mm * (part.push_W + share * rest_W) + part.aside_W;
        part.contact.f_W += share * part.damper_W;
    }
    sortBy(parts, [](const Part& part) { return part.contact.f_W.squaredNorm(); });
    for (const Part& part : parts) {
        shared.contacts[shared.count++] = part.contact;
    }
    shared.n_W = all.push_W / length;
    return shared;
}

} // namespace palpate::haptics::law
