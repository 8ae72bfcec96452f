// SPDX-License-Identifier: BSD-3-Clause
#include "guard/OpenFile.h"

#include "text/Fault.h"

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>

namespace palpate::meshio::internal {

using core::StatusCode;

core::Status systemFault(std::string_view file, core::MessageText<core::Message> found)
{
    const int error = errno;
    return fault(error == ENOENT ? StatusCode::NotFound : StatusCode::Unreadable, file, {},
                 core::Message(found, core::systemError(error)), {PALPATE_TEXT("a readable file")});
}

core::Result<OpenFile> openFile(Descriptor descriptor, std::string_view file)
{
    struct stat info = {};
    if (descriptor.value() < 0 || ::fstat(descriptor.value(), &info) != 0) {
        return systemFault(file, PALPATE_TEXT("cannot be opened: %1"));
    }
    if (!S_ISREG(info.st_mode)) {
        return fault(StatusCode::Unreadable, file, {},
                     S_ISDIR(info.st_mode) ? core::Message(PALPATE_TEXT("is a folder"))
                                           : core::Message(PALPATE_TEXT("is not a regular file")),
                     {PALPATE_TEXT("a mesh file")});
    }
    return OpenFile{std::move(descriptor), static_cast<std::size_t>(info.st_size)};
}

core::Result<OpenFile> openFile(const std::filesystem::path& path)
{
    const std::filesystem::path name = path.filename(); // empty for a path that ends in a slash
    return openFile(Descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)),
                    name.empty() ? path.string() : name.string());
}

} // namespace palpate::meshio::internal
