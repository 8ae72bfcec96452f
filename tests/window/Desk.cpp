// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "TestRunner.h"

#include <palpate/ui/VtkViewport.h>

#include <QAbstractScrollArea>
#include <QAction>
#include <QApplication>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QSurfaceFormat>

#include <fstream>
#include <string>

namespace palpate::test {

Desk::Desk()
{
    QStandardPaths::setTestModeEnabled(true);
    qputenv("HOME", m_folder.path().toUtf8()); // location of documents and pictures
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
    QSettings().setValue(QStringLiteral("fingertip_mm"), 0.0); // a point, whose forces are known in closed form
    QSurfaceFormat::setDefaultFormat(ui::VtkViewport::surfaceFormat());
}

bool Desk::hasDisplay()
{
    return QGuiApplication::platformName() == QStringLiteral("xcb");
}

bool Desk::show(QSize size)
{
    close();
    m_window = std::make_unique<MainWindow>();
    m_window->resize(size);
    m_window->show();
    m_window->activateWindow();
    // Only an active window receives keys, and activation follows some time after exposure.
    return QTest::qWaitForWindowExposed(m_window.get(), kPatience_ms) &&
           QTest::qWaitForWindowActive(m_window.get(), kPatience_ms);
}

bool Desk::open(const std::vector<std::filesystem::path>& files)
{
    QSignalSpy ready(m_window.get(), &MainWindow::ready);
    m_window->open(files);
    return QTest::qWaitFor([&] { return ready.count() > 0; }, kPatience_ms);
}

bool Desk::openPhantom()
{
    const std::filesystem::path phantom = folder() / "phantom"; // a copy: the window may save the scene
    std::error_code error;
    std::filesystem::copy(std::filesystem::path(PALPATE_SOURCE_DIR) / "data" / "phantom", phantom,
                          std::filesystem::copy_options::overwrite_existing | std::filesystem::copy_options::recursive,
                          error);
    return !error && open({phantom / "phantom.palpate.json", phantom / "palpation.palpate"});
}

void Desk::close()
{
    m_window.reset();
}

QAction& Desk::command(const char* id)
{
    return m_window->commands().at(id);
}

void Desk::press(Qt::Key key, Qt::KeyboardModifiers modifiers)
{
    QWidget* focus = m_window->focusWidget();
    QTest::keyClick(focus != nullptr ? focus : m_window.get(), key, modifiers);
}

void Desk::pressKeyOf(const char* id)
{
    const QKeyCombination key = command(id).shortcut()[0];
    press(key.key(), key.keyboardModifiers());
}

QImage Desk::picture()
{
    return m_window->grab().toImage();
}

std::filesystem::path Desk::writeStl(const char* name, const geometry::TriangleMesh& mesh) const
{
    const std::filesystem::path path = folder() / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream out(path, std::ios::binary);
    const auto put = [&out](auto value) { out.write(reinterpret_cast<const char*>(&value), sizeof value); };
    out << std::string(80, ' ');
    put(static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const geometry::Triangle& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            put(0.0F); // normals are computed, not read
        }
        for (const std::uint32_t corner : t) {
            for (const double v : mesh.vertices[corner]) {
                put(static_cast<float>(v));
            }
        }
        put(std::uint16_t{0});
    }
    return path;
}

bool isScrolled(const QWidget* widget)
{
    for (const QWidget* one = widget->parentWidget(); one != nullptr; one = one->parentWidget()) {
        if (qobject_cast<const QAbstractScrollArea*>(one) != nullptr) {
            return true;
        }
    }
    return false;
}

} // namespace palpate::test
