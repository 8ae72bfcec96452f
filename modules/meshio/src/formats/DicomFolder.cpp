// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/meshio/DicomFolder.h"

#include "formats/OtherFormats.h"
#include "text/Encoding.h"

#include <fstream>
#include <string>
#include <string_view>

namespace palpate::meshio {

core::Status dicomFolder(const std::filesystem::path& folder)
{
    constexpr int kMostFiles = 50, kDeepest = 4; // patient, study, series, images
    constexpr std::size_t kHead = 132;
    std::error_code error;
    int files = 0;
    const auto options = std::filesystem::directory_options::skip_permission_denied;
    for (std::filesystem::recursive_directory_iterator entry(folder, options, error), end; !error && entry != end;
         entry.increment(error)) {
        if (entry.depth() >= kDeepest) {
            entry.disable_recursion_pending();
        }
        std::error_code unknown;
        if (!entry->is_regular_file(unknown)) {
            continue;
        }
        if (++files > kMostFiles) {
            break;
        }
        std::string head(kHead, '\0');
        std::ifstream file(entry->path(), std::ios::binary);
        file.read(head.data(), static_cast<std::streamsize>(head.size()));
        head.resize(static_cast<std::size_t>(file.gcount()));
        if (internal::isDicom(head, entry->path().filename().string())) {
            const auto whole = folder.has_filename() ? folder : folder.parent_path();
            return internal::dicomFault(internal::utf8Of(whole.filename().string()),
                                        {PALPATE_TEXT("is a folder of DICOM images, which Palpate does not read")});
        }
    }
    return {};
}

} // namespace palpate::meshio
