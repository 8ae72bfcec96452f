// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/Dimple.h"

#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace palpate::view {

namespace {

// Everything is in the camera frame [mm], so that single precision suffices however far a mesh is from the origin.
// VTK declares the uniforms in the vertex shader; the fragment shader of the same program uses the same names.
constexpr const char* kVertexDeclarations = R"(//VTK::PositionVC::Dec
out vec3 dimpleRest;
)";
constexpr const char* kFragmentDeclarations = R"(//VTK::PositionVC::Dec
in vec3 dimpleRest;         // where the tissue is that bends
uniform vec3 dimpleAt;      // contact
uniform vec3 dimpleInward;  // unit
uniform vec4 dimplePress;   // d, c, distance from which it fades, at which it ends
uniform vec3 dimpleGridU;   // across the grid's lines, unit, …
uniform vec3 dimpleGridV;   // … and across the others
uniform vec3 dimpleGrid;    // spacing, and where the contact lies in it
)";

constexpr const char* kVertex = R"(//VTK::PositionVC::Impl
  dimpleRest = vertexVCVSOutput.xyz;
  if (dimplePress.x > 0.0) {
    vec3 q = dimpleRest - dimpleAt;
    float away = length(q);
    if (away < dimplePress.w) {
      float height = dot(q, dimpleInward);
      float z = max(height, 0.0);
      // What lies before the surface bends only where it is part of it, as the wall of a hollow is.
      float isOfIt = max(smoothstep(-0.5, 0.0, -dot(normalize(normalMatrix * normalMC), dimpleInward)),
                         smoothstep(-0.1, 0.0, height));
      float drawn = z * min(1.0, 3.0 * dimplePress.y / dimplePress.x);
      vec3 S = q + (drawn - height + dimplePress.y) * dimpleInward;
      float R = sqrt(dot(S, S) + (height - z) * (height - z));
      vec3 u = dimplePress.x * dimplePress.y * (dimpleInward / R + drawn * S / (R * R * R));
      u *= isOfIt * (1.0 - smoothstep(dimplePress.z, dimplePress.w, away));
      vertexVCVSOutput.xyz += u;
      gl_Position += MCDCMatrix * vec4(inverse(mat3(MCVCMatrix)) * u, 0.0);
    }
  }
)";

// Bends the normal per fragment, so that coarse meshes are shaded smoothly: two tangents are transformed with the
// gradient of the displacement and crossed.
constexpr const char* kNormal = R"(//VTK::Normal::Impl
  float dimpleInk = 0.0;
  if (dimplePress.x > 0.0) {
    vec3 q = dimpleRest - dimpleAt;
    vec2 place = vec2(dot(q, dimpleGridU), dot(q, dimpleGridV)) / dimpleGrid.x + dimpleGrid.yz;
    vec2 perPixel = max(fwidth(place), vec2(1e-4));
    float away = length(q);
    if (away < dimplePress.w) {
      float height = dot(q, dimpleInward);
      float slow = height > 0.0 ? min(1.0, 3.0 * dimplePress.y / dimplePress.x) : 0.0;
      float drawn = slow * height;
      vec3 S = q + (drawn - height + dimplePress.y) * dimpleInward;
      float before = min(height, 0.0);
      float R2 = dot(S, S) + before * before;
      float fade = 1.0 - smoothstep(dimplePress.z, dimplePress.w, away);
      float k = fade * dimplePress.x * dimplePress.y / (R2 * sqrt(R2));
      vec3 t1 = normalize(abs(normalVCVSOutput.x) < 0.7 ? cross(normalVCVSOutput, vec3(1.0, 0.0, 0.0))
                                                        : cross(normalVCVSOutput, vec3(0.0, 1.0, 0.0)));
      vec3 t2 = cross(normalVCVSOutput, t1);
      vec3 ends[2] = vec3[2](t1, t2);
      for (int i = 0; i < 2; ++i) {
        float down = dot(dimpleInward, ends[i]);
        vec3 dS = ends[i] + (slow - 1.0) * down * dimpleInward;
        float RdR = dot(S, dS) + before * down;
        ends[i] += k * (slow * down * S - RdR * dimpleInward + drawn * (dS - 3.0 * S * (RdR / R2)));
      }
      vec3 bent = cross(ends[0], ends[1]);
      normalVCVSOutput = dot(bent, bent) > 1e-12 ? normalize(bent) : normalVCVSOutput;
      vec2 off = abs(fract(place + 0.5) - 0.5) / perPixel;
      float line = clamp(1.4 - min(off.x, off.y), 0.0, 1.0) *
                   clamp(0.5 / max(perPixel.x, perPixel.y) - 1.0, 0.0, 1.0); // none where they would run together
      float isSurface = 1.0 - smoothstep(1.0, 2.0, abs(height) - 0.35 * away);
      dimpleInk = 0.32 * line * isSurface * smoothstep(0.0, 0.6, dimplePress.x) *
                  (1.0 - smoothstep(0.25 * dimplePress.z, 0.55 * dimplePress.z, away));
    }
  }
)";

// Replacement points in VTK's shaders.
constexpr const char *kDeclared = "//VTK::PositionVC::Dec", *kPlaced = "//VTK::PositionVC::Impl",
                     *kTurned = "//VTK::Normal::Impl", *kLit = "//VTK::Light::Impl";

