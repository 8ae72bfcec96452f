// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/device/PluginHost.h"

#include "PluginProbe.h"

#include <QJsonObject>
#include <QPluginLoader>
#include <QStandardPaths>

#include <algorithm>
#include <exception>
#include <optional>
#include <system_error>
#include <utility>

#include <sys/stat.h>
#include <unistd.h>

namespace palpate::device {

using core::Status;
using core::StatusCode;

namespace {

constexpr std::string_view kBuiltIn[] = {"mouse", "simulated", "playback"};

std::filesystem::path toPath(const QString& text)
{
    return std::filesystem::path(text.toStdU16String());
}

bool isPlainId(const std::string& id)
{
    return !id.empty() && id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
}

/// Describes how users other than root and the current user could replace a file or folder.
/// @param mayShare  accept write access by others if the sticky bit prevents renaming of foreign files, as in /tmp
std::optional<core::Message> exposure(const std::filesystem::path& path, bool mayShare)
{
    struct stat found
    {
    };
    if (::stat(path.c_str(), &found) != 0) {
        return std::nullopt; // e.g. a broken link, which cannot be loaded either
    }
    if (found.st_uid != 0 && found.st_uid != ::geteuid()) {
        return core::Message(PALPATE_TEXT("%1 belongs to another user, expected you or root as its owner"), path);
    }
    const bool isShared = mayShare && (found.st_mode & S_ISVTX) != 0;
    if ((found.st_mode & (S_IWGRP | S_IWOTH)) != 0 && !isShared) {
        return core::Message(PALPATE_TEXT("others may write to %1; remove this permission with: chmod go-w '%1'"),
                             path);
    }
    return std::nullopt;
}

/// As `exposure`, for a plugin file and all its parent folders. @param file  canonical
std::optional<core::Message> exposureOf(const std::filesystem::path& file)
{
    std::optional<core::Message> found = exposure(file, false);
    for (std::filesystem::path folder = file.parent_path(); !found; folder = folder.parent_path()) {
        found = exposure(folder, folder != file.parent_path());
        if (folder == folder.root_path()) {
            break;
        }
    }
    return found;
}

PluginEntry readEntry(const std::filesystem::path& file)
{
    PluginEntry entry;
    entry.file = file;
    const auto refuse = [&](StatusCode code, const core::Message& why) {
        entry.status = Status(code, PALPATE_TEXT("%1: skipped, %2"), file, why);
        return entry;
    };
    std::error_code error;
    const std::filesystem::path real = std::filesystem::canonical(file, error);
    if (const auto exposed = exposureOf(error ? file : real)) {
        return refuse(StatusCode::Unsupported, *exposed);
    }
    // Reads the metadata section without executing code.
    const QJsonObject all = QPluginLoader(QString::fromStdU16String(file.u16string())).metaData();
    if (all.isEmpty()) {
        return refuse(StatusCode::BadFormat, core::Message(PALPATE_TEXT("not a Qt plugin")));
    }
    const QString iid = all.value(QLatin1String("IID")).toString();
    const QJsonObject own = all.value(QLatin1String("MetaData")).toObject();
    const auto text = [&own](const char* key) { return own.value(QLatin1String(key)).toString().toStdString(); };
    entry.info = {text("id"),      text("name"),   text("version"),
                  text("license"), text("drives"), own.value(QLatin1String("apiVersion")).toInt()};
    const QString family = QStringLiteral(PALPATE_DEVICE_PLUGIN_IID).section(QLatin1Char('/'), 0, 0);
    if (iid.section(QLatin1Char('/'), 0, 0) != family) {
        return refuse(StatusCode::Mismatch,
                      core::Message(PALPATE_TEXT("a plugin of another program: found \"%1\", expected \"%2\""),
                                    iid.toStdString(), PALPATE_DEVICE_PLUGIN_IID));
    }
    if (iid != QLatin1String(PALPATE_DEVICE_PLUGIN_IID)) {
        return refuse(StatusCode::Mismatch,
                      core::Message(PALPATE_TEXT("built for device API %1, this program has %2; rebuild it against "
                                                 "this version"),
                                    iid.section(QLatin1Char('/'), 1).toStdString(), kDeviceApiVersion));
    }
    if (entry.info.apiVersion != kDeviceApiVersion) {
        return refuse(StatusCode::Mismatch,
                      core::Message(PALPATE_TEXT("found apiVersion %1 in its metadata, expected %2, which it was built "
                                                 "for; correct its plugin.json and rebuild it"),
                                    entry.info.apiVersion, kDeviceApiVersion));
    }
    if (!isPlainId(entry.info.id)) {
        return refuse(StatusCode::BadFormat,
                      core::Message(PALPATE_TEXT("found the id \"%1\" in its metadata, expected lowercase letters, "
                                                 "digits and dashes"),
                                    entry.info.id));
    }
    if (std::find(std::begin(kBuiltIn), std::end(kBuiltIn), entry.info.id) != std::end(kBuiltIn)) {
        return refuse(StatusCode::Mismatch,
                      core::Message(PALPATE_TEXT("its id \"%1\" belongs to a built-in device"), entry.info.id));
    }
    for (const char* key : {"name", "version", "license", "drives"}) {
        if (text(key).empty()) {
            return refuse(StatusCode::BadFormat, core::Message(PALPATE_TEXT("its metadata has no \"%1\""), key));
        }
    }
    return entry;
}

} // namespace

std::vector<std::filesystem::path> pluginFolders(const std::vector<std::filesystem::path>& named,
                                                 const std::filesystem::path& program)
{
    std::vector<std::filesystem::path> folders = named;
    const QString user = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
    if (toPath(user).is_absolute()) {
        folders.push_back(toPath(user) / "Palpate/plugins");
    }
    folders.push_back(program / "plugins");                    // build tree, or manual installation
    folders.push_back(program / ".." / PALPATE_PLUGIN_FOLDER); // regular installation
    return folders;
}

std::vector<std::filesystem::path> deviceSettingsFolders()
{
    std::vector<std::filesystem::path> folders;
    const QString settings = QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation);
    if (toPath(settings).is_absolute()) {
        folders.push_back(toPath(settings) / "Palpate");
    }
    const QString home = QStandardPaths::writableLocation(QStandardPaths::HomeLocation);
    if (toPath(home).is_absolute()) {
        folders.push_back(toPath(home));
    }
    return folders;
}

