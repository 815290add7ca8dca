"""Which runs are worth their cost."""

# Runs whose energy rises by more than this part of the initial one at some
# time are not trusted, however small their error
LARGEST_RISE = 1e-3


def numbers(rows):
    """Rows of runs that ended well, errors and costs as numbers."""
    found = []
    for row in rows:
        if row["status"] == "done":
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
    """Runs to which no other is both cheaper and better, by cost."""
    best, found = float("inf"), []
    for row in sorted(trusted(rows), key=lambda r: (r["cost"], r[error])):
        if row[error] < best:
            best = row[error]
            found.append(row)
    return found


def cheapest(rows, limit, error="error"):
    """The cheapest run with at most that error; None if there is none."""
    good = [r for r in trusted(rows) if r[error] <= limit]
    return min(good, key=lambda r: r["cost"], default=None)
