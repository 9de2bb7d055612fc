# SPDX-License-Identifier: Apache-2.0
# GCC for an ARM7TDMI without operating system and without C library: ARMv4T, no floating point, functions that are not called left out.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_ASM_COMPILER arm-none-eabi-gcc)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(ARM7_FLAGS "-mcpu=arm7tdmi -mfloat-abi=soft -ffreestanding -fno-common -ffunction-sections -fdata-sections")
set(CMAKE_C_FLAGS_INIT "${ARM7_FLAGS} -isystem ${CMAKE_CURRENT_LIST_DIR}/include")
set(CMAKE_ASM_FLAGS_INIT "-mcpu=arm7tdmi")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib -Wl,--gc-sections -Wl,--fatal-warnings")
