// SPDX-License-Identifier: BSD-3-Clause
// Empty: a source for compiling the precompiled headers of the tests.
