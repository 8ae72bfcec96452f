// SPDX-License-Identifier: BSD-3-Clause
#include "LongCall.h"

namespace palpate::python {

bool handleSignals()
{
    const py::gil_scoped_acquire held;
    return PyErr_CheckSignals() == 0;
}

void throwIfRaised()
{
    if (PyErr_Occurred() != nullptr) {
        throw py::error_already_set();
    }
}

} // namespace palpate::python
