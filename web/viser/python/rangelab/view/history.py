"""Undo and redo over immutable states."""

from typing import Generic, TypeVar

State = TypeVar("State")
DEPTH = 500


class History(Generic[State]):
    """States in their order; what belongs to one gesture, such as a drag, is one entry."""

    def __init__(self, present: State) -> None:
        self.present = present
        """The state that is."""
        self._past: list[State] = []
        self._future: list[State] = []
        self._gesture = ""

    @property
    def before(self) -> State | None:
        """The state that was before the last entry; None at the beginning."""
        return self._past[-1] if self._past else None

    def edit(self, state: State, gesture: str = "") -> None:
        """Another state; states of the same gesture in a row are one entry, those without any are one each."""
        if not gesture or gesture != self._gesture:
            self._past = [*self._past[1 - DEPTH :], self.present]
        self._gesture, self._future, self.present = gesture, [], state

    def amend(self, state: State) -> None:
        """The same entry in another form."""
        self.present = state

    def undo(self) -> bool:
        """Back to before the last entry; False at the beginning."""
        return self._go(self._past, self._future)

    def redo(self) -> bool:
        """Forth to the entry that was taken back; False where there is none."""
        return self._go(self._future, self._past)

    def _go(self, source: list[State], to: list[State]) -> bool:
        self._gesture = ""
        if not source:
            return False
        to.append(self.present)
        self.present = source.pop()
        return True
