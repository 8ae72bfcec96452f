// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/servo/TickRecord.h>

#include <string>
#include <string_view>

namespace palpate::session::internal {

/// Returns the contact described by a tick's own columns: the outermost layer with the total force; friction according
/// to the flags.
/// @pre the tick is in contact
[[nodiscard]] haptics::Contact ownContact(const servo::TickRecord& tick);

/// Packs the contacts for the column `layers` of resources/docs/recording.md. @return empty without contact, or if
/// `ownContact` describes all contacts bit for bit
[[nodiscard]] std::string packLayers(const servo::TickRecord& tick);

/// Restores a tick's contacts from the column `layers` and its own columns. The depth of a contact is the length of its
/// spring, or, for structures that share a layer, its component along the structure's normal.
/// @param layers  output of packLayers
/// @return false for an invalid format or numbers beyond Bounds.h; the contact then follows the tick's own columns
bool unpackLayers(std::string_view layers, servo::TickRecord& tick);

/// Returns true if the contacts are equal bit for bit. Ignores the sign of zero force components, which cannot be
/// restored from the stored sum over the layers. Depths are derived from the rest.
[[nodiscard]] bool sameContacts(const haptics::TickResult& a, const haptics::TickResult& b);

} // namespace palpate::session::internal
