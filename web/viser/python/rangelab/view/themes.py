"""The page's themes: colours and weights of lines; a test holds them against its style sheet."""

from collections.abc import Mapping
from dataclasses import dataclass

Rgb = tuple[int, int, int]


@dataclass(frozen=True)
class Theme:
    """One theme."""

    dark: bool
    """Whether the browser's own parts are dark."""
    weight: float
    """How many times as wide lines are drawn."""
    tokens: Mapping[str, str]
    """Colours by what they are for, as `#rrggbb`."""

    @property
    def letters(self) -> float:
        """How many times as large words in the scene are: read from the last row where lines are wide."""
        return 1.0 + 0.5 * (self.weight - 1.0)

    def css(self, token: str) -> str:
        """A colour as the page writes it."""
        return self.tokens[token]

    def rgb(self, token: str) -> Rgb:
        """A colour as bytes."""
        return bytes_of(self.tokens[token])


def bytes_of(colour: str) -> Rgb:
    """`#rrggbb` as bytes."""
    return int(colour[1:3], 16), int(colour[3:5], 16), int(colour[5:7], 16)


THEMES = {
    "light": Theme(
        dark=False,
        weight=1.0,
        tokens={
            "ink-soft": "#4b5360",
            "accent": "#005b9a",
            "warning": "#8a3200",
            "hatch": "#16191f",
            "scene": "#fafbfc",
            "grid": "#d5d9e0",
            "anchor": "#16191f",
            "truth": "#16191f",
            "range": "#8b93a1",
            "bound": "#4b5360",
            "no-bound": "#c9ced6",
            "kf": "#aa4000",
            "ortho": "#bd8600",
            "uc-kf": "#025192",
            "et-kf": "#b467a4",
            "eskf": "#448d65",
            "eskf-raw": "#575757",
        },
    ),
    "dark": Theme(
        dark=True,
        weight=1.0,
        tokens={
            "ink-soft": "#b3bac6",
            "accent": "#6cb8f5",
            "warning": "#ffb27a",
            "hatch": "#000000",
            "scene": "#13161b",
            "grid": "#2c323b",
            "anchor": "#f0f2f5",
            "truth": "#f0f2f5",
            "range": "#6d7686",
            "bound": "#b3bac6",
            "no-bound": "#9aa2b0",
            "kf": "#ee772b",
            "ortho": "#f8d56f",
            "uc-kf": "#71b9ff",
            "et-kf": "#db8ac0",
            "eskf": "#00c188",
            "eskf-raw": "#aeaeae",
        },
    ),
    "projector": Theme(
        dark=False,
        weight=1.7,
        tokens={
            "ink-soft": "#2c313a",
            "accent": "#004a80",
            "warning": "#7a2b00",
            "hatch": "#000000",
            "scene": "#ffffff",
            "grid": "#c6cbd3",
            "anchor": "#000000",
            "truth": "#000000",
            "range": "#7d8593",
            "bound": "#2c313a",
            "no-bound": "#c6cbd3",
            "kf": "#a2360a",
            "ortho": "#c18500",
            "uc-kf": "#004683",
            "et-kf": "#af5f94",
            "eskf": "#3f805c",
            "eskf-raw": "#504b50",
        },
    ),
}
