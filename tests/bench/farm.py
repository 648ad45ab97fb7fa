#!/usr/bin/env python3
"""How the time of a picture falls with the number of its parts (host/farm.md).

Renders all parts of a scene one after the other, as machines like this one would at the same time, and merges
them: the farm's time is that of the slowest part, and of the merge. Prints a table, and how the time would go on
falling by the law time = fixed + skew * work / N, with the fixed share of one part, the work of the whole picture
and the skew (slowest / mean) of the largest number of parts.

    tests/bench/farm.py build/laver scene.xml [--parts 1,2,4,8,16] [--rounds 3] [options of laver]
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import tempfile
import time


def render(laver, scene, options, part, count, folder):
    output = folder / f"{part}.exr"
    stats = folder / f"{part}.json"
    shard = [] if count == 1 else ["--shard", f"{part}/{count}"]
    subprocess.run([laver, scene, "-q", "-o", output, f"--stats={stats}", *shard, *options], check=True)
    return output, json.loads(stats.read_text())["seconds"]


def merge(laver, outputs, folder):
    if len(outputs) == 1:
        return 0.0
    start = time.monotonic()
    subprocess.run([laver, "merge", *outputs, "-o", folder / "whole.exr"], check=True, stdout=subprocess.DEVNULL)
    return time.monotonic() - start


def measured(laver, scene, options, count, folder):
    outputs, seconds = zip(*(render(laver, scene, options, i, count, folder) for i in range(count)))
    work = [s["trace"] + s["reconstruct"] for s in seconds]
    return {
        "slowest": max(s["total"] for s in seconds),
        "all": sum(s["total"] for s in seconds),
        "fixed": statistics.median(s["total"] - w for s, w in zip(seconds, work)),
        "work": sum(work),
        "skew": max(work) / statistics.mean(work),
        "merge": merge(laver, outputs, folder),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("laver")
    parser.add_argument("scene")
    parser.add_argument("--parts", default="1,2,4,8,16")
    parser.add_argument("--rounds", type=int, default=3)
    arguments, options = parser.parse_known_args()
    counts = [int(n) for n in arguments.parts.split(",")]
    print("| parts | slowest part, s | merge, s | all parts, s | start, scene, files, s | "
          "trace and reconstruct, s | slowest / mean |")
    print("|--:|--:|--:|--:|--:|--:|--:|")
    rows = {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        render(arguments.laver, arguments.scene, options, 0, 1, folder)  # fills the caches
        for count in counts:
            rounds = [measured(arguments.laver, arguments.scene, options, count, folder)
                      for _ in range(arguments.rounds)]
            row = {key: statistics.median(r[key] for r in rounds) for key in rounds[0]}
            rows[count] = row
            print(f"| {count} | {row['slowest']:.2f} | {row['merge']:.2f} | {row['all']:.2f} | {row['fixed']:.2f} | "
                  f"{row['work']:.2f} | {row['skew']:.2f} |", flush=True)
    fixed, skew = rows[counts[-1]]["fixed"], rows[counts[-1]]["skew"]
    work = rows[counts[0]]["work"]
    print(f"\nfixed {fixed:.2f} s, work {work:.2f} s: machines spend half of their time on work with "
          f"{max(1, work / fixed):.0f} parts, 90 % with {max(1, work / fixed / 9):.0f}")
    print("by fixed + skew * work / N, s: " +
          ", ".join(f"{n} parts {fixed + skew * work / n:.2f}" for n in (32, 64, 128, 256, 1024)))


if __name__ == "__main__":
    main()
