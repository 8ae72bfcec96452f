// SPDX-License-Identifier: BSD-3-Clause
#include "database/JournalCheck.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>

namespace palpate::session::internal {

core::Status checkJournal(const std::filesystem::path& database)
{
    constexpr std::string_view kMagic{"\xd9\xd5\x05\xf9\x20\xa1\x63\xd7", 8};
    constexpr std::size_t kEnd = 16; // name length, name checksum, magic number
    std::error_code error;
    std::filesystem::path journal = std::filesystem::canonical(database, error); // as resolved by SQLite
    journal = error ? database : journal;
    journal += "-journal";
    const auto kind = std::filesystem::symlink_status(journal, error);
    if (!std::filesystem::exists(kind)) {
        return {};
    }
    if (!std::filesystem::is_regular_file(kind)) {
        return {core::StatusCode::BadFormat,
                PALPATE_TEXT("%1: found something else than a file, expected the journal of a recording; nothing was "
                             "opened. Move it away to read the recording as it is"),
                journal};
    }
    std::ifstream file(journal, std::ios::binary);
    std::array<char, kEnd> end{};
    file.seekg(-static_cast<std::streamoff>(kEnd), std::ios::end);
    if (!file.read(end.data(), kEnd)) {
        return {}; // too short for a name
    }
    const bool hasName = std::any_of(end.begin(), end.begin() + 4, [](char c) { return c != 0; });
    if (hasName && std::string_view(end.data() + 8, kMagic.size()) == kMagic) {
        return {core::StatusCode::BadFormat,
                PALPATE_TEXT("%1: found the journal of several databases, which names another file to be deleted; "
                             "Palpate writes none, so this was not made by Palpate; nothing was opened. Move it away "
                             "to read the recording as it is"),
                journal};
    }
    return {};
}

} // namespace palpate::session::internal
