"""The README's two tables: five rows each, no cell above 60 characters."""

from measure import accuracy, coverage, intervals, speed
from measure.kinds import number, percent


def raw_of(results, name):
    record = results["measurements"].get(name, {})
    return record.get("raw")


COMMAND = "option of `benchmarks/measure.py run`"


def verdict(text, held):
    return text if held else f"{text} (**not held**)"


def lidar_equation(raw):
    largest = {name: 0.0 for name in accuracy.LARGEST}
    for key, gates in raw.items():
        off = max(abs(echo / equation - 1) for echo, equation in zip(gates["echo"], gates["equation"]))
        largest[key.split(", ")[1]] = max(largest[key.split(", ")[1]], off)
    return (
        "; ".join(f"{percent(accuracy.LARGEST[name])} {name}" for name in largest),
        verdict("; ".join(percent(off, 2) for off in largest.values()), all(off < accuracy.LARGEST[n] for n, off in largest.items())),
    )


def agreement(raw):
    z = {scene: [abs(x) for x in of_scene["z"]] for scene, of_scene in raw.items()}
    every = [x for of_scene in z.values() for x in of_scene]
    limit, largest = accuracy.family_wise_z(max(1, len(every))), max(every, default=0)
    off = {scene: of_scene for scene, of_scene in z.items() if max(of_scene, default=0) >= limit}
    if not off:
        return f"within {limit:.1f} errors", verdict(f"up to {largest:.1f} errors in {len(every)} gates", bool(every))
    where = next(iter(off)) if len(off) == 1 else f"{len(off)} scenes"
    beyond, gates = sum(x >= limit for x in every), sum(map(len, off.values()))
    return f"within {limit:.1f} errors", verdict(f"{where}: {beyond} of {gates} gates off by up to {largest:.1f}", False)


def of_coverage(allowed, by_estimator):
    rows = [intervals.covered("", counts, allowed) for counts in by_estimator]
    shares = [100 * coverage.share(counts["covered"], counts["converged"])[0] for counts in by_estimator]
    held = all(row.held is not False for row in rows)
    return rows[0].allowed, verdict(f"{min(shares):.1f} to {max(shares):.1f} %", held)


def slabs(raw):
    rows = list(accuracy.rows_slabs(raw))
    measured = "; ".join(row.measured for row in rows)
    published = "; ".join(row.allowed.split(" ")[0] for row in rows)
    return f"within 3 errors of {published}", verdict(measured, all(row.held for row in rows))


TRUST = (
    ("lidar-equation", "Single scattering obeys the lidar equation", lidar_equation),
    ("agreement", "Two independent estimators agree", agreement),
    ("coverage", "95 % intervals of converged gates cover the truth",
     lambda raw: of_coverage(intervals.ALLOWED, [c for of in raw.values() for c in of.values()])),
    ("coverage-hard", "The same in forty random layers",
     lambda raw: of_coverage(intervals.ALLOWED, raw.values())),
    ("slabs", "Multiple scattering: slabs as published", slabs),
)


def time_of(scene):
    return lambda raw: (f"{scene[0].upper()}{scene[1:]}: 2 % to 40 m", speed.stated_time(raw[scene], raw["limit"]))


def worst(raw):
    name, one = speed.slowest(raw)
    return f"Slowest of {len(raw) - 1}: {name}", speed.stated_time(one, raw["limit"])


def environments(raw):
    times = sorted(least["16"] / least["0"] for least in raw.values())
    return "16 more waters in the same run, over none", f"{times[0]:.1f} to {times[-1]:.1f} times the time"


def lanes(raw):
    times = {name: speed.over_scalar(raw, name) for name in accuracy.BOTH}
    ratios = "; ".join(f"{number(ratio)} times {name}" for name, (ratio, _) in times.items())
    return f"Lanes ({times['forward'][1]}) over the scalar engine", ratios


SPEED = (
    ("time-to-target", time_of("ship lidar, three channels")),
    ("time-to-target", time_of("peaked water")),
    ("time-to-target", worst),
    ("environments", environments),
    ("engines", lanes),
)


def rows(head, lines):
    return "".join("| " + " | ".join(cells) + " |\n" for cells in (head, ["---"] * len(head), *lines))


def trust_table(results):
    lines = []
    for name, claim, summary in TRUST:
        raw = raw_of(results, name)
        allowed, measured = ("", "not measured") if raw is None else summary(raw)
        lines.append([claim, allowed, measured, f"`--only {name}`"])
    return remark(results) + rows(["claim", "allowed", "measured", COMMAND], lines)


def speed_table(results):
    lines = []
    for name, summary in SPEED:
        raw = raw_of(results, name)
        what, measured = (name, "not measured") if raw is None else summary(raw)
        lines.append([what, measured])
    return f"{remark(results)}{machine(results['stamp'])} Other machines may differ twofold.\n\n" + rows(["what", "measured"], lines)


def machine(stamp):
    return (
        f"On {stamp['processor'].partition(' (family')[0]}, {stamp['cores']} cores, {stamp['instruction_sets'][-1]}, "
        f"{stamp['compiler']}, commit {commit(stamp)}, {stamp['date']}."
    )


def commit(stamp):
    return stamp["commit"] + (", with changes that are not committed" if stamp["changed_since_commit"] else "")


def remark(results):
    return "**A reduced run: do not quote.**\n\n" if results["stamp"]["reduced"] else ""
