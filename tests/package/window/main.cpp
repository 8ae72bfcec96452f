// SPDX-License-Identifier: BSD-3-Clause
#include <palpate/ui/Translated.h>
#include <palpate/view/SceneView.h>

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <cstdio>

/// Prints whether VTK's OpenGL classes are registered, which this program leaves to the library, and a translated
/// message.
int main()
{
    using namespace palpate;
    const auto window = vtkSmartPointer<vtkRenderWindow>::New();
    view::SceneView view;
    view.attach(*window);
    view.detach();
    std::printf("%s, %s\n", window->IsA("vtkOpenGLRenderWindow") != 0 ? "OpenGL" : window->GetClassName(),
                qPrintable(ui::translated(core::Message(PALPATE_TEXT("CPU %1"), 3))));
    return 0;
}
