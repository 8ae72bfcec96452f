// SPDX-License-Identifier: BSD-3-Clause
// Nothing: it goes with the precompiled headers of the tests, which need a source to be compiled for.
