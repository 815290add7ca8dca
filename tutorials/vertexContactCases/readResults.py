"""Read what the function objects of vertexContact write to postProcessing."""

from pathlib import Path

import numpy as np

_BRACKETS = str.maketrans("()", "  ")


def _segments(case, functionObject, name):
    """Files with this name in the folders of all start times, in order."""
    folder = Path(case)/"postProcessing"/functionObject
    files = sorted(folder.glob(f"*/{name}"), key=lambda f: float(f.parent.name))
    if not files:
        raise FileNotFoundError(f"no {folder}/<time>/{name}")
    return files


def _value(token):
    try:
        return float(token)
    except ValueError:
        return token


def _read(file):
    """Header lines, and the numbers as an array with a row for each line. The
    array has objects if there are names in the file."""
    header, rows = [], []
    with open(file) as lines:
        for line in lines:
            (header if line.startswith("#") else rows).append(line)
    rows = [row for row in rows if row.strip()]
    if not rows:
        return header, np.empty((0, 0))
    tokens = " ".join(rows).translate(_BRACKETS).split()
    try:
        values = np.array(tokens, dtype=float)
    except ValueError:
        values = np.array([_value(token) for token in tokens], dtype=object)
    return header, values.reshape(len(rows), -1)


def _joined(files):
    """Segments one after the other. If a run was repeated from an earlier
    time, the later segment counts."""
    data = None
    for file in files:
        header, rows = _read(file)
        if not rows.size:
            continue
        if data is not None:
            data = data[data[:, 0] < rows[0, 0]]
        data = rows if data is None else np.vstack((data, rows))
    if data is None:
        raise ValueError(f"no rows in {files[-1]}")
    return header, data


def _columns(header, data, name):
    """Columns of a segment as a dictionary."""
    keys = [key.split("[")[0] for key in header[-1].lstrip("#").split()]
    if len(keys) != data.shape[1]:
        raise ValueError(f"{name}: {len(keys)} names for {data.shape[1]} "
                         "columns")
    return {key: column.astype(str if isinstance(column[0], str) else float)
            for key, column in zip(keys, data.T)}


def table(case, functionObject, name):
    """Columns of a table as a dictionary with keys without units, such as
    'Time' or 'bar1:kinetic'. Columns of names, such as 'minus' and 'plus' if
    each pair of surfaces has rows of its own, are strings. Where a run was
    continued with other columns, such as those of damping, values that a
    segment lacks are nan."""
    files = _segments(case, functionObject, name)
    joined = {}
    for file in files:
        header, data = _read(file)
        if not data.size:
            continue
        columns = _columns(header, data, f"{functionObject}/{name}")
        kept = np.array([t < data[0, 0] for t in joined.get("Time", ())],
                        dtype=bool)
        nan = {key: np.full(len(data), np.nan) for key in joined}
        before = np.full(len(kept), np.nan)
        joined = {key: np.concatenate((joined.get(key, before)[kept], column))
                  for key, column in {**nan, **columns}.items()}
    if not joined:
        raise ValueError(f"no rows in {files[-1]}")
    return joined


def probe(case, functionObject, field, point=0):
    """Times and values, an array (time, component), at one of the points."""
    header, data = _joined(_segments(case, functionObject, field))
    nPoints = sum(line.startswith("# Probe") and "(" in line for line in header)
    values = data[:, 1:].reshape(len(data), nPoints, -1)
    return data[:, 0], values[:, point]


def csv(file):
    """Columns of a table with commas, as a dictionary. '#' starts a comment;
    the first other line has the names."""
    with open(file) as lines:
        rows = [line.strip() for line in lines
                if line.strip() and not line.startswith("#")]
    data = np.array([row.split(",") for row in rows[1:]], dtype=float)
    return dict(zip(rows[0].split(","), data.T))
