// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::vendor {

/// Shared library of a device maker: where to look for it, and what to do when it is missing.
struct LibraryKind
{
    const char* plugin;                         ///< "forcedimension": prefix of each message
    std::vector<std::string> sonames;           ///< in order of preference: {"libdhd.so.3", "libdrd.so.3"}
    std::vector<std::filesystem::path> folders; ///< searched after the loader's own folders
    core::MessageText<> remedy;                 ///< next step when the library is missing or unsuitable
    std::vector<std::filesystem::path> trees;   ///< searched last, with their subfolders: an unpacked SDK
};

/// Shared library of a device maker, opened at run time, so that Palpate neither includes nor links anything of the
/// maker. Never unloaded: makers' libraries leave threads running and may fail when they are loaded a second time.
///
///     auto library = VendorLibrary::open(kind, settings.library);
///     if (library.isOk()) {
///         library.value().require("dhdOpenID", open).require("dhdClose", close); // pointers to functions
///         if (const Status status = library.value().status(); !status.isOk()) { ... }
///     }
///
/// @par Thread Any thread except the servo thread; one thread at a time.
class VendorLibrary
{
  public:
    /// Opens the library. The loader's folders (LD_LIBRARY_PATH, the system's) come first, under the name of each
    /// soname; then the folders and trees of `kind`, where a longer name is accepted as well: makers ship
    /// "libdhd.so.3.14.0" and leave the link "libdhd.so.3" to the user.
    /// @param named  path from the user's settings, opened instead of searching; empty: search
    /// @return NotFound: no such file; Unreadable: a file that cannot be loaded, with the loader's reason;
    /// BadCommandLine: `named` is relative
    [[nodiscard]] static core::Result<VendorLibrary> open(const LibraryKind& kind,
                                                          const std::filesystem::path& named = {});

    /// Resolves an entry point that the plugin cannot do without. `status` reports missing ones.
    /// @param function  set to the entry point, or to nullptr
    template<class Function>
    VendorLibrary& require(const char* name, Function*& function)
    {
        function = reinterpret_cast<Function*>(resolve(name));
        if (function == nullptr) {
            m_missing.emplace_back(name);
        }
        return *this;
    }
    /// Resolves an entry point that only some versions have.
    /// @param function  set to the entry point, or to nullptr
    template<class Function>
    VendorLibrary& find(const char* name, Function*& function)
    {
        function = reinterpret_cast<Function*>(resolve(name));
        return *this;
    }
    /// @return Mismatch with the first missing entry point and their number, if `require` missed any.
    [[nodiscard]] core::Status status() const;
    /// Error for a library whose version does not suit: "... is version 2.4, expected version 3; ...".
    [[nodiscard]] core::Status unsuitable(const std::string& found, const std::string& expected) const;

    /// Path of the loaded file, for messages.
    [[nodiscard]] const std::filesystem::path& file() const noexcept { return m_file; }

  private:
    VendorLibrary(const LibraryKind& kind, void* handle);
    [[nodiscard]] void* resolve(const char* name) const;

    const char* m_plugin;
    core::MessageText<> m_remedy;
    void* m_handle;
    std::filesystem::path m_file;
    std::vector<std::string> m_missing; ///< names of required entry points
};

} // namespace palpate::vendor
