"""A study of many trials with plots of its own, which stand in place of those of one run."""

from abc import ABC, abstractmethod
from typing import Any

from .plots import Plot


class StudyPage(ABC):
    """What many trials of a document gave; a document is a dictionary here."""

    asked: int
    """Trials that were asked for."""

    @property
    @abstractmethod
    def trials(self) -> int:
        """Trials that were run: fewer where the study was stopped."""

    @abstractmethod
    def holds_for(self, source: Any) -> bool:
        """Whether it is the same study of another scenario: one that differs in nothing that it depends on."""

    @abstractmethod
    def plots(self, document: dict[str, Any]) -> list[Plot]:
        """With what is marked in them by the document."""

    @abstractmethod
    def sentence(self, document: dict[str, Any]) -> str:
        """What the plots show."""
