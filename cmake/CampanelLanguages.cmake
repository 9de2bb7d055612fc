# SPDX-License-Identifier: Apache-2.0
# The languages of the panel: app/i18n/campanel_app_<code>.ts and qml/i18n/campanel_qml_<code>.ts become one file, campanel_<code>.qm, in
# share/campanel/languages beside the programs. A language is added by its two files alone, so they are not listed.
find_package(Qt6 6.4 REQUIRED COMPONENTS LinguistTools)

file(GLOB CAMPANEL_LANGUAGES RELATIVE ${PROJECT_SOURCE_DIR}/app/i18n CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/app/i18n/campanel_app_*.ts)
list(TRANSFORM CAMPANEL_LANGUAGES REPLACE "campanel_app_(.+)\\.ts" "\\1")

set(languages)
foreach(code IN LISTS CAMPANEL_LANGUAGES)
    set(texts ${PROJECT_SOURCE_DIR}/app/i18n/campanel_app_${code}.ts ${PROJECT_SOURCE_DIR}/qml/i18n/campanel_qml_${code}.ts)
    set(language ${CMAKE_BINARY_DIR}/share/campanel/languages/campanel_${code}.qm)
    add_custom_command(OUTPUT ${language}
        COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/share/campanel/languages
        COMMAND Qt6::lrelease -silent ${texts} -qm ${language}
        DEPENDS ${texts}
        VERBATIM)
    list(APPEND languages ${language})
endforeach()
add_custom_target(campanel_languages ALL DEPENDS ${languages})
install(FILES ${languages} DESTINATION ${CMAKE_INSTALL_DATADIR}/campanel/languages)

add_custom_target(update_translations
    COMMAND ${PROJECT_SOURCE_DIR}/app/i18n/update_translations $<TARGET_FILE:Qt6::lupdate>
    COMMENT "Bringing the texts of the sources into the .ts files"
    VERBATIM)