PluginHost::PluginHost(const std::vector<std::filesystem::path>& folders, std::vector<std::string> probe,
                       int probeTimeout_ms)
    : m_probe(std::move(probe))
    , m_probeTimeout_ms(probeTimeout_ms)
    , m_services{m_bus, deviceSettingsFolders()}
{
    std::vector<std::filesystem::path> seen;
    for (const std::filesystem::path& folder : folders) {
        std::vector<std::filesystem::path> files;
        std::error_code error;
        const std::filesystem::path real = std::filesystem::canonical(folder, error);
        if (error || std::find(seen.begin(), seen.end(), real) != seen.end()) {
            continue;
        }
        seen.push_back(real);
        for (std::filesystem::directory_iterator it(real, error), end; !error && it != end; it.increment(error)) {
            if (it->path().extension() == ".so") {
                files.push_back(it->path());
            }
        }
        std::sort(files.begin(), files.end());
        for (const std::filesystem::path& file : files) {
            PluginEntry entry = readEntry(file);
            const auto same = std::find_if(m_plugins.begin(), m_plugins.end(), [&](const PluginEntry& other) {
                return other.status.isOk() && other.info.id == entry.info.id;
            });
            if (entry.status.isOk() && same != m_plugins.end()) {
                entry.status =
                    Status(StatusCode::Mismatch, PALPATE_TEXT("%1: skipped, %2 has the same id and comes first"), file,
                           same->file);
            }
            m_plugins.push_back(std::move(entry));
        }
    }
    m_loaded.resize(m_plugins.size(), nullptr);
}

core::Result<DevicePlugin*> PluginHost::load(std::string_view id)
{
    const PluginEntry* skipped = nullptr;
    for (std::size_t i = 0; i < m_plugins.size(); ++i) {
        PluginEntry& entry = m_plugins[i];
        if (entry.info.id != id) {
            continue;
        }
        if (!entry.status.isOk()) {
            skipped = skipped == nullptr ? &entry : skipped;
            continue;
        }
        if (m_loaded[i] == nullptr) {
            if (!m_probe.empty()) {
                entry.status = runProbe(m_probe, entry.file, m_probeTimeout_ms);
            }
            if (entry.status.isOk()) {
                auto loaded = loadPlugin(entry.file);
                entry.status = loaded.status();
                m_loaded[i] = loaded.isOk() ? loaded.value() : nullptr;
            }
        }
        if (m_loaded[i] != nullptr) {
            return m_loaded[i];
        }
        return entry.status;
    }
    if (skipped != nullptr) {
        return skipped->status;
    }
    std::string found;
    std::string builtIn;
    const auto append = [](std::string& list, std::string_view next) {
        list.append(list.empty() ? "" : ", ").append(next);
    };
    for (const PluginEntry& entry : m_plugins) {
        if (entry.status.isOk()) {
            append(found, entry.info.id);
        }
    }
    for (const std::string_view name : kBuiltIn) {
        append(builtIn, name);
    }
    return Status(StatusCode::NotFound,
                  PALPATE_TEXT("found no device plugin called \"%1\", expected one of: %2 (the built-in devices %3 are "
                               "not plugins)"),
                  id, found.empty() ? "-" : found, builtIn);
}

core::Result<std::vector<FoundDevice>> PluginHost::find(std::string_view id)
{
    const auto plugin = load(id);
    if (!plugin.isOk()) {
        return plugin.status();
    }
    try {
        return plugin.value()->find(m_services);
    } catch (const std::exception& error) {
        return Status(StatusCode::Internal, PALPATE_TEXT("%1: %2"), id, error.what());
    }
}

core::Result<std::unique_ptr<HapticDevice>> PluginHost::make(std::string_view id, const std::string& address)
{
    const auto plugin = load(id);
    if (!plugin.isOk()) {
        return plugin.status();
    }
    try {
        return plugin.value()->make(m_services, address);
    } catch (const std::exception& error) {
        return Status(StatusCode::Internal, PALPATE_TEXT("%1: %2"), id, error.what());
    }
}

} // namespace palpate::device