constexpr const char* kInk = R"(  ambientColor *= 1.0 - dimpleInk;
  diffuseColor *= 1.0 - dimpleInk;
//VTK::Light::Impl
)";

std::array<float, 3> floats(const Vec3& v)
{
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

/// Grid spacing: the smallest of 1, 2, 5 and 10 mm that keeps the lines at least a few pixels apart.
double gridSpacing_mm(double mmPerPixel)
{
    constexpr double kNearest_px = 9.0;
    double spacing = 1.0;
    for (const double factor : {2.0, 2.5, 2.0}) {
        if (spacing >= kNearest_px * mmPerPixel) {
            break;
        }
        spacing *= factor;
    }
    return spacing;
}

} // namespace

Dimple Dimple::of(const TouchState& state)
{
    Dimple dimple;
    if (!state.bends || !state.isPresent || !state.isInContact || !state.n_W.allFinite() || !(state.n_W.norm() > 0.5)) {
        return dimple;
    }
    dimple.n_W = state.n_W.normalized();
    // The god-object of a fingertip is the centre of its sphere.
    dimple.p_W = state.p_WG - state.fingertip_mm * dimple.n_W;
    dimple.radius_mm = state.fingertip_mm > 0.0 ? state.fingertip_mm : kPointRadius_mm;
    const double depth_mm = (state.p_WG - state.p_WH).dot(dimple.n_W);
    dimple.depth_mm = std::isfinite(depth_mm) && dimple.p_W.allFinite() ? std::max(0.0, depth_mm) : 0.0;
    return dimple;
}

Vec3 Dimple::displacement_W(const Vec3& rest_W) const
{
    if (!(depth_mm > 0.0)) {
        return Vec3::Zero();
    }
    const double c = radius_mm / std::numbers::pi;
    const Vec3 e = -n_W, q = rest_W - p_W;
    const double height = q.dot(e), z = std::max(0.0, height);
    const double drawn = z * std::min(1.0, kUnfolded * c / depth_mm);
    const Vec3 S = q + (drawn - height + c) * e;
    const double R = std::sqrt(S.squaredNorm() + (height - z) * (height - z));
    return depth_mm * c * (e / R + drawn * S / (R * R * R));
}

bool Dimple::reaches(const core::Box& box) const
{
    return depth_mm > 0.0 && box.exteriorDistance(p_W) < kTo * radius_mm;
}

void startBending(vtkActor& actor)
{
    vtkShaderProperty* shader = actor.GetShaderProperty();
    shader->AddVertexShaderReplacement(kDeclared, true, kVertexDeclarations, false);
    shader->AddVertexShaderReplacement(kPlaced, true, kVertex, false);
    shader->AddFragmentShaderReplacement(kDeclared, true, kFragmentDeclarations, false);
    shader->AddFragmentShaderReplacement(kTurned, true, kNormal, false);
    shader->AddFragmentShaderReplacement(kLit, true, kInk, false);
}

void stopBending(vtkActor& actor)
{
    vtkShaderProperty* shader = actor.GetShaderProperty();
    shader->ClearVertexShaderReplacement(kDeclared, true);
    shader->ClearVertexShaderReplacement(kPlaced, true);
    for (const char* place : {kDeclared, kTurned, kLit}) {
        shader->ClearFragmentShaderReplacement(place, true);
    }
    shader->GetVertexCustomUniforms()->RemoveAllUniforms(); // VTK warns about uniforms that no shader uses
}

void bend(vtkActor& actor, const Dimple& dimple, const ViewFrame& frame)
{
    vtkUniforms* uniforms = actor.GetShaderProperty()->GetVertexCustomUniforms();
    const auto inView = [&](const Vec3& v_W) {
        return Vec3(v_W.dot(frame.right_W), v_W.dot(frame.up_W), v_W.dot(frame.back_W));
    };
    // The two world axes most nearly tangential to the surface: the grid is fixed to the tissue, not to the finger.
    int up = 0;
    dimple.n_W.cwiseAbs().maxCoeff(&up);
    const Vec3 u_W = Vec3::Unit((up + 1) % 3), v_W = Vec3::Unit((up + 2) % 3);
    const double spacing = gridSpacing_mm(frame.mmPerPixel(dimple.p_W));
    const auto inGrid = [&](const Vec3& axis_W) {
        const double place = dimple.p_W.dot(axis_W) / spacing;
        return static_cast<float>(place - std::floor(place));
    };
    const float grid[3] = {static_cast<float>(spacing), inGrid(u_W), inGrid(v_W)};
    const float press[4] = {
        static_cast<float>(dimple.depth_mm), static_cast<float>(dimple.radius_mm / std::numbers::pi),
        static_cast<float>(Dimple::kFadeFrom * dimple.radius_mm), static_cast<float>(Dimple::kTo * dimple.radius_mm)};
    uniforms->SetUniform3f("dimpleAt", floats(inView(dimple.p_W - frame.eye_W)).data());
    uniforms->SetUniform3f("dimpleInward", floats(inView(-dimple.n_W)).data());
    uniforms->SetUniform3f("dimpleGridU", floats(inView(u_W)).data());
    uniforms->SetUniform3f("dimpleGridV", floats(inView(v_W)).data());
    uniforms->SetUniform3f("dimpleGrid", grid);
    uniforms->SetUniform4f("dimplePress", press);
}

} // namespace palpate::view
