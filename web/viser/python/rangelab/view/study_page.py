"""A study of many trials with plots of its own, which stand in place of those of one run."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any

from ..studies import Study
from .plots import Plot


@dataclass(frozen=True, eq=False)
class StudyPage(ABC):
    """What many trials of a document gave; a document is a dictionary here."""

    of: Any
    """What was studied: the `subject` of the scenario."""
    asked: int
    """Trials that were asked for."""

    @staticmethod
    @abstractmethod
    def subject(scenario: Any) -> Any:
        """What the study depends on."""

    @property
    @abstractmethod
    def trials(self) -> int:
        """Trials that were run: fewer where the study was stopped."""

    @abstractmethod
    def plots(self, document: dict[str, Any]) -> list[Plot]:
        """With what is marked in them by the document."""

    @abstractmethod
    def sentence(self, document: dict[str, Any]) -> str:
        """What the plots show."""

    def holds_for(self, source: Any) -> bool:
        """Whether it is the same study of another scenario: one that differs in nothing that it depends on."""
        return bool(self.subject(source) == self.of)


@dataclass(frozen=True, eq=False)
class PageOfStudy(StudyPage):
    """One that shows a study of the crate."""

    study: Study

    @property
    def trials(self) -> int:
        """Trials that were run."""
        return self.study.trials
