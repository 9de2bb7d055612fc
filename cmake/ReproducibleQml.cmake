# SPDX-License-Identifier: Apache-2.0
# Makes the C++ that Qt generates from QML reproducible. Include it after find_package(Qt6 ... Qml), in the same folder or above.
get_target_property(CAMPANEL_QMLCACHEGEN Qt6::qmlcachegen LOCATION)
configure_file(${CMAKE_CURRENT_LIST_DIR}/qmlcachegen.in ${CMAKE_BINARY_DIR}/qmlcachegen @ONLY
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
get_target_property(configurations Qt6::qmlcachegen IMPORTED_CONFIGURATIONS)
foreach(configuration IN LISTS configurations)
    set_target_properties(Qt6::qmlcachegen PROPERTIES IMPORTED_LOCATION_${configuration} ${CMAKE_BINARY_DIR}/qmlcachegen)
endforeach()
