# SPDX-License-Identifier: Apache-2.0
# The compilation of sources: warnings, unity builds, precompiled headers, a compiler cache.

# The interface target with the warning flags; every target of ours links it PRIVATE.
add_library(campanel_warnings INTERFACE)
target_compile_options(campanel_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wdouble-promotion -Wformat=2
    $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor -Woverloaded-virtual -Wextra-semi>
    $<$<COMPILE_LANGUAGE:C>:-Wstrict-prototypes -Wmissing-prototypes>
    $<$<BOOL:${CAMPANEL_WERROR}>:-Werror>)

# Headers take most of the time, so a compiler reads a dozen files at once. Preset `plain` compiles each file separately.
option(CMAKE_UNITY_BUILD "Compile several files of a target together" ON)
set(CMAKE_UNITY_BUILD_BATCH_SIZE 12)
# C files compile quickly, and the controller's core must compile like with other compilers.
function(campanel_compile_one_by_one target)
    set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
endfunction()

# campanel_precompile(TARGET HEADER...): creates a precompiled header for TARGET. campanel_precompile_as(TARGET OWNER): uses that of OWNER,
# which must have the same flags and no definitions that TARGET does not have.
function(campanel_precompile target)
    list(TRANSFORM ARGN REPLACE "^(.+)$" "<\\1>" OUTPUT_VARIABLE headers)
    target_precompile_headers(${target} PRIVATE ${headers})
endfunction()
function(campanel_precompile_as target owner)
    target_precompile_headers(${target} REUSE_FROM ${owner})
endfunction()
set(CAMPANEL_STANDARD_HEADERS algorithm array chrono cmath cstdint functional map memory optional span string string_view utility variant
    vector)
set(CAMPANEL_QT_HEADERS ${CAMPANEL_STANDARD_HEADERS}
    QAbstractListModel QByteArray QCoreApplication QDateTime QDir QFile QHash QJsonArray QJsonDocument QJsonObject QList QLocale QMap
    QObject QPointF QSettings QString QStringList QThread QTimer QVariant tl/expected.hpp)

# ccache, if it is installed. Paths below the source folder are ignored, except for those that CMake writes into unity files.
find_program(CAMPANEL_CCACHE ccache)
mark_as_advanced(CAMPANEL_CCACHE)
if(CAMPANEL_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_C_COMPILER_LAUNCHER env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1
        CCACHE_SLOPPINESS=pch_defines,time_macros ${CAMPANEL_CCACHE})
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_C_COMPILER_LAUNCHER})
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>)
    endif()
endif()
