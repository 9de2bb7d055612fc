// SPDX-License-Identifier: Apache-2.0
// A function with many local variables, for declarations_in_order.cmake.
import QtQml

QtObject {
    function sums(a: real, b: real): real {
        const c = a + b, d = a - b, e = a * b, f = c * d, g = d * e, h = e * f
        return a > b ? c + d * e - f * g + h : h - c * d + e * f - g
    }
}
