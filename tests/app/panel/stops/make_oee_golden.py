#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Makes oee_golden.csv with the package oee 0.2.0 (https://pypi.org/project/oee), for test_oee.cpp, which needs no
# Python itself:
#   python3 -m venv oee && oee/bin/pip install oee==0.2.0 && oee/bin/python make_oee_golden.py > oee_golden.csv
# The 1000 shifts come from std::minstd_rand with one seed, which test_oee.cpp repeats draw by draw.
import oee

SHIFTS = 1000
SEED = 20261124


class Random:
    """std::minstd_rand"""

    def __init__(self, seed):
        self.state = seed

    def below(self, bound):
        self.state = self.state * 48271 % 2147483647
        return self.state % bound


def shift(random):
    """Returns the runs, and the downtimes by their kinds, as random_shifts.h makes its intervals."""
    runs, stops = [], []
    for _ in range(2 + random.below(8)):
        run_ms = 1000 + random.below(900_000)
        ideal = 20 + random.below(280)
        share = random.below(110)
        pieces = run_ms * ideal // 60_000 * share // 100
        out = random.below(1 + pieces // 10)
        scrap = random.below(4) if pieces > 20 else 0
        skipped = random.below(1 + pieces // 20)
        runs.append((run_ms, ideal, pieces, min(out, pieces), min(scrap, pieces - min(out, pieces)), skipped))
        stops.append((1000 + random.below(300_000), random.below(3) == 0))
    return runs, stops


random = Random(SEED)
print("availability,performance,quality,oee")
for _ in range(SHIFTS):
    runs, stops = shift(random)
    planned_stops = sum(ms for ms, planned in stops if planned)
    length = sum(run[0] for run in runs) + sum(ms for ms, _ in stops)
    if sum(run[2] + run[5] for run in runs) == 0:
        print("none")
        continue
    result = oee.from_log(
        length - planned_stops,
        runs=[{"count": pieces + skipped, "reject": out + scrap + skipped, "ideal_cycle_time": 60_000 / ideal}
              for _, ideal, pieces, out, scrap, skipped in runs],
        downtime_events=[{"duration": ms, "reason": "stop"} for ms, planned in stops if not planned])
    print(f"{result.availability:.12f},{result.performance:.12f},{result.quality:.12f},{result.oee:.12f}")
