"""The report on the paper's section V, in Markdown: the paper's claims beside our figures."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from covey.model.units import counted
from covey.model.validation import Floats
from covey.simulation import Game
from covey.studies.paper.claims import AT_ONE, Claim, fig4_claims, fig5_claims
from covey.studies.paper.figures import (
    HIDDEN,
    Gains,
    answer_gains,
    both_times,
    guarantee_ratios,
    survival_ratios,
    turn_rate_gains,
)
from covey.studies.running.results import StudyResult
from covey.studies.statistics import Estimate

_DEFINITIONS = """\
## Where the definitions differ

What the paper leaves open had to be decided, and some of it moves the figures.

- **Captures happen at their exact time**, inside an update interval, and the team plans again at
  once. The paper looks for captures at the end of each interval of 0.01; its times are multiples of
  that, so small differences vanish in them. "1" stands here for the histogram's middle bin,
  1 ± 0.005.
- **The pursuer is committed.** The team's plan makes several capture sequences equally good, so a
  pursuer that chooses the best one anew at every update flips between them and goes nowhere. Ours
  keeps its sequence unless another is better by {margin}. That is rare, and explains only some of
  the ratios below 0.9: there are such starts where it never changed its mind. Ratios above 1 occur
  because the order comes from the visible game, and needn't be the best one against the hidden one.
- **Plans are local maxima.** The max-min problem has several, more for larger teams. The paper
  solves it with `fminimax` and doesn't say from where; here the best of {starts} starts is flown,
  and {restarts} new ones are followed after a capture. Another local maximum is another game, and
  where the visible and the hidden team come to different ones, their times differ.
- **Turns are signed**, up to a half turn to either side, where the paper gives a goal heading and
  takes the shorter way. The set of plans is the same.
- **The starts are other ones.** 500 of them leave the uncertainty that the tables give.
- Fig. 5 of the paper doesn't say whether its pursuer is visible. Both are shown; hidden, it follows
  the sequence that is best against the announced plans, with the same commitment.
"""


def report(
    game: Game,
    fig4: StudyResult,
    assured: StudyResult,
    fig5: StudyResult,
    contingent: StudyResult,
) -> str:
    """Return the report. It shows fig3.svg, fig4.svg and fig5.svg from its own folder."""
    ratios, gains = survival_ratios(fig4), turn_rate_gains(fig5)
    sections = [
        _head(fig4, assured, fig5, contingent),
        _claims([*fig4_claims(ratios), *fig5_claims(gains)]),
        _fig3(game),
        _fig4(ratios, guarantee_ratios(fig4)),
        _assured(fig4, assured),
        _fig5(gains, contingent.study["starts"]),
        _contingent(contingent),
        _definitions(fig4),
        _again(fig4, fig5),
    ]
    return "\n".join(sections)


def _head(*results: StudyResult) -> str:
    games = sum(each.manifest["games"] for each in results)
    fig4 = results[0]
    return f"""\
# The paper's section V, played again

S.-Y. Liu, Z. Zhou, C. Tomlin and J. K. Hedrick, *Evasion of a Team of Dubins Vehicles from a Hidden
Pursuer* (ICRA 2014), Figs. 3 to 5: {games:,} games from {counted(fig4.study["starts"], "start")}.
"""


def _claims(claims: Iterable[Claim]) -> str:
    rows = [(each.paper, each.ours, f"**{each.verdict}**") for each in claims]
    return "## What the paper says, and what came out\n\n" + _table(
        ("The paper", "Here", "Verdict"), rows
    )


def _fig3(game: Game) -> str:
    captures = zip(game.capture_sequence, game.capture_times, strict=True)
    told = ", ".join(f"evader {i} at {time:.3f}" for i, time in captures)
    return f"""\
## Fig. 3: a team against a hidden pursuer

![Four moments of a game](fig3.svg)

*Triangle: the pursuer. Circles: the evaders. Grey disk: where the pursuer can be, for all that the
team knows; cross: its centre. Solid: flown; broken: planned. Hollow: predicted captures.*

The paper prints no coordinates, so the start is one of ours that plays alike. The first plan
guaranteed {game.guarantee:.3f}, and the team survived {game.survival_time:.3f}: {told}.
"""


def _fig4(ratios: Mapping[int, Floats], bounds: Mapping[int, Floats]) -> str:
    rows = [
        (
            str(size),
            str(len(values)),
            *(f"{q:.3f}" for q in np.quantile(values, (0.0, 0.05, 0.5, 0.95, 1.0))),
            str(int((values > 0.99).sum())),
            str(int((values > 0.9).sum())),
            f"{np.median(bounds[size]):.3f}",
        )
        for size, values in ratios.items()
    ]
    heads = ("N", "starts", "least", "5 %", "median", "95 %", "most", "> 0.99", "> 0.9")
    return f"""\
