// SPDX-License-Identifier: BSD-3-Clause
#include "Bindings.h"
#include "Errors.h"

#include <palpate/session/Recording.h>

PYBIND11_MODULE(_palpate, module)
{
    using namespace palpate;
    module.doc() = "Palpate's engine: see the package palpate.";
    module.attr("__version__") = session::palpateVersion();
    python::bindErrors(module);
    python::bindSurface(module);
    python::bindScene(module);
    python::bindTouch(module);
    python::bindFelt(module);
    python::bindRecording(module);
}
