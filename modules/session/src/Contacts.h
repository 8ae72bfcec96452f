// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/servo/TickRecord.h>

#include <string>
#include <string_view>

namespace palpate::session::internal {

/// The one contact that a tick's own columns tell of.
/// @return the outermost layer, with all of the force; friction as the flags say
/// @pre the tick touches something
[[nodiscard]] haptics::Contact ownContact(const servo::TickRecord& tick);

/// The column `layers` of resources/docs/recording.md. @return empty where `ownContact` is all there are, bit for bit,
/// or nothing is touched
[[nodiscard]] std::string packLayers(const servo::TickRecord& tick);

/// Fills a tick's contacts from the column `layers` and its own columns; each depth is the length of its spring,
/// or where structures share a layer its part along the structure's normal.
/// @param layers  what packLayers made
/// @return false for another form, or numbers beyond Bounds.h; the contact is then what the tick's own columns say
bool unpackLayers(std::string_view layers, servo::TickRecord& tick);

/// @return true for the same contacts, bit for bit but for the sign of a zero in a share of the force: the sum over the
/// layers, which a tick keeps, has none to give back. Depths follow from the rest.
[[nodiscard]] bool sameContacts(const haptics::TickResult& a, const haptics::TickResult& b);

} // namespace palpate::session::internal
