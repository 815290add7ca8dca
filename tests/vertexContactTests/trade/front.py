"""The runs that are worth their cost."""

from math import log

# Runs whose energy rises by more than this part of the initial one at some
# time are not trusted, however small their error
LARGEST_RISE = 1e-3


def numbers(rows):
    """Rows of successful runs, with errors and costs as numbers."""
    found = []
    for row in rows:
        if row.get("status", "done") == "done":
            found.append({k: number(v) for k, v in row.items()})
    return found


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def trusted(rows):
    return [r for r in rows if r["rise"] <= LARGEST_RISE]


def front(rows, error="error"):
    """Runs for which no other run is both cheaper and better, sorted by
    cost."""
    best, found = float("inf"), []
    for row in sorted(trusted(rows), key=lambda r: (r["cost"], r[error])):
        if row[error] < best:
            best = row[error]
            found.append(row)
    return found


def cheapest(rows, limit, error="error"):
    """The cheapest run with at most this error; None if there is none."""
    good = [r for r in trusted(rows) if r[error] <= limit]
    return min(good, key=lambda r: r["cost"], default=None)


def atEqualError(rows, limit, error="error"):
    """The cost of an error, interpolated by powers of the error between the
    runs of the front, and its kind: "" this cost, ">" more than the run with
    the least error, "<" less than the cheapest run."""
    best = front([r for r in rows if r.get(error, "") != ""], error)
    if not best:
        return None, ""
    if limit > best[0][error]:
        return best[0]["cost"], "<"
    for a, b in zip(best, best[1:]):
        if limit >= b[error]:
            part = log(a[error]/limit)/log(a[error]/b[error])
            return a["cost"]*(b["cost"]/a["cost"])**part, ""
    return best[-1]["cost"], ">" if limit < best[-1][error] else ""
