"""Cracks across a strip of few layers of particles, from the damage of a frame."""

import numpy as np

BROKEN = 0.02  # [-] damage of a particle with broken bonds
THROUGH = 0.3  # [-] mean damage; beside a plane that cuts all bonds it is 0.35 and more


def is_through(place, height, damage, spacing):
    """Whether each layer of a column across the strip, one spacing long, has lost THROUGH of its bonds on average. `place` [m]: of the particles along the strip; `height` [m]."""
    column = np.floor((place - place.min()) / spacing + 1e-6).astype(int)
    layer = np.round((height - height.min()) / spacing).astype(int)
    cell = column * (layer.max() + 1) + layer
    count = (column.max() + 1) * (layer.max() + 1)
    mean = np.bincount(cell, damage, count) / np.maximum(np.bincount(cell, minlength=count), 1)  # 0 where a cell is empty
    return bool((mean.reshape(column.max() + 1, -1).min(axis=1) > THROUGH).any())
