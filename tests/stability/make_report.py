#!/usr/bin/env python3
"""Makes docs/stability.md of docs/stability/*.json and template.md, or checks that it is what they say.

  make_report.py [--check]
"""

import json
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
DOCS = HERE.parents[1] / "docs"
DATA = DOCS / "stability"
PAGE = DOCS / "stability.md"


def read(name):
    return json.loads((DATA / name).read_text(encoding="utf-8"))


def table(head, rows):
    lines = [head, ["---"] * len(head)] + rows
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines)


def per_million(count, rays):
    share = 1e6 * count / rays
    return "0" if count == 0 else f"{share:.2g}" if share < 10 else f"{share:.0f}"


def battery_table(battery):
    nudges = battery["nudges"]
    head = (["search", "rays", "set", "hits"] + [f"by {n}" if i == 0 else str(n) for i, n in enumerate(nudges)] +
            ["none", "windowZ: median [2^-24]", "0.1 %", "worst"])
    rows = []
    for entry in battery["rows"]:
        rays = entry["rays"]
        rows.append([entry["search"], f"{rays:,}", entry["set"], f"{100 * entry['hits'] / rays:.0f} %"]
                    + [per_million(count, rays) for count in entry["beside"]]
                    + [per_million(entry["wrong"], rays), f"{entry['window_z_median']:.2g}",
                       f"{entry['window_z_p999']:.2g}", f"{entry['window_z_worst']:.2g}"])
    return table(head, rows)


def cases_table(cases):
    return table(["#", "case", "what it does here", "test", "elsewhere"],
                 [[case["row"], case["case"], case["here"], case["test"], case.get("peers", "")]
                  for case in cases])


def mutants_table(mutants):
    return table(["case", "fault", "in", "caught by"],
                 [[m["row"], m["fault"], "`" + m["file"].replace("osgWaterReflect/", "") + "`",
                   m["test"] if m["caught"] else "**nothing**"] for m in mutants])


def page():
    battery = read("battery.json")
    cases = json.loads((HERE / "cases.json").read_text(encoding="utf-8"))
    mutants = read("mutants.json")
    values = {
        "widest": str(battery["widest"]),
        "rays": f"{sum(row['rays'] for row in battery['rows']):,}",
        "off_plane_q": f"{max(row['off_plane_q_pixels'] for row in battery['rows']):.1g}",
        "wrong": str(sum(row["wrong"] for row in battery["rows"])),
        "battery_table": battery_table(battery),
        "cases_table": cases_table(cases),
        "mutants": str(len(mutants)),
        "caught": str(sum(m["caught"] for m in mutants)),
        "mutants_table": mutants_table(mutants),
    }
    template = (HERE / "template.md").read_text(encoding="utf-8")
    return re.sub(r"\{\{(\w+)\}\}", lambda match: values[match.group(1)], template)


def main():
    text = page()
    if sys.argv[1:] == ["--check"]:
        if PAGE.read_text(encoding="utf-8") != text:
            sys.exit("docs/stability.md: expected what docs/stability/*.json say; "
                     "run tests/stability/make_report.py")
    elif sys.argv[1:]:
        sys.exit(f"expected nothing or --check, got {' '.join(sys.argv[1:])}")
    else:
        PAGE.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
