# SPDX-License-Identifier: Apache-2.0
"""Pictures as luminances, row by row from the top, and what is measured of them."""
import array
import math
import struct
import sys


def luminances(r, g, b):
    return array.array("f", (0.2126 * x + 0.7152 * y + 0.0722 * z for x, y, z in zip(r, g, b)))


def read_raw(path, scale):
    """Little-endian float32 RGB rows."""
    values = array.array("f")
    with open(path, "rb") as source:
        values.frombytes(source.read())
    if sys.byteorder == "big":
        values.byteswap()
    return array.array("f", (scale * y for y in luminances(values[0::3], values[1::3], values[2::3])))


def read_exr(path):
    """An uncompressed EXR of scanlines and float32 channels, as lobe and Blender write them."""
    with open(path, "rb") as source:
        data = source.read()
    head, at = {}, 8
    while data[at]:
        name, kind, at = *data[at:].split(b"\0", 2)[:2], at
        at += len(name) + len(kind) + 2
        size = struct.unpack_from("<i", data, at)[0]
        head[name.decode()] = data[at + 4:at + 4 + size]
        at += 4 + size
    if head["compression"] != b"\0":
        raise ValueError(f"{path}: compressed, and only plain EXR is read")
    channels, rest = [], head["channels"]
    while rest[0]:
        name, rest = rest.split(b"\0", 1)
        if struct.unpack_from("<i", rest)[0] != 2:
            raise ValueError(f"{path}: channel {name.decode()} is not float32")
        channels.append(name.decode().split(".")[-1] if name.count(b".") == 0 else name.decode())
        rest = rest[16:]
    x0, y0, x1, y1 = struct.unpack("<4i", head["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    planes = {name: array.array("f", bytes(4 * width * height)) for name in "RGB"}
    for line in struct.unpack_from(f"<{height}Q", data, at + 1):
        y = struct.unpack_from("<i", data, line)[0] - y0
        for name, plane in planes.items():
            start = line + 8 + 4 * width * channels.index(name)
            plane[y * width:(y + 1) * width] = array.array("f", data[start:start + 4 * width])
    return luminances(planes["R"], planes["G"], planes["B"])


def mean(values):
    return sum(values) / len(values)


def average(a, b):
    return array.array("f", (0.5 * (x + y) for x, y in zip(a, b)))


def visible(picture, size, limit):
    """Indices of the pixels that are two or more away from any brighter than the limit."""
    bright = [i for i, y in enumerate(picture) if y > limit]
    masked = {(i // size + dy, i % size + dx) for i in bright
              for dy in range(-2, 3) for dx in range(-2, 3)}
    return [i for i in range(size * size) if (i // size, i % size) not in masked]


def relative_rmse(picture, a, b, pixels, leave_out=0.0):
    """Root mean square error over the mean, without the worst part of the pixels. The reference is
    the average of the independent a and b, whose own noise, (a - b)^2 / 4, is taken off."""
    errors = sorted(((picture[i] - 0.5 * (a[i] + b[i])) ** 2, 0.25 * (a[i] - b[i]) ** 2)
                    for i in pixels)
    kept = errors[:len(errors) - round(leave_out * len(errors))]
    mse = mean([error for error, _ in kept]) - mean([noise for _, noise in kept])
    return math.sqrt(max(mse, 0)) / mean([0.5 * (a[i] + b[i]) for i in pixels])


def blocks(picture, size, pixels, across=8):
    """Means over a coarse grid, None where everything is masked."""
    sums = {}
    for i in pixels:
        cell = (i // size * across // size, i % size * across // size)
        total, count = sums.get(cell, (0.0, 0))
        sums[cell] = (total + picture[i], count + 1)
    return {cell: total / count for cell, (total, count) in sums.items()}


def deviation(picture, reference, size, pixels):
    """Relative differences from the reference: of the means, and as root mean square of 8x8 block
    means over the mean."""
    level = mean([reference[i] for i in pixels])
    a, b = blocks(picture, size, pixels), blocks(reference, size, pixels)
    return (mean([picture[i] for i in pixels]) / level - 1,
            math.sqrt(mean([(a[c] - b[c]) ** 2 for c in b])) / level)
