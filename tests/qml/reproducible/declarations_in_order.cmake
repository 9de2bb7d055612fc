# SPDX-License-Identifier: Apache-2.0
# cmake -D CAMPANEL_QMLCACHEGEN=... -D WRAPPER=... -D IMPORTS=... -D FOLDER=... -P declarations_in_order.cmake
# The wrapper of the QML compiler (cmake/qmlcachegen.in) declares the local variables of a function in the order of the alphabet.
configure_file(${WRAPPER} ${FOLDER}/qmlcachegen @ONLY FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
execute_process(COMMAND ${FOLDER}/qmlcachegen --bare --resource-path /Sums.qml -I ${IMPORTS} --resource ${CMAKE_CURRENT_LIST_DIR}/sums.qrc
    -o ${FOLDER}/sums.cpp ${CMAKE_CURRENT_LIST_DIR}/Sums.qml COMMAND_ERROR_IS_FATAL ANY)

file(READ ${FOLDER}/sums.cpp generated)
string(REPLACE ";" ":" generated "${generated}")    # a semicolon would end an element of a list
string(REGEX MATCHALL "\n(bool|double) [a-z][0-9]+(_[0-9]+)?( = [^\n]*)?:" declarations "${generated}")
list(LENGTH declarations count)
if(count LESS 10)
    message(FATAL_ERROR "Only ${count} declarations are seen in ${FOLDER}/sums.cpp: this Qt writes them in another way, so see whether "
        "cmake/qmlcachegen.in still knows them")
endif()
set(in_order ${declarations})
list(SORT in_order)
if(NOT declarations STREQUAL in_order)
    message(FATAL_ERROR "Not in the order of the alphabet in ${FOLDER}/sums.cpp:${declarations}")
endif()
message(STATUS "${count} declarations, in order")
