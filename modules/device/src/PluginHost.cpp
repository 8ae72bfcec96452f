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
std::optional<std::string> exposure(const std::filesystem::path& path, bool mayShare)
{
    struct stat found
    {
    };
    if (::stat(path.c_str(), &found) != 0) {
        return std::nullopt; // e.g. a broken link, which cannot be loaded either
    }
    if (found.st_uid != 0 && found.st_uid != ::geteuid()) {
        return path.string() + " belongs to another user; expected it to belong to you or to root";
    }
    const bool isShared = mayShare && (found.st_mode & S_ISVTX) != 0;
    if ((found.st_mode & (S_IWGRP | S_IWOTH)) != 0 && !isShared) {
        return "others may write to " + path.string() + "; take that right away with: chmod go-w '" + path.string() +
               "'";
    }
    return std::nullopt;
}

/// As `exposure`, for a plugin file and all its parent folders. @param file  canonical
std::optional<std::string> exposureOf(const std::filesystem::path& file)
{
    std::optional<std::string> found = exposure(file, false);
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
    const auto refuse = [&](StatusCode code, const std::string& why) {
        entry.status = Status(code, file.string() + ": skipped, " + why);
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
        return refuse(StatusCode::BadFormat, "it is no Qt plugin");
    }
    const QString iid = all.value(QLatin1String("IID")).toString();
    const QJsonObject own = all.value(QLatin1String("MetaData")).toObject();
    const auto text = [&own](const char* key) { return own.value(QLatin1String(key)).toString().toStdString(); };
    entry.info = {text("id"),      text("name"),   text("version"),
                  text("license"), text("drives"), own.value(QLatin1String("apiVersion")).toInt()};
    const QString family = QStringLiteral(PALPATE_DEVICE_PLUGIN_IID).section(QLatin1Char('/'), 0, 0);
    if (iid.section(QLatin1Char('/'), 0, 0) != family) {
        return refuse(StatusCode::Mismatch, "it is a plugin for something else: found \"" + iid.toStdString() +
                                                "\", expected \"" PALPATE_DEVICE_PLUGIN_IID "\"");
    }
    if (iid != QLatin1String(PALPATE_DEVICE_PLUGIN_IID)) {
        return refuse(StatusCode::Mismatch, "it was built for device API " +
                                                iid.section(QLatin1Char('/'), 1).toStdString() + ", this program has " +
                                                std::to_string(kDeviceApiVersion) +
                                                "; build it anew against this version");
    }
    if (entry.info.apiVersion != kDeviceApiVersion) {
        return refuse(StatusCode::Mismatch, "its metadata's apiVersion is " + std::to_string(entry.info.apiVersion) +
                                                ", expected " + std::to_string(kDeviceApiVersion) +
                                                ", which it is built for: correct its plugin.json and build it anew");
    }
    if (!isPlainId(entry.info.id)) {
        return refuse(StatusCode::BadFormat,
                      "its metadata's id is \"" + entry.info.id + "\", expected small letters, digits and dashes");
    }
    if (std::find(std::begin(kBuiltIn), std::end(kBuiltIn), entry.info.id) != std::end(kBuiltIn)) {
        return refuse(StatusCode::Mismatch, "its id \"" + entry.info.id + "\" is that of a built-in device");
    }
    for (const char* key : {"name", "version", "license", "drives"}) {
        if (text(key).empty()) {
            return refuse(StatusCode::BadFormat, std::string("its metadata has no ") + key);
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
                    Status(StatusCode::Mismatch, file.string() + ": skipped, " + same->file.string() + " comes first");
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
    for (const PluginEntry& entry : m_plugins) {
        found += entry.status.isOk() ? (found.empty() ? "" : ", ") + entry.info.id : "";
    }
    return Status(StatusCode::NotFound, "no device plugin is called \"" + std::string(id) +
                                            "\"; found: " + (found.empty() ? "none" : found) +
                                            " (\"palpate devices\" lists the built-in ones, too)");
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
        return Status(StatusCode::Internal, std::string(id) + ": " + error.what());
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
        return Status(StatusCode::Internal, std::string(id) + ": " + error.what());
    }
}

} // namespace palpate::device
