#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the images of two campanelctl: compare_images.py OLD NEW [COUNT] [SEED].

The image of a recipe is its bank, header and rows, as the controller gets it. Compared are its CRC-32, its rows, and
whether it is refused. The recipes: the default one of each kind with each of its laws and choices, then COUNT random
ones that OLD does not refuse (10000). For a change that moves a fact from one place to another, where OLD is the
command of the commit before. Ends with 1 when an image differs."""
import itertools
import json
import random
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

KINDS = ["rotary_cutter", "position_move", "speed_move", "point_cam", "press", "segment_cam"]
LAWS = ["cubic", "quintic", "polynomial_4567", "harmonic", "cycloidal", "modified_sine", "modified_trapezoid",
        "parabolic", "trapezoid", "s_curve", "exponential", "half_modified_sine"]
CHOICES = {"speed_law": LAWS, "law": LAWS, "ratios": ["hand", "gentle", "cool", "slow", "between"],
           "duration": ["given_time", "fastest", "over_distance"], "execution": ["cam_points", "intervals"],
           "ends": ["natural", "clamped", "periodic"], "master_ramp_shape": ["trapezoid", "s_curve"]}
PINNABLE = ["bag_length_mm", "rate_bags_per_min", "base_speed_mm_per_s", "film_speed_mm_per_s"]
COUNTS = ["knives", "gear_numerator", "gear_denominator", "pulses_per_motor_rev", "slices_per_ramp", "cam_points"]
OPTIONAL = {"contact_angle_deg": 30, "friction_nm": 0.1, "inertia_kg_cm2": 2, "max_torque_nm": 20, "rated_torque_nm": 9,
            "natural_frequency_hz": 40, "min_seal_time_ms": 40}


def run(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=False)


def image(program, recipe):
    """Returns (exit code, CRC-32, rows); without the latter two when the recipe is refused."""
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump(recipe, file)
        file.flush()
        result = run(program, "table", "--format", "json", file.name)
    if result.returncode not in (0, 1, 4):
        raise SystemExit(f"{program} ends with {result.returncode}: {result.stderr}")
    if result.returncode != 0:
        return (result.returncode,)
    table = json.loads(result.stdout)
    return 0, table["crc32"], table["rows"]


def examples(bases):
    """Yields the default recipes with every combination of their choices; combinations that no kind has are refused."""
    for base in bases:
        given = base["program"]
        keys = [key for key in CHOICES if key in given]
        for options in itertools.product(*(CHOICES[key] for key in keys)):
            recipe = json.loads(json.dumps(base))
            recipe["program"].update(zip(keys, options))
            yield recipe


def changed(random_number, key, value):
    if key in COUNTS:
        return max(1, round(value * random_number.uniform(0.7, 1.5)) + random_number.choice([0, 0, 0, 1, 3]))
    if value == 0 and key in OPTIONAL:
        return round(random_number.choice([0, OPTIONAL[key] * random_number.uniform(0.3, 2)]), 1)
    return round(value * random_number.uniform(0.75, 1.35), 3 if abs(value) < 10 else 1)


def cutter_inputs(random_number, program):
    program["pinned"] = random_number.sample(PINNABLE, 2)
    values = {"bag_length_mm": random_number.uniform(80, 600), "rate_bags_per_min": random_number.uniform(20, 120),
              "base_speed_mm_per_s": random_number.uniform(50, 900), "film_speed_mm_per_s": random_number.uniform(80, 700)}
    program.update({key: round(values[key], 1) if key in program["pinned"] else None for key in PINNABLE})
    ends = [(3.5, 8), (2.1, 3.1), (1.45, 1.9), (1.1, 1.4)]
    program.update({f"k{i + 1}": round(random_number.uniform(*ends[i]), 4) for i in range(4)})
    program["ramp_position_percent"] = random_number.randint(0, 100) if program["ratios"] == "between" else None


def cam_points(random_number, program):
    if "knots" in program:
        count = random_number.randint(5, 20)
        angles = [0, *sorted(random_number.sample(range(5, 356), count - 2)), 360]
        slave = [round(random_number.uniform(0, 60), 2) for _ in angles]
        program["knots"] = [[angle, mm] for angle, mm in zip(angles, [0, *slave[1:-1], 0])]
    for segment in program.get("segments", []):
        if segment.get("end_mm"):
            segment["end_mm"] = round(random_number.uniform(5, 80), 2)
    if "segments" in program:
        program["segments"][1].pop("end_mm", None)


def random_recipe(random_number, bases):
    recipe = json.loads(json.dumps(random_number.choice(bases)))
    program = recipe["program"]
    for part in (recipe["machine"], program):
        for key, value in part.items():
            if isinstance(value, (int, float)) and random_number.random() < 0.5:
                part[key] = changed(random_number, key, value)
    for key, options in CHOICES.items():
        if key in program:
            program[key] = random_number.choice(options)
    if program["kind"] == "rotary_cutter":
        cutter_inputs(random_number, program)
    cam_points(random_number, program)
    recipe["name"] = random_number.choice(["Keks 250", "饼干 250", "", "x" * 40]) or recipe["name"]
    recipe["version"] = random_number.randint(1, 65535)
    return recipe


def main():
    if len(sys.argv) < 3:
        raise SystemExit(__doc__)
    old, new = sys.argv[1:3]
    count = int(sys.argv[3]) if len(sys.argv) > 3 else 10000
    random_number = random.Random(int(sys.argv[4]) if len(sys.argv) > 4 else 1)
    bases = [json.loads(run(old, "recipe", "--kind", kind).stdout) for kind in KINDS]
    differing = []

    def both(recipe):
        before, after = image(old, recipe), image(new, recipe)
        if before != after:
            differing.append(recipe)
        return recipe["program"]["kind"], before[0] == 0

    with ThreadPoolExecutor(4) as pool:
        made = list(pool.map(both, examples(bases)))
        print(f"examples: {sum(done for _, done in made)} images, {len(made) - sum(d for _, d in made)} refused by both")
        accepted = {kind: 0 for kind in KINDS}
        refused = 0
        while sum(accepted.values()) < count:
            batch = [random_recipe(random_number, bases) for _ in range(400)]
            for kind, done in pool.map(both, batch):
                accepted[kind] += done
                refused += not done
    print(f"random: {sum(accepted.values())} images, {refused} refused by both;", accepted)
    print(f"{len(differing)} differ")
    for recipe in differing[:5]:
        print(json.dumps(recipe))
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
