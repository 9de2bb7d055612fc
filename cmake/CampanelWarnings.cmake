# SPDX-License-Identifier: Apache-2.0
# The one interface target that carries the warning flags; every target of ours links it PRIVATE.
add_library(campanel_warnings INTERFACE)
target_compile_options(campanel_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wdouble-promotion -Wformat=2
    $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor -Woverloaded-virtual -Wextra-semi>
    $<$<COMPILE_LANGUAGE:C>:-Wstrict-prototypes -Wmissing-prototypes>
    $<$<BOOL:${CAMPANEL_WERROR}>:-Werror>)
