"""Tables: rows of plain numbers, and frames of pandas and polars where those are installed."""

import csv
import io
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import pandas
    import polars

Row = dict[str, Any]


def flat(figures: dict[str, Any], prefix: str = "") -> Row:
    """Figures with standard errors as pairs of columns, `nees` and `nees_standard_error`; lists are left out."""
    row: Row = {}
    for key, value in figures.items():
        name = f"{prefix}{key}"
        if isinstance(value, dict) and value.keys() == {"value", "standard_error"}:
            row[name], row[f"{name}_standard_error"] = value["value"], value["standard_error"]
        elif isinstance(value, dict):
            row.update(flat(value, f"{name}_"))
        elif not isinstance(value, list):
            row[name] = value
    return row


def rows_of_report(report: Row) -> list[Row]:
    """A row for each estimator, bound or threshold and each epoch or point of a study's report."""
    if "rows" in report:
        return [{"name": "et-kf", **flat(row)} for row in report["rows"]]
    if "instants" in report:
        return _rows_of_kinematics(report)
    points = [flat(point) for point in report.get("points", [])]
    rows: list[Row] = []
    for kind in ("estimators", "filters", "bounds"):
        for part in report.get(kind, []):
            rows += _rows_of_part(part, points)
    return rows


def name_of(part: Row) -> str:
    """The name of an estimator or bound; bounds on relative kinematics have a label only."""
    return str(part.get("name", part["label"]))


def _rows_of_kinematics(report: Row) -> list[Row]:
    """For each estimator and bound a row an order of coefficients, then one an instant of positions."""
    rows: list[Row] = []
    for part in [*report["estimators"], *report["bounds"]]:
        figures = part.get("summary", part)
        keyed = ("order", range(len(figures["coefficients"]) + len(figures["gram"])), ("coefficients", "gram"))
        for key, places, kinds in (keyed, ("instant", report["instants"], ("positions", "aligned_positions"))):
            for k, place in enumerate(places):
                found = {kind: _exact(figures[kind][k]) for kind in kinds if k < len(figures[kind])}
                if found:
                    rows.append({"name": name_of(part), key: place, **flat(found)})
    return rows


def _exact(figure: Any) -> Any:
    """A figure of a bound is certain."""
    return figure if isinstance(figure, dict) else {"value": figure, "standard_error": 0.0}


def _rows_of_part(part: Row, points: list[Row]) -> Iterator[Row]:
    named = {"name": part["name"]}
    if "summary" in part:
        yield {**named, **flat(part["summary"])}
    for k, step in enumerate(part.get("steps", [])):
        if step.get("trials", 0) or step.get("failures", 0):
            yield {**named, "step": k, **flat(step)}
    for point, found in zip(points, part.get("points", []), strict=False):
        yield {**named, **point, **flat(found)}


def columns_of_csv(text: str) -> dict[str, list[Any]]:
    """The columns of comma-separated values: whole numbers, numbers (the same bits) or texts; None where empty."""
    header, *rows = csv.reader(io.StringIO(text))
    return {name: _column([row[i] for row in rows]) for i, name in enumerate(header)}


def _column(cells: list[str]) -> list[Any]:
    for kind in (int, float):
        try:
            return [kind(cell) if cell else None for cell in cells]
        except ValueError:
            continue
    return list(cells)


def csv_to_pandas(text: str) -> "pandas.DataFrame":
    """A frame from comma-separated values."""
    import pandas

    return pandas.DataFrame(columns_of_csv(text))


def csv_to_polars(text: str) -> "polars.DataFrame":
    """The same for polars."""
    import polars

    return polars.DataFrame(columns_of_csv(text), strict=False)


def rows_to_pandas(rows: list[Row]) -> "pandas.DataFrame":
    """A frame from rows; what a row lacks is missing."""
    import pandas

    return pandas.DataFrame(rows)


def rows_to_polars(rows: list[Row]) -> "polars.DataFrame":
    """The same for polars."""
    import polars

    return polars.DataFrame(rows, infer_schema_length=None)
