"""How far something in the background is: a bar while it goes on, and a sentence."""

import viser

from .values import put


class ProgressLine:
    """In the container that is open."""

    def __init__(self, gui: viser.GuiApi) -> None:
        self._said = gui.add_markdown("", visible=False)
        self._bar = gui.add_progress_bar(0.0, visible=False)

    def tell(self, share: float | None, sentence: str) -> bool:
        """A share, or None at the end; False where the panel is gone, as it may be at any moment: with another lab."""
        try:
            self._bar.visible = share is not None
            if share is not None:
                put(self._bar, 100 * share)
            self._said.visible = bool(sentence)
            self._said.content = sentence
        except RuntimeError:
            return False
        return True