## Fig. 4: hidden against visible

![Histograms of the ratio of survival times](fig4.svg)

*Survival time against a hidden pursuer over that against a visible one, which captured in the same
order, from the same start. Bins are 0.01 wide, that at 1 in another colour; dotted: 0.9. Line: the
same with the assured pursuer.*

{_table((*heads, "visible / guarantee"), rows)}
The last column is the median of the time that the visible team survived over what its first plan
guaranteed.
"""


def _assured(fig4: StudyResult, assured: StudyResult) -> str:
    """Return the table of two pursuers of the visible game, from the starts that both played."""
    rows = [
        (
            str(size),
            name,
            str(len(ratios)),
            f"{float((np.abs(ratios - 1.0) < AT_ONE).mean()):.2f}",
            f"{ratios.min():.3f}",
            f"{visible.mean():.3f}",
        )
        for size in assured.study["grid"]["team_size"]
        for name, result in (("committed", fig4), ("assured", assured))
        for hidden, visible in [both_times(result, size, assured.study["starts"])]
        for ratios in [hidden / visible]
    ]
    heads = ("N", "pursuer", "starts", f"within {AT_ONE} of 1", "least", "mean visible survival")
    return f"""\
The assured pursuer follows the order of capture with the earliest time by which everybody is
captured whatever the team does, and takes another order only for an earlier time. From the same
starts:

{_table(heads, rows)}"""


def _fig5(gains: Mapping[str, Gains], starts: int) -> str:
    tables = "\n".join(_gains_table(word, each) for word, each in gains.items())
    return f"""\
## Fig. 5: what a higher turning rate brings

![Mean survival time over the turning rate](fig5.svg)

*Mean survival time over that at the lowest turning rate, from the same starts. Bars: 95 %
confidence by the delta method for the ratio of two paired means. Broken lines: teams that answer
captures, the solid lines times the ratios of the last table here, from
{counted(starts, "start")}.*

{tables}"""


def _contingent(contingent: StudyResult) -> str:
    """Return the table of teams that answer captures, relative to the paper's."""
    depth = contingent.study["grid"]["evaders"][1]["depth"]
    the_same = f"the same {counted(contingent.study['starts'], 'start')}"
    return f"""\
A team that answers captures plans, too, what those left do after the next {depth} captures. The
ratios are to the paper's team at the same turning rate, from {the_same}. The pursuer is hidden: a
visible one that is committed may never capture everybody of such a team.

{_gains_table(HIDDEN, answer_gains(contingent), skipped=0)}"""


def _gains_table(word: str, gains: Gains, skipped: int = 1) -> str:
    rows = [
        (
            str(size),
            _estimate(gains.survival[size][0]),
            *(_estimate(each) for each in row[skipped:]),
        )
        for size, row in gains.ratios.items()
    ]
    rates = [f"{rate / math.pi:g} π" for rate in gains.turn_rates]
    heads = ("N", f"mean time at {rates[0]}", *(f"ratio at {rate}" for rate in rates[skipped:]))
    return f"Against a {word} pursuer:\n\n{_table(heads, rows)}"


def _definitions(fig4: StudyResult) -> str:
    grid = fig4.study["grid"]
    margin = grid["pursuer"][0]["margin"]
    evaders = grid["evaders"][0]
    return _DEFINITIONS.format(
        margin=f"{100 * margin:g} %", starts=evaders["starts"], restarts=evaders["restarts"]
    )


def _again(fig4: StudyResult, fig5: StudyResult) -> str:
    versions = fig4.manifest["versions"]
    told = ", ".join(f"{name} {versions[name]}" for name in ("covey", "python", "numpy", "numba"))
    machine = fig4.manifest["machine"]
    return f"""\
## To look closer

Every game is a row of `{fig4.folder.name}/games/` and `{fig5.folder.name}/games/`, Parquet data
sets that pandas, polars and DuckDB open; `manifest.json` beside them tells the study, the seed,
the versions and the machine ({told}; {machine["processor"]}, {machine["system"]}).
"""


def _estimate(each: Estimate) -> str:
    """Write a number with its uncertainty, which a single start doesn't tell."""
    if math.isnan(each.error):
        return f"{each.value:.3f}"
    return f"{each.value:.3f} ± {each.error:.3f}"


def _table(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    lines = [heads, ["---"] * len(heads), *rows]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)
