"""Chunks that are done, in a folder: a sweep that was ended goes on from there."""

import os
import tempfile
from pathlib import Path

import numpy as np

from ..arrays import Floats
from .chunks import Chunk


class Store:
    """Done chunks by their keys; without a folder they are kept in memory."""

    def __init__(self, folder: str | Path | None) -> None:
        self._folder = None if folder is None else Path(folder)
        self._known: dict[str, Floats] = {}
        if self._folder is not None:
            self._folder.mkdir(parents=True, exist_ok=True)

    def get(self, chunk: Chunk) -> Floats | None:
        """The numbers of a chunk, if it is done."""
        if chunk.key not in self._known and self._folder is not None:
            path = self._folder / f"{chunk.key}.npy"
            if path.exists():
                self._known[chunk.key] = np.load(path, allow_pickle=False)
        return self._known.get(chunk.key)

    def put(self, chunk: Chunk, numbers: Floats) -> None:
        """Keeps a chunk; on disk it is there wholly or not at all."""
        self._known[chunk.key] = numbers
        if self._folder is None:
            return
        handle, name = tempfile.mkstemp(dir=self._folder, suffix=".part")
        with os.fdopen(handle, "wb") as file:
            np.save(file, numbers, allow_pickle=False)
        Path(name).replace(self._folder / f"{chunk.key}.npy")
