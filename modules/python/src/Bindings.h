// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

namespace palpate::python {

// Each adds classes and functions to the module, in this order: the later ones use the earlier ones' classes.
void bindSurface(pybind11::module_& module);
void bindScene(pybind11::module_& module);
void bindTouch(pybind11::module_& module);
void bindFelt(pybind11::module_& module);
void bindRecording(pybind11::module_& module);

} // namespace palpate::python
