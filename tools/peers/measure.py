# SPDX-License-Identifier: Apache-2.0
"""Runs renderers in turn on one scene and measures time, memory and error of each."""
import hashlib
import os
import statistics
import subprocess
import sys
import threading
import time

import pictures
import renderers


class Failed(Exception):
    pass


def say(text):
    print(text, file=sys.stderr, flush=True)


def run(command, environment, log, limit):
    """Seconds and peak resident MB of a process. Its peak starts at that of the process which
    starts it, so this program keeps no meshes."""
    start = time.monotonic()
    with open(log, "wb") as out:
        process = subprocess.Popen(command, stdout=out, stderr=subprocess.STDOUT, env=environment,
                                   stdin=subprocess.DEVNULL)
    timer = threading.Timer(limit, process.kill)
    timer.start()
    _, status, usage = os.wait4(process.pid, 0)
    seconds = time.monotonic() - start
    timer.cancel()
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        with open(log, encoding="utf-8", errors="replace") as source:
            lines = [line.strip() for line in source if line.strip()]
        raise Failed(f"no picture within {limit:g} s" if seconds >= limit else
                     f"exit {process.returncode}: {lines[-1] if lines else 'no message'}")
    return {"wall_s": seconds, "peak_mb": usage.ru_maxrss / 1024}


