"""Prints and saves, at the end of a run, what its benchmarks have measured."""

from __future__ import annotations

import os

# One core for all. With two, OpenBLAS makes SLSQP three times slower from six evaders on. It reads
# this when it is loaded, so the imports come after.
os.environ |= dict.fromkeys(("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"), "1")

import accounting
import certificates
import picture
import rounds
import tables


def pytest_terminal_summary(terminalreporter, config):
    solves = [solve for size in rounds.MEASURED.values() for solve in size]
    times = [row for size in rounds.MEASURED.values() for row in tables.rows(size)]
    parts = [account for size in accounting.MEASURED.values() for account in size]
    proofs = [row for size in certificates.MEASURED.values() for row in size]
    folder = config.rootpath / "results" / "bench"
    for name, title, records in (
        ("times", "Times, µs, and ratios to this planner compiled, game by game", times),
        ("accounting", "Accounting: times in µs, parts in per cent of the time", parts),
        ("certificates", "Certificates: shares proven in time, gaps in per cent", proofs),
    ):
        if records:
            folder.mkdir(parents=True, exist_ok=True)
            tables.write_csv(folder / f"{name}.csv", records)
            (folder / f"{name}.md").write_text(tables.markdown(records) + "\n", encoding="utf-8")
            terminalreporter.section(title)
            terminalreporter.write_line(tables.markdown(records))
    if times:
        tables.write_csv(folder / "solves.csv", solves)
        picture.save(times, folder / "times.png")
    if times or parts or proofs:
        terminalreporter.write_line(f"saved in {folder.relative_to(config.rootpath)}")
