"""Small helpers for sentences."""

import re
from collections.abc import Sequence


def joined(names: Sequence[str]) -> str:
    """As a list in a sentence: "KF, UC-KF and ESKF"."""
    return " and ".join(filter(None, [", ".join(names[:-1]), *names[-1:]]))


def start_of(text: str) -> str:
    """With a capital letter, as sentences begin; symbols such as x stay as they are."""
    return text if re.match(r"\w\b", text, re.ASCII) else text[:1].upper() + text[1:]


def number(value: float) -> str:
    """As people write it: whole ones whole, others with six significant digits at most, a real minus."""
    return f"{value:.6g}".replace("-", "−")
