// SPDX-License-Identifier: BSD-3-Clause
#include "surfaces/ArrayShader.h"

#include <vtkDataObject.h>
#include <vtkPolyDataMapper.h>
#include <vtkShaderProperty.h>

namespace palpate::view {

namespace {

constexpr const char* kShaded = "shaded"; // the array in the vertex program

} // namespace

void shadeByArray(vtkActor& actor, const char* array, int components, const std::string& fragment)
{
    auto* mapper = vtkPolyDataMapper::SafeDownCast(actor.GetMapper());
    vtkShaderProperty* shader = actor.GetShaderProperty();
    const std::string type = components == 1 ? "float" : "vec2";
    shader->AddVertexShaderReplacement(
        "//VTK::Normal::Dec", true,
        "//VTK::Normal::Dec\n  in " + type + " shaded;\n  out " + type + " shadedVSOutput;\n", false);
    shader->AddVertexShaderReplacement("//VTK::Normal::Impl", true, "//VTK::Normal::Impl\n  shadedVSOutput = shaded;\n",
                                       false);
    shader->AddFragmentShaderReplacement("//VTK::Normal::Dec", true,
                                         "//VTK::Normal::Dec\n  in " + type + " shadedVSOutput;\n", false);
    mapper->MapDataArrayToVertexAttribute(kShaded, array, vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
    shader->AddFragmentShaderReplacement("//VTK::Color::Impl", true, fragment, false);
}

void removeArrayShader(vtkActor& actor)
{
    vtkPolyDataMapper::SafeDownCast(actor.GetMapper())->RemoveVertexAttributeMapping(kShaded);
    vtkShaderProperty* shader = actor.GetShaderProperty();
    shader->ClearVertexShaderReplacement("//VTK::Normal::Dec", true);
    shader->ClearVertexShaderReplacement("//VTK::Normal::Impl", true);
    shader->ClearFragmentShaderReplacement("//VTK::Normal::Dec", true);
    shader->ClearFragmentShaderReplacement("//VTK::Color::Impl", true);
}

} // namespace palpate::view
