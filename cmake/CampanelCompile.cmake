# SPDX-License-Identifier: Apache-2.0
# How sources are compiled: warnings, several files together, precompiled headers, a compiler cache.

# The one interface target that carries the warning flags; every target of ours links it PRIVATE.
add_library(campanel_warnings INTERFACE)
target_compile_options(campanel_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wdouble-promotion -Wformat=2
    $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor -Woverloaded-virtual -Wextra-semi>
    $<$<COMPILE_LANGUAGE:C>:-Wstrict-prototypes -Wmissing-prototypes>
    $<$<BOOL:${CAMPANEL_WERROR}>:-Werror>)

# Most of the time goes into headers, so a compiler reads a dozen files at once. Preset `plain` compiles each by itself.
option(CMAKE_UNITY_BUILD "Compile several files of a target together" ON)
set(CMAKE_UNITY_BUILD_BATCH_SIZE 12)
# A C file costs nothing, and the controller's core stays as other compilers see it.
function(campanel_compile_one_by_one target)
    set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
endfunction()

# campanel_precompile(TARGET HEADER...): TARGET makes a precompiled header of these. campanel_precompile_as(TARGET OWNER): it
# takes OWNER's, which must be compiled with the same flags and with no definitions that TARGET has not got.
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

# ccache, where it is installed. Paths below the source folder do not count, but for those that CMake writes into unity files.
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
