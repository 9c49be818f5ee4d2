"""An .npz of `impulse export` is what `impulse sim` says: check_npz.py NPZ BODIES ENERGIES."""
import csv
import sys

import numpy as np

arrays = np.load(sys.argv[1])
rows = list(csv.DictReader(open(sys.argv[2], newline="")))
energies = list(csv.DictReader(open(sys.argv[3], newline="")))

frames, bodies = len(arrays["time"]), len(arrays["names"])
assert len(rows) == frames * bodies, (len(rows), frames, bodies)
shapes = {"position": 3, "rotation": 4, "velocity": 3, "spin": 3}
for name, width in shapes.items():
    assert arrays[name].shape == (frames, bodies, width), (name, arrays[name].shape)
    assert arrays[name].dtype == np.float64, (name, arrays[name].dtype)


def column(table, names):
    return np.array([[float(row[name]) for name in names] for row in table])


def same(name, columns):
    told = column(rows, columns).reshape(frames, bodies, len(columns))
    assert np.array_equal(arrays[name], told), name


same("position", ["x", "y", "z"])
same("rotation", ["qw", "qx", "qy", "qz"])
same("velocity", ["vx", "vy", "vz"])
same("spin", ["wx", "wy", "wz"])
assert np.array_equal(arrays["time"], column(rows, ["time"])[::bodies, 0])
assert list(arrays["names"]) == [row["body"] for row in rows[:bodies]]
assert np.array_equal(arrays["energy"][:, 0], column(energies, ["kinetic"])[:, 0])
assert np.array_equal(arrays["energy"][:, 1], column(energies, ["potential"])[:, 0])
assert np.allclose(np.linalg.norm(arrays["rotation"], axis=2), 1.0)
assert arrays["mass"].shape == (bodies,) and (arrays["mass"] >= 0).all()

count = len(arrays["contact_frame"])
for name, width in {"bodies": 2, "position": 3, "normal": 3, "friction": 3}.items():
    assert arrays["contact_" + name].shape == (count, width), name
assert arrays["contact_frame"].max() < frames and (np.diff(arrays["contact_frame"]) >= 0).all()
assert np.allclose(np.linalg.norm(arrays["contact_normal"], axis=1), 1.0)
print(f"{frames} frames, {bodies} bodies, {count} contacts")
