# SPDX-License-Identifier: Apache-2.0
"""The report: an aligned Markdown table a scene, readable as text, with what it was measured on."""
import os
import platform
import shlex
import sys
import time

HEAD = ["renderer", "process s", "render s", "Msamples/s", "peak MB", "cold s", "RMSE %",
        "but worst", "s to 1 %", "but worst", "equal error", "mean, blocks"]
NOTES = """\
Medians over the rounds (least to most). process: the whole process, warm caches; render: rendering alone;
cold: what the first run with empty kernel caches takes longer. RMSE: of luminance over the mean, against
the same renderer's own reference, whose noise is taken off; pixels at visible lamps are left out. but
worst: without the worst 0.1 % of the pixels. s to 1 %: render s times (RMSE / 1 %)^2, extrapolated.
equal error: a run with the samples extrapolated to the target: process s, samples a pixel, the RMSE found;
in brackets: extrapolated only, for it would take too long or more than half the reference's samples.
mean, blocks: this renderer's reference over lobe's, of the means and RMS of 8x8 block means, in %."""


def figure(x):
    """Three significant digits, without an exponent."""
    return f"{x:.0f}" if abs(x) >= 100 else f"{x:.3g}"


def spread(value, factor=1):
    low, middle, high = (factor * value[key] for key in ("least", "median", "most"))
    return f"{figure(middle)} ({figure(low)}-{figure(high)})" if low < high else figure(middle)


def equal_error(row):
    e = row["equal_error"]
    if "wall_s" not in e:
        return f"[{figure(e['expected_wall_s'])} s, {e['spp']} spp]"
    return f"{figure(e['wall_s'])} s, {e['spp']} spp: {figure(100 * e['relative_rmse'])} %"


def cells(row):
    if row["failed"]:
        return [row["title"], row["failed"].replace("|", "/")] + [""] * (len(HEAD) - 2)
    picture = f"{100 * row['mean_deviation']:+.2f}, {100 * row['block_deviation']:.1f}"
    return [row["title"], spread(row["wall_s"]), spread(row["render_s"]),
            spread(row["msamples_per_s"]), figure(row["peak_mb"]["median"]),
            figure(row["cold_s"]) if "cold_s" in row else "-", spread(row["relative_rmse"], 100),
            spread(row["relative_rmse_trimmed"], 100), spread(row["one_percent_s"]),
            spread(row["one_percent_s_trimmed"]), equal_error(row),
            picture + (" OTHER PICTURE" if row["other_picture"] else "")]


def aligned(rows):
    widths = [max(len(row[i]) for row in rows) for i in range(len(HEAD))]
    lines = ["| " + " | ".join(c.ljust(w) for c, w in zip(row, widths)) + " |" for row in rows]
    return [lines[0], "|" + "|".join("-" * (w + 2) for w in widths) + "|", *lines[1:]]


def processor():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as source:
            return next(line.split(":")[1].strip() for line in source if "model name" in line)
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


def machine(options, found, device):
    return {"processor": processor(), "cores": os.cpu_count(), "threads": options.threads,
            "system": platform.platform(), "date": time.strftime("%Y-%m-%d"),
            "load_at_start": os.getloadavg()[0], "versions": found, "lobe_device": device,
            "command": shlex.join(sys.argv)}


def text(report):
    m, o = report["machine"], report["options"]
    lines = [f"{m['processor']}, {m['cores']} cores, {m['threads']} threads; {m['date']}, "
             f"load {m['load_at_start']:.1f} at the start; lobe on {m['lobe_device']}",
             "; ".join(f"{name}: {version}" for name, version in m["versions"].items()),
             f"{o['size']}x{o['size']} pixels, {o['spp']} samples a pixel, rounds: {o['rounds']}, "
             f"references of {o['reference_spp']}, equal error at {100 * o['target']:g} %",
             "", f"    {m['command']}", ""]
    for scene in report["scenes"]:
        lines += [f"**{scene['name']}**: {scene['triangles']} triangles, {scene['spheres']} spheres, "
                  f"at most {scene['depth']} scattering events", "",
                  *aligned([HEAD] + [cells(row) for row in scene["rows"]]), ""]
        if scene["glossy"]:
            lines += ["The glossy material: " + "; ".join(
                f"{family}: {what}" for family, what in report["glossy"].items()) + ".", ""]
    lines += [NOTES, *("Left out: " + line for line in report["missing"])]
    if report["rays"]:
        lines += ["", "Rays beside Embree's:", "", *("    " + x for x in report["rays"].split("\n"))]
    return "\n".join(lines)
