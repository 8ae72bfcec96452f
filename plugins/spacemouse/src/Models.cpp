// SPDX-License-Identifier: BSD-3-Clause
#include "Models.h"

namespace palpate::spacemouse {

namespace {

constexpr Model kModels[] = {
    {0x046d, 0xc603, "SpaceMouse Plus XT"},
    {0x046d, 0xc605, "CADman"},
    {0x046d, 0xc606, "SpaceMouse Classic"},
    {0x046d, 0xc621, "SpaceBall 5000"},
    {0x046d, 0xc623, "SpaceTraveler"},
    {0x046d, 0xc625, "SpacePilot"},
    {0x046d, 0xc626, "SpaceNavigator"},
    {0x046d, 0xc627, "SpaceExplorer"},
    {0x046d, 0xc628, "SpaceNavigator for Notebooks"},
    {0x046d, 0xc629, "SpacePilot Pro"},
    {0x046d, 0xc62b, "SpaceMouse Pro"},
    {0x256f, 0xc62e, "SpaceMouse Wireless (cable)"},
    {0x256f, 0xc62f, "SpaceMouse Wireless"},
    {0x256f, 0xc631, "SpaceMouse Pro Wireless (cable)"},
    {0x256f, 0xc632, "SpaceMouse Pro Wireless"},
    {0x256f, 0xc633, "SpaceMouse Enterprise"},
    {0x256f, 0xc635, "SpaceMouse Compact"},
    {0x256f, 0xc636, "SpaceMouse Module"},
    {0x256f, 0xc638, "SpaceMouse Pro Wireless (Bluetooth)"},
    {0x256f, 0xc63a, "SpaceMouse Wireless (2020)"},
    {0x256f, 0xc641, "SpaceMouse USB"},
    {0x256f, 0xc652, "3Dconnexion Universal Receiver"},
};

} // namespace

std::span<const Model> models() noexcept
{
    return kModels;
}

const Model* findModel(std::uint16_t vendor, std::uint16_t product) noexcept
{
    for (const Model& model : kModels) {
        if (model.vendor == vendor && model.product == product) {
            return &model;
        }
    }
    return nullptr;
}

} // namespace palpate::spacemouse
