# SPDX-License-Identifier: Apache-2.0
# Finds Qwt 6.3 for Qt 6 and gives the target Qwt::Qwt. Looked for, in this order: CAMPANEL_QWT_PREFIX (cache or environment; then
# nowhere else), the static library that packaging/qwt built for this user, the distribution's libqwt-qt6-dev. No pkg-config: the
# distribution's .pc file asks for Qt modules (Svg, OpenGL) that neither we nor its package bring.
# Nothing is cached, so that a new Qt or a new build of Qwt is seen by the next configure.
set(CAMPANEL_QWT_PREFIX "" CACHE PATH "Folder with Qwt for Qt 6 (include/ and lib/); empty: what packaging/qwt provides")

set(_prefix "${CAMPANEL_QWT_PREFIX}")
if(NOT _prefix)
    set(_prefix "$ENV{CAMPANEL_QWT_PREFIX}")
endif()
if(_prefix)
    set(_only NO_DEFAULT_PATH)
else()
    execute_process(COMMAND "${CMAKE_CURRENT_LIST_DIR}/../packaging/qwt" --prefix OUTPUT_VARIABLE _prefix ERROR_QUIET
        OUTPUT_STRIP_TRAILING_WHITESPACE)
    set(_only "")
endif()

set(QwtQt6_LIBRARY NOTFOUND)
set(QwtQt6_INCLUDE_DIR NOTFOUND)
if(_prefix)
    find_library(QwtQt6_LIBRARY NAMES qwt-qt6 qwt PATHS "${_prefix}/lib" "${_prefix}/lib/${CMAKE_LIBRARY_ARCHITECTURE}" NO_DEFAULT_PATH NO_CACHE)
    find_path(QwtQt6_INCLUDE_DIR NAMES qwt_global.h PATHS "${_prefix}/include" "${_prefix}/include/qwt" NO_DEFAULT_PATH NO_CACHE)
endif()
if(NOT QwtQt6_LIBRARY AND NOT _only)
    set(QwtQt6_INCLUDE_DIR NOTFOUND)
    find_library(QwtQt6_LIBRARY NAMES qwt-qt6 NO_CACHE)
    find_path(QwtQt6_INCLUDE_DIR NAMES qwt_global.h PATH_SUFFIXES qwt NO_CACHE)
endif()
if(QwtQt6_LIBRARY AND QwtQt6_INCLUDE_DIR)
    file(STRINGS "${QwtQt6_INCLUDE_DIR}/qwt_global.h" _line REGEX "define QWT_VERSION_STR")
    string(REGEX REPLACE ".*\"([0-9.]+)\".*" "\\1" QwtQt6_VERSION "${_line}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(QwtQt6 REQUIRED_VARS QwtQt6_LIBRARY QwtQt6_INCLUDE_DIR VERSION_VAR QwtQt6_VERSION REASON_FAILURE_MESSAGE
    "Run packaging/qwt, which installs or builds Qwt for Qt 6, or give its folder with -DCAMPANEL_QWT_PREFIX=FOLDER.")

if(QwtQt6_FOUND AND NOT TARGET Qwt::Qwt)
    # Imported, hence a system include: Qwt's headers raise no warnings here. Its classes derive from widgets; none is created.
    find_package(Qt6 REQUIRED COMPONENTS Widgets)
    add_library(Qwt::Qwt UNKNOWN IMPORTED)
    set_target_properties(Qwt::Qwt PROPERTIES IMPORTED_LOCATION "${QwtQt6_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${QwtQt6_INCLUDE_DIR}"
        INTERFACE_LINK_LIBRARIES Qt6::Widgets)
    if(QwtQt6_LIBRARY MATCHES "\\.a$")
        target_compile_definitions(Qwt::Qwt INTERFACE QWT_NO_SVG)
    endif()
endif()
foreach(_name _prefix _only _line)
    unset(${_name})
endforeach()
