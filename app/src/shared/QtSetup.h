// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QIcon>
#include <QTemporaryDir>

#include <memory>
#include <string>

class QFont;

namespace palpate::app {

/// Private runtime folder. Qt and its libraries expect a folder for sockets in XDG_RUNTIME_DIR. If the folder is
/// missing or belongs to another user, they print a warning and use a folder that anyone may have created. Deleted
/// with the object. Make it before the application object.
class RuntimeFolder
{
  public:
    RuntimeFolder();

  private:
    std::unique_ptr<QTemporaryDir> m_own;
};

/// Selects a UTF-8 encoding. With any other encoding in the locale, Qt prints a warning and switches to C.UTF-8.
/// Setting only LC_CTYPE here keeps the user's number and date formats. Call before making the application object.
void useUtf8();

/// Sets what desktops show of the program: icon, name and desktop entry (resources/desktop/palpate.desktop). Call after
/// making the application object.
void identifyProgram();

/// Icon of the program in 48 and 256 pixels.
[[nodiscard]] QIcon programIcon();

/// Finds the file of the bold font of a family, for texts in 3D views. @return empty if the family has none that
/// FreeType opens by its file name alone
[[nodiscard]] std::string boldFontFile(const QFont& font);

} // namespace palpate::app
