"""``python -m benchmarks``: chainrule beside its peers, in one run, in one table."""

from __future__ import annotations

import argparse
import json
import os
import sys
from pathlib import Path

THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")


def main() -> int:
    """Run, print, and write what was asked for; 1 when the numbers do not agree."""
    os.environ.update(dict.fromkeys(THREADS, "1"))  # before NumPy is loaded
    from benchmarks.run import TOPICS, Disagreement, Effort, run
    from benchmarks.table import as_json, as_markdown, show

    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("--json", type=Path, metavar="FILE", help="write everything measured, for machines")
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the table for a README")
    parser.add_argument("--quick", action="store_true", help="small batches and few rounds: does it run at all?")
    parser.add_argument("--only", nargs="+", choices=TOPICS, default=TOPICS, metavar="TOPIC", help=", ".join(TOPICS))
    options = parser.parse_args()
    effort = Effort(batch=2000, rounds=3, least_ns=1e6, starts=1) if options.quick else Effort()
    try:
        rows, notes, facts = run(effort, lambda line: print(f"... {line}", file=sys.stderr, flush=True), options.only)
    except Disagreement as difference:
        print(f"the numbers differ, so nothing was timed: {difference}", file=sys.stderr)
        return 1
    title = f"{facts['processor']}, {facts['instruction set']}; {facts['compiler']}; one core, processor time"
    show(rows, notes, title)
    if options.markdown:
        options.markdown.write_text(as_markdown(rows, [title, *notes]), "utf-8")
    if options.json:
        options.json.write_text(json.dumps(as_json(rows, notes, facts), indent=1) + "\n", "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
