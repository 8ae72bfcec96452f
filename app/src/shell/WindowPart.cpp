// SPDX-License-Identifier: BSD-3-Clause
#include "shell/WindowPart.h"

#include "moc_WindowPart.cpp"
