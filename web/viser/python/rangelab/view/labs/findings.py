"""What a run or averages teach, in one to three sentences: the page's rule of what is said."""

from collections.abc import Iterable
from dataclasses import dataclass

MOST_SENTENCES = 3
MOST_CHARACTERS = 230
"""More than this nobody reads while the scene moves."""
COUNTS = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"]


@dataclass(frozen=True)
class Finding:
    """Something worth saying."""

    text: str
    weight: float
    """How much it matters; a few of the weightiest are said."""


def weightiest(found: Iterable[Finding | None]) -> str:
    """The weightiest findings in one to three sentences, in the order in which they are given."""
    given = [each for each in found if each is not None]
    chosen: set[Finding] = set()
    length = 0
    for each in sorted(given, key=lambda finding: -finding.weight):
        length += len(each.text) + 1
        if chosen and (len(chosen) == MOST_SENTENCES or length > MOST_CHARACTERS):
            break
        chosen.add(each)
    return " ".join(each.text for each in given if each in chosen)


def first_stopped(stopped: Iterable[tuple[int, str, str]]) -> Finding | None:
    """Who gave up first, by the step, why and who; the others are counted."""
    gone = list(stopped)
    if not gone:
        return None
    step, why, label = min(gone, key=lambda each: each[0])
    others = f", and {count_of(len(gone) - 1)} more" if len(gone) > 1 else ""
    return Finding(f"{label} stopped at step {step + 1}{others}: {as_sentence(why)}", 100)


def count_of(count: int) -> str:
    """Small numbers as words, others as digits."""
    return COUNTS[count] if count < len(COUNTS) else str(count)


def as_sentence(text: str) -> str:
    """What the crate says, with a full stop, and formulas as they are written by hand."""
    written = text.replace("||s||^2", "‖s‖²")
    return written if written.endswith((".", "!", "?")) else f"{written}."
