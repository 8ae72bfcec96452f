// SPDX-License-Identifier: BSD-3-Clause
#include "window/Window.h"

#include "shared/Console.h"
#include "shared/Devices.h"
#include "shared/QtSetup.h"
#include "shell/Language.h"
#include "window/MainWindow.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/core/VisibleText.h>
#include <palpate/ui/PalpationController.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/Theme.h>
#include <palpate/ui/VtkViewport.h>

#include <QApplication>
#include <QBuffer>
#include <QFile>
#include <QFileDevice>
#include <QFileInfo>
#include <QFont>
#include <QOpenGLContext>
#include <QPainter>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>

#include <cstdio>
#include <filesystem>
#include <memory>

using namespace palpate;

namespace {

constexpr int kSettle_ms = 1400; // until panels, refined picture and servo loop have settled
constexpr int kPress_ms = 1200;  // until the scripted hand is in contact and has slid
constexpr int kGiveUp_ms = 120000;

/// Touches the opened scene and takes the screenshot.
class ScreenshotRun : public QObject
{
  public:
    ScreenshotRun(MainWindow& window, QString file)
        : m_window(window)
        , m_file(std::move(file))
    {
        connect(&window, &MainWindow::ready, this,
                [this] { QTimer::singleShot(kSettle_ms, this, [this] { touch(); }); });
        connect(&window, &MainWindow::openFailed, this, [](const QString& line) {
            std::fprintf(stderr, "%s\n", core::visible(line.toStdString()).c_str());
            QCoreApplication::exit(2);
        });
        connect(&window, &MainWindow::deviceRefused, this, [](const QString& line) {
            std::fprintf(stderr, "%s\n", core::visible(line.toStdString()).c_str());
            QCoreApplication::exit(2);
        });
        QTimer::singleShot(kGiveUp_ms, this, [] {
            app::printError(PALPATE_TEXT("no picture after %1 s"), kGiveUp_ms / 1000);
            QCoreApplication::exit(1);
        });
    }

  private:
    void touch()
    {
        if (!m_window.usesPointer()) {
            waitForDevice();
            return;
        }
        ui::Playback& playback = m_window.playback();
        if (playback.recording() != nullptr) {
            // Seeks to shortly before the moment of greatest force and plays up to it.
            playback.seek(std::max(0.0, playback.peakTime_s() - 0.3));
            playback.play();
            QTimer::singleShot(300, this, [this] {
                m_window.playback().pause();
                m_window.playback().seek(m_window.playback().peakTime_s());
                QTimer::singleShot(kSettle_ms, this, [this] { shoot(); });
            });
            return;
        }
        if (const auto place = m_window.viewport().palpablePlace()) {
            m_place = *place;
            m_window.setPalpating(true);
            m_window.palpation().pressAt(m_place);
            auto* slide = new QTimer(this);
            connect(slide, &QTimer::timeout, this, [this] {
                m_place += QPointF(0.5, 0.25);
                m_window.palpation().moveTo(m_place);
            });
            slide->start(30);
            QTimer::singleShot(kPress_ms, this, [this, slide] {
                slide->stop();
                QTimer::singleShot(kSettle_ms, this, [this] { shoot(); });
            });
            return;
        }
        shoot();
    }

    /// Takes the screenshot when the device's hand has been in contact for a while.
    void waitForDevice()
    {
        auto* look = new QTimer(this);
        connect(look, &QTimer::timeout, this, [this, look, pressed = 0]() mutable {
            constexpr int kPressed = 10;
            pressed = m_window.viewport().view().cursor().state().isInContact ? pressed + 1 : 0;
            if (pressed >= kPressed) {
                look->stop();
                shoot();
            }
        });
        look->start(100);
    }

