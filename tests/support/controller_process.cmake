# SPDX-License-Identifier: Apache-2.0
# Target campanel_controller_process: tests link it to start the real controller program.
add_library(campanel_controller_process STATIC ${CMAKE_CURRENT_LIST_DIR}/controller_process.cpp ${CMAKE_CURRENT_LIST_DIR}/controller_process.h)
target_include_directories(campanel_controller_process PUBLIC ${CMAKE_SOURCE_DIR})
target_link_libraries(campanel_controller_process PUBLIC Qt6::Core PRIVATE campanel_warnings)
target_compile_definitions(campanel_controller_process PRIVATE CAMPANEL_CONTROLLER="$<TARGET_FILE:campanel-controller>")
add_dependencies(campanel_controller_process campanel-controller)
