"""The read-out: a table of errors, of one row for each estimator and bound, units in its head."""

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

import numpy as np
import viser

from ..arrays import Floats
from .looks import Look
from .themes import Theme

MARKS = {"disc": "●", "ring": "○", "square": "■", "triangle": "▲", "diamond": "◆", "cross": "✕"}
BOUND_MARK = "╌"
LARGE, SMALL = 1e6, 1e-4
"""Numbers beyond these are written with an exponent."""


@dataclass(frozen=True)
class Row:
    """What one estimator or bound reached."""

    look: Look
    numbers: tuple[float, ...]
    remark: str = ""
    """Why there are no numbers; told in their place."""


@dataclass(frozen=True)
class Table:
    """The numbers of a step."""

    groups: tuple[tuple[str, tuple[str, ...]], ...]
    """What columns are of, and their heads with units."""
    rows: tuple[Row, ...]
    told: str = ""
    """What there is to be told of them, in sentences above them."""

    def html(self, theme: Theme) -> str:
        """As the browser shows it, marks in the colours of the theme."""
        over = "".join(_head(title, len(heads), 600) for title, heads in self.groups)
        below = "".join(_head(head) for _, heads in self.groups for head in heads)
        body = "".join(_row(row, sum(len(heads) for _, heads in self.groups), theme) for row in self.rows)
        told = f"<p style='margin:0.3rem 0 0.5rem;font-size:0.85rem'>{escape(self.told)}</p>" if self.told else ""
        return (
            "<div style='padding:0 1rem 0.4rem 0.5rem;font-size:0.75rem;line-height:1.3;overflow-x:auto'>"
            f"{told}<table style='width:100%;border-collapse:collapse;font-variant-numeric:tabular-nums'>"
            f"<thead><tr><td></td>{over}</tr><tr><td></td>{below}</tr></thead><tbody>{body}</tbody></table></div>"
        )


class Readout:
    """The table of a panel; it is sent where it changes."""

    def __init__(self, server: viser.ViserServer) -> None:
        self._handle = server.gui.add_html("", visible=False)

    def show(self, table: Table, theme: Theme) -> None:
        """Shows a table; none where it has nothing."""
        self._handle.visible = bool(table.rows or table.told)
        text = table.html(theme)
        if self._handle.content != text:
            self._handle.content = text


def root_mean_square(errors: Floats) -> float:
    """Over what is known; NaN where nothing is."""
    known = errors[np.isfinite(errors)]
    return float(np.sqrt(np.mean(known**2))) if len(known) else float("nan")


def reading(value: float) -> str:
    """Three digits, as the page writes them."""
    size = abs(value)
    if not np.isfinite(value):
        return "–"
    if size == 0:
        return "0"
    if size >= LARGE or size < SMALL:
        mantissa, exponent = f"{value:.1e}".split("e")
        return f"{mantissa}e{int(exponent)}".replace("-", "−")
    digits = 0 if size >= 100 else max(0, 2 - int(np.floor(np.log10(float(f"{size:.2e}")))))
    return f"{value:.{digits}f}".replace("-", "−")


def _head(text: str, columns: int = 1, weight: int = 400) -> str:
    lines = "<br>".join(escape(line) for line in text.split("\n"))
    style = "padding:0 0 0 0.4rem;vertical-align:bottom;text-align:right"
    return f"<th colspan={columns} scope=col style='{style};font-weight:{weight}'>{lines}</th>"


def _row(row: Row, columns: int, theme: Theme) -> str:
    mark = BOUND_MARK if row.look.token == "bound" else MARKS[row.look.mark]
    name = f"<span style='color:{theme.css(row.look.token)}'>{mark}</span> {escape(row.look.label)}"
    head = f"<th scope=row style='text-align:left;font-weight:500'>{name}</th>"
    if row.remark:
        return f"<tr>{head}<td colspan={columns} style='padding-left:0.4rem'>{escape(row.remark)}</td></tr>"
    return f"<tr>{head}{_cells(row.numbers)}</tr>"


def _cells(numbers: Sequence[float]) -> str:
    return "".join(f"<td style='padding-left:0.4rem;text-align:right'>{reading(number)}</td>" for number in numbers)
