"""The result of a sweep: a table, and what it is a table of."""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..frames import Row, rows_to_pandas, rows_to_polars
from ..html import table

if TYPE_CHECKING:
    import pandas
    import polars

_KEY = b"rangelab"


@dataclass(frozen=True)
class Sweep:
    """A row for each point of the grid, estimator or bound, and step; beside each figure its standard error."""

    rows: list[Row]
    about: dict[str, Any]
    """`version`, `kind`, `trials`, `grid` and the `scenario` whose values the grid replaces."""

    def to_pandas(self) -> "pandas.DataFrame":
        """The table as a pandas frame (extra `frames`)."""
        return rows_to_pandas(self.rows)

    def to_polars(self) -> "polars.DataFrame":
        """The table as a polars frame (extra `frames`)."""
        return rows_to_polars(self.rows)

    def to_parquet(self, path: str | Path) -> None:
        """Writes the table as Parquet, with `about` inside (extra `sweep`)."""
        import pyarrow as arrow
        import pyarrow.parquet as parquet

        names = list(dict.fromkeys(name for row in self.rows for name in row))
        columns = {name: [_cell(row.get(name)) for row in self.rows] for name in names}
        made = arrow.table(columns).replace_schema_metadata({_KEY: json.dumps(self.about).encode()})
        parquet.write_table(made, path)

    @classmethod
    def from_parquet(cls, path: str | Path) -> "Sweep":
        """Reads what `to_parquet` wrote."""
        import pyarrow.parquet as parquet

        made = parquet.read_table(path)
        rows = [{name: value for name, value in row.items() if value is not None} for row in made.to_pylist()]
        return cls(rows, json.loads((made.schema.metadata or {})[_KEY]))

    def __repr__(self) -> str:
        about = self.about
        return f"<rangelab.sweep.Sweep of {', '.join(about['grid'])}: {about['trials']} trials a point>"

    def _repr_html_(self) -> str:
        shown = list(
            dict.fromkeys([*self.about["grid"], "name", "step", "rmse_position", "rms_angle", "position", "angle"])
        )
        header = [name for name in shown if any(name in row for row in self.rows)]
        last: dict[str, Row] = {}
        for row in self.rows:
            last[json.dumps([row.get(name) for name in [*self.about["grid"], "name"]])] = row
        cells = [[_text(row.get(name)) for name in header] for row in last.values()]
        return table(repr(self)[1:-1], header, cells)


def _cell(value: Any) -> Any:
    """A list or dictionary of a grid as its JSON."""
    return json.dumps(value) if isinstance(value, list | dict) else value


def _text(value: Any) -> str:
    return f"{value:.4g}" if isinstance(value, float) else "" if value is None else str(value)
