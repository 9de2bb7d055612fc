// SPDX-License-Identifier: Apache-2.0
// Nothing but the precompiled header of everything that uses Qt; see CampanelCompile.cmake.