class Bench:
    """One scene: options, the scene's description and a folder for what the renderers write."""

    def __init__(self, options, scene, found):
        self.options, self.scene, self.found = options, scene, found
        self.folder = os.path.join(options.work, scene["name"])
        os.makedirs(self.folder, exist_ok=True)
        self.pixels = self.reference = None

    def render(self, renderer, spp, seed, label):
        """(measures, luminances) of one run."""
        stem = os.path.join(self.folder, f"{renderer.name}-{label}")
        caches = os.path.join(self.options.work, "caches", renderer.name)
        for end in (".json", ".picture", ".exr"):  # what an earlier run left is not an answer
            if os.path.exists(stem + end):
                os.remove(stem + end)
        command = renderers.request(renderer, self.scene, self.options, spp, seed, stem)
        measures = run(command, renderers.environment(renderer, self.options, caches),
                       stem + ".log", self.options.timeout)
        return self.taken(renderer, stem, measures)

    def taken(self, renderer, stem, measures):
        try:
            picture, seconds, spp = renderers.read(renderer, self.options, stem)
        except (OSError, ValueError) as fault:
            raise Failed(f"no picture: {fault}") from fault
        samples = self.options.size ** 2 * spp
        return {**measures, "render_s": seconds, "spp": spp,
                "msamples_per_s": samples / seconds / 1e6}, picture

    def halves(self, renderer):
        """Two independent pictures of half the reference's samples, kept between runs."""
        made = []
        for seed in (1, 2):
            version = self.found[renderer.name]
            key = hashlib.sha256(repr((self.scene["hash"], self.options.size, version,
                                       self.options.reference_spp)).encode()).hexdigest()[:12]
            label = f"reference-{key}-{seed}"
            stem = os.path.join(self.folder, f"{renderer.name}-{label}")
            if os.path.exists(stem + ".json"):
                try:
                    made.append(self.taken(renderer, stem, {})[1])
                    continue
                except Failed:
                    pass
            say(f"{self.scene['name']}: reference of {renderer.title}, half {seed}")
            made.append(self.render(renderer, self.options.reference_spp // 2, seed, label)[1])
        return made

    def look(self, renderer, references):
        """The family's reference and how far it is from lobe's; the first is lobe's and makes the
        mask."""
        if renderer.family not in references:
            a, b = self.halves(renderer)
            picture = pictures.average(a, b)
            if self.pixels is None:
                self.pixels = pictures.visible(picture, self.options.size, self.scene["limit"])
                self.reference = picture
            mean, blocks = pictures.deviation(picture, self.reference, self.options.size,
                                              self.pixels)
            references[renderer.family] = {
                "halves": (a, b),
                "mean_deviation": mean, "block_deviation": blocks}
        return references[renderer.family]

    def errors(self, picture, reference):
        """Relative RMSE, also without the worst 0.1 % of the pixels: a few of them can hold most of
        it, and then it says little of the other pixels and changes from run to run."""
        return {name: pictures.relative_rmse(picture, *reference["halves"], self.pixels, part)
                for name, part in (("relative_rmse", 0), ("relative_rmse_trimmed", 0.001))}


def guarded(rows, renderer, work):
    """Does work unless the renderer failed before; a failure goes into its row."""
    row = rows.setdefault(renderer.name, {"renderer": renderer.name, "title": renderer.title,
                                          "runs": [], "failed": None})
    if row["failed"] is None:
        try:
            work(row)
        except Failed as fault:
            row["failed"] = str(fault)
            say(f"{renderer.title}: {fault}")


def summary(row):
    """Median, least and most over the rounds."""
    for key in row["runs"][0].keys() - {"spp"}:
        values = [r[key] for r in row["runs"]]
        row[key] = {"median": statistics.median(values), "least": min(values), "most": max(values)}
    if "cold_wall_s" in row:
        row["cold_s"] = row["cold_wall_s"] - row["wall_s"]["median"]


def measure(options, scene, chosen, found):
    """A row a renderer. Every step goes round all renderers, so that what slows the machine for a
    while slows all of them."""
    bench, rows, references = Bench(options, scene, found), {}, {}

    def look(renderer, row):
        reference = bench.look(renderer, references)
        row.update({k: reference[k] for k in ("mean_deviation", "block_deviation")})
        row["other_picture"] = abs(row["mean_deviation"]) > 0.02

    def warm(renderer, row):
        renderers.forget_kernels(os.path.join(options.work, "caches", renderer.name))
        say(f"{scene['name']}: first run of {renderer.title}")
        measures, _ = bench.render(renderer, options.spp, 9, "cold")
        if renderer.compiles:
            row["cold_wall_s"] = measures["wall_s"]

    def equal_samples(renderer, row, number):
        say(f"{scene['name']}: round {number + 1} of {renderer.title}")
        measures, picture = bench.render(renderer, options.spp, 10 + number, "round")
        errors = bench.errors(picture, references[renderer.family])
        row["runs"].append({**measures, **errors, **{
            key.replace("relative_rmse", "one_percent_s"):
                measures["render_s"] * (error / 0.01) ** 2 for key, error in errors.items()}})

    def equal_error(renderer, row):
        summary(row)
        spp = max(1, round(options.spp * (row["relative_rmse"]["median"] / options.target) ** 2))
        expected = row["wall_s"]["median"] + row["render_s"]["median"] * (spp / options.spp - 1)
        row["equal_error"] = {"target": options.target, "spp": spp, "expected_wall_s": expected}
        if expected > options.longest or spp > options.reference_spp / 2:
            return  # the reference's own noise would hide the error
        say(f"{scene['name']}: {spp} samples a pixel of {renderer.title}")
        try:
            measures, picture = bench.render(renderer, spp, 99, "target")
        except Failed as fault:
            say(f"{renderer.title}: {fault}")
            return
        row["equal_error"].update(wall_s=measures["wall_s"], render_s=measures["render_s"],
                                  **bench.errors(picture, references[renderer.family]))

    for renderer in chosen:
        guarded(rows, renderer, lambda row, r=renderer: look(r, row))
        if renderer.name == "lobe" and rows["lobe"]["failed"]:
            raise Failed("lobe, which all others are compared with: " + rows["lobe"]["failed"])
    for renderer in chosen:
        guarded(rows, renderer, lambda row, r=renderer: warm(r, row))
    for number in range(options.rounds):
        for renderer in chosen:
            guarded(rows, renderer, lambda row, r=renderer: equal_samples(r, row, number))
    for renderer in chosen:
        guarded(rows, renderer, lambda row, r=renderer: equal_error(r, row))
    return list(rows.values())
