/* SPDX-License-Identifier: Apache-2.0 */
#include "bench_target.h"

int main(void)
{
    bench_open();
    bench_exit(bench_run(bench_number()) == 0);
    return 0;
}
