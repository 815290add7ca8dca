"""Work against precision of a case, with the front marked."""

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

from vertexContactTests.trade.cases import FOLDER
from vertexContactTests.trade.front import LARGEST_RISE, front
from vertexContactTests.trade.peers import NAME, ONE, PACKAGED, TITLE
from vertexContactTests.trade.variants import PRESETS, isPreset


def draw(case, rows, peer, packaged, unit):
    """Draw errors over costs. rows: numbers of one case; peer: by kind,
    numbers of plain finite elements; packaged: numbers of programs from
    packages; unit: cost of balanced on the base mesh."""
    figure, axes = plt.subplots(figsize=(7.5, 5.5))

    def show(some, style, **more):
        axes.plot([r["cost"]/unit for r in some],
                  [r["error"] for r in some], style, **more)

    bad = [r for r in rows if r["rise"] > LARGEST_RISE]
    others = [r for r in rows if r not in bad]
    show(others, ".", color="0.6", label="all runs")
    show(bad, "x", color="tab:red", label="energy rises")
    best = front(rows)
    show(best, "k-", linewidth=0.8, label="front")
    show(best, "o", color="k", markersize=9, markerfacecolor="none")
    for preset, marker in zip(PRESETS, "v^sD"):
        mine = sorted((r for r in rows if r["options"]["preset"] == preset
                       and isPreset(case, r["options"])),
                      key=lambda r: r["cost"])
        show(mine, f"{marker}--", linewidth=1, label=preset)
    for kind, error, style, what in (
            (ONE, "error", "P-", ""), (NAME, "error", "P--", ", eight at once"),
            (NAME, "own", "P:", ", the same against its own reference")):
        mine = [r for r in peer[kind] if r.get(error, "") != ""]
        if mine:
            axes.plot([r["cost"]/unit for r in mine],
                      [r[error] for r in mine], style, linewidth=1,
                      color="tab:purple", label=TITLE + what,
                      markerfacecolor="none" if what else None)
    for (program, title), marker in zip(PACKAGED.items(), "*X"):
        mine = [r for r in packaged if r["program"] == program]
        if mine:
            show(mine, f"{marker}-.", linewidth=1, color="tab:brown",
                 label=title)
    # The page has their names; neighbours have their numbers above and below
    for number, row in enumerate(best, 1):
        axes.annotate(str(number), (row["cost"]/unit, row["error"]),
                      fontsize=8, xytext=(0, 8 if number % 2 else -16),
                      textcoords="offset points", ha="center")
    axes.set(xscale="log", yscale="log", title=case.title,
             xlabel="cost / that of balanced on the base mesh",
             ylabel="error: mean of velocity, force and energy")
    axes.legend(fontsize=8)
    axes.grid(alpha=0.3, which="both")
    figure.tight_layout()
    figure.savefig(FOLDER/f"{case.name}.png", dpi=90)
    plt.close(figure)
