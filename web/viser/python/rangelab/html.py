"""What a notebook shows."""

from collections.abc import Mapping, Sequence
from html import escape


def card(title: str, subtitle: str, rows: Mapping[str, str]) -> str:
    """A title, a sentence and a table of names and values."""
    lines = "".join(
        f"<tr><th style='text-align:left'>{escape(k)}</th><td>{escape(v)}</td></tr>" for k, v in rows.items()
    )
    return f"<div><b>{escape(title)}</b><br>{escape(subtitle)}<table>{lines}</table></div>"


def table(title: str, header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A title and a table; its first column is text, the others are numbers."""
    head = "".join(f"<th>{escape(cell)}</th>" for cell in header)
    body = "".join("<tr>" + "".join(_cell(i, cell) for i, cell in enumerate(row)) + "</tr>" for row in rows)
    return f"<div><b>{escape(title)}</b><table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>"


def _cell(index: int, cell: str) -> str:
    style = "left" if index == 0 else "right; font-variant-numeric: tabular-nums"
    return f"<td style='text-align:{style}'>{escape(cell)}</td>"
