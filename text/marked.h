// SPDX-License-Identifier: Apache-2.0
// Marks an English text for translation in a library without Qt. The target update_translations finds the
// mark by its name; the panel translates the text in that context.
#pragma once

#define CAMPANEL_TEXT(context, text) text