    void shoot()
    {
        m_window.viewport().refineNext();
        const QPixmap picture = m_window.grab();
        const view::TouchState& state = m_window.viewport().view().cursor().state();
        QBuffer bytes;
        (void)picture.save(&bytes, "PNG");
        const core::Status written = core::writeAtomically(
            m_file.toStdU16String(), {bytes.data().constData(), static_cast<std::size_t>(bytes.size())});
        if (!written.isOk()) {
            QCoreApplication::exit(app::report(written));
            return;
        }
        if (state.isInContact) {
            app::print("%s: %dx%d, in contact, %.2f N, %.1f mm deep\n", m_file.toUtf8().constData(), picture.width(),
                       picture.height(), state.f_W.norm(), (state.p_WG - state.p_WH).norm());
        } else {
            app::print("%s: %dx%d, not in contact\n", m_file.toUtf8().constData(), picture.width(), picture.height());
        }
        std::fflush(stdout);
        QCoreApplication::exit(0);
    }

    MainWindow& m_window;
    QString m_file;
    QPointF m_place;
};

/// Temporary settings folder. Used if the settings file is a pipe, on which Qt would block forever, or a link, whose
/// target Qt would write to. Deleted with the object.
class SettingsFolder
{
  public:
    SettingsFolder()
    {
        const QString folder = QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation);
        const QString own = QCoreApplication::organizationName();
        for (const QString& file : {folder + QLatin1Char('/') + own + QStringLiteral(".conf"),
                                    folder + QLatin1Char('/') + own + QLatin1Char('/') +
                                        QCoreApplication::applicationName() + QStringLiteral(".conf")}) {
            std::error_code error;
            const auto kind = std::filesystem::symlink_status(file.toStdU16String(), error).type();
            if (kind == std::filesystem::file_type::regular || kind == std::filesystem::file_type::not_found) {
                continue;
            }
            m_own = std::make_unique<QTemporaryDir>();
            QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_own->path());
            app::printError(PALPATE_TEXT("%1: found a link, pipe or other special file, expected a file of settings; "
                                         "they are not kept. Remove it"),
                            file.toStdString());
            return;
        }
    }

  private:
    std::unique_ptr<QTemporaryDir> m_own;
};

/// Returns whether the environment offers a display; without a display, Qt aborts the program.
bool hasDisplay()
{
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
        if (!qEnvironmentVariableIsEmpty(name)) {
            return true;
        }
    }
    return QFileInfo::exists(qEnvironmentVariable("XDG_RUNTIME_DIR") + QStringLiteral("/wayland-0"));
}

} // namespace

int runWindow(int argc, char** argv, const WindowOptions& options)
{
    if (!hasDisplay()) {
        app::printError(PALPATE_TEXT("found no display (DISPLAY is not set), expected one for the window; app/run.sh "
                                     "draws without"));
        return app::kFailed;
    }
    app::useUtf8();
    const app::RuntimeFolder runtimeFolder;
    QSurfaceFormat::setDefaultFormat(ui::VtkViewport::surfaceFormat());
    QApplication application(argc, argv);
    if (!QOpenGLContext().create()) { // without OpenGL, an OpenGL widget crashes
        app::printError(
            PALPATE_TEXT("the display (%1) has no OpenGL, expected one that has; app/run.sh draws without a "
                         "display"),
            QGuiApplication::platformName().toStdString());
        return app::kFailed;
    }
    QCoreApplication::setOrganizationName(QStringLiteral("Palpate"));
    QCoreApplication::setApplicationName(options.screenshot ? QStringLiteral("Palpate screenshot")
                                                            : QStringLiteral("Palpate"));
    app::identifyProgram();
    const SettingsFolder settingsFolder;
    app::applyChosenLanguage();
    ui::setViewFont(app::boldFontFile(QApplication::font()));

    MainWindow window;
    if (options.darkPalette) {
        window.looks().use(ui::Theme::Dark);
    }
    std::unique_ptr<ScreenshotRun> run;
    if (options.screenshot) {
        run = std::make_unique<ScreenshotRun>(window, QString::fromStdU16String(options.screenshot->u16string()));
        window.resize(options.screenshotWidth, options.screenshotHeight);
    }
    window.setPlugins(app::findPlugins(options.pluginFolders));
    if (options.cpu) {
        window.useCpu(*options.cpu);
    }
    if (!options.device.empty()) {
        window.chooseDevice(options.device);
    }
    window.show();
    if (!options.files.empty()) {
        window.open(options.files, options.read);
    } else if (options.screenshot) {
        QTimer::singleShot(kSettle_ms, &window, [&window] { Q_EMIT window.ready(); });
    }
    return QApplication::exec();
}
