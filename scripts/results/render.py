"""Draws particles and panels as a small solid scene, with numpy alone: everything becomes shaded dots in a depth buffer.

View: parallel, from `direction` (a vector from the scene to the eye), z up on the page unless said otherwise.
"""

import numpy as np

LIGHT = np.array([-0.45, 0.35, 0.82])  # in page axes: right, up, towards the eye


class Scene:
    def __init__(self, direction, up, pixels_per_metre, width, height, centre):
        towards = np.asarray(direction, float) / np.linalg.norm(direction)
        right = np.cross(up, towards)
        right /= np.linalg.norm(right)
        self.axes = np.array([right, np.cross(towards, right), towards])
        self.scale, self.size, self.centre = pixels_per_metre, (height, width), np.asarray(centre, float)
        self.colour = np.zeros((height, width, 4))
        self.depth = np.full(height * width, -np.inf)
        self.nearest = np.empty_like(self.depth)  # scratch of _dots

    def _dots(self, page, depth, colour):
        """Puts coloured dots, given far to near, where nothing nearer stands."""
        height, width = self.size
        column, row = np.floor(page[:, 0]).astype(int), np.floor(page[:, 1]).astype(int)
        seen = (column >= 0) & (column < width) & (row >= 0) & (row < height)
        pixel, depth, colour = (row * width + column)[seen], depth[seen], colour[seen]
        self.nearest[pixel] = depth  # of several on a pixel the last, that is the nearest
        nearer = depth >= np.maximum(self.nearest[pixel], self.depth[pixel])
        self.depth[pixel[nearer]] = depth[nearer]
        self.colour.reshape(-1, 4)[pixel[nearer]] = np.column_stack([colour[nearer], np.ones(nearer.sum())])

    def _to_page(self, points):
        """Pixels right and down, and the depth towards the eye [m]."""
        height, width = self.size
        x, y, depth = self.axes @ (np.asarray(points, float) - self.centre).T
        return np.column_stack([width / 2 + self.scale * x, height / 2 - self.scale * y]), depth

    def add_balls(self, centres, radius, colours):
        """Particles as balls [m] with colours (n, 3)."""
        page, depth = self._to_page(centres)
        order = np.argsort(depth)
        page, depth, colours = page[order], depth[order], np.asarray(colours)[order]
        reach = int(np.ceil(radius * self.scale))
        for i in range(-reach, reach + 1):
            for j in range(-reach, reach + 1):
                normal = np.array([i, -j, 0.0]) / (radius * self.scale)
                rest = 1 - normal @ normal
                if rest <= 0:
                    continue
                normal[2] = np.sqrt(rest)
                shade = 0.62 + 0.40 * max(0.0, normal @ LIGHT)
                self._dots(page + [i, j], depth + radius * normal[2], colours * shade)

    def add_panels(self, vertices, panels, colour, edge_colour, edge_width):
        """Flat panels, with edges of that width [m]."""
        for panel in panels:
            corners = np.asarray(vertices, float)[panel]
            normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
            normal = self.axes @ normal / np.linalg.norm(normal)
            if normal[2] <= 0:
                continue  # faces away
            shade = 0.45 + 0.55 * max(0.0, normal @ LIGHT)
            for a, b in zip(range(1, len(corners) - 1), range(2, len(corners))):
                self._triangle(corners[[0, a, b]], np.asarray(colour) * shade)
            for a, b in zip(corners, np.roll(corners, -1, axis=0)):
                self._edge(a, b, np.asarray(edge_colour) * shade, edge_width)

    def add_shells(self, corners, colour):
        """Triangles (n, 3, 3) by the hundred thousand, without edges, seen from both sides."""
        corners = np.asarray(corners, float)
        along, across = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        normals = np.cross(along, across) @ self.axes.T
        lengths = np.linalg.norm(normals, axis=1, keepdims=True)
        normals *= np.where(normals[:, 2:] < 0, -1, 1) / np.where(lengths > 0, lengths, 1)
        shades = 0.45 + 0.55 * np.maximum(0, normals @ LIGHT)
        longest = np.linalg.norm([along, across, across - along], axis=2).max(axis=0)
        steps = np.ceil(1.6 * self.scale * longest).astype(int) + 1
        steps = np.where(steps > 8, -(-steps // 8) * 8, steps)  # few sizes, so that many triangles go together
        for count in np.unique(steps):  # those of one size together
            own = np.flatnonzero(steps == count)
            s, t = (grid.ravel() for grid in np.meshgrid(np.linspace(0, 1, count), np.linspace(0, 1, count)))
            for u, v in zip(s[s + t <= 1], t[s + t <= 1]):
                page, depth = self._to_page(corners[own, 0] + u * along[own] + v * across[own])
                order = np.argsort(depth)
                self._dots(page[order], depth[order], np.outer(shades[own], colour)[order])

    def _triangle(self, corners, colour):
        steps = int(np.ceil(1.6 * self.scale * max(np.linalg.norm(corners - np.roll(corners, 1, axis=0), axis=1)))) + 1
        s, t = np.meshgrid(np.linspace(0, 1, steps), np.linspace(0, 1, steps))
        s, t = s[s + t <= 1], t[s + t <= 1]
        points = corners[0] + np.outer(s, corners[1] - corners[0]) + np.outer(t, corners[2] - corners[0])
        self._flat_dots(points, colour, 0)

    def _edge(self, a, b, colour, width):
        steps = int(np.ceil(2 * self.scale * np.linalg.norm(b - a))) + 1
        points = a + np.outer(np.linspace(0, 1, steps), b - a)
        spread = np.linspace(-width / 2, width / 2, max(1, int(np.ceil(width * self.scale))))
        for right in spread:
            for up in spread:
                self._flat_dots(points + right * self.axes[0] + up * self.axes[1], colour, width)

    def _flat_dots(self, points, colour, lift):
        page, depth = self._to_page(points)
        height, width = self.size
        column, row = np.floor(page[:, 0]).astype(int), np.floor(page[:, 1]).astype(int)
        seen = (column >= 0) & (column < width) & (row >= 0) & (row < height)
        pixel, depth = (row * width + column)[seen], depth[seen] + lift
        nearer = depth >= self.depth[pixel]
        self.depth[pixel[nearer]] = depth[nearer]
        self.colour.reshape(-1, 4)[pixel[nearer]] = [*colour, 1.0]

    def picture(self, fold=1):
        """Red, green, blue, opacity; `fold` pixels in each direction are averaged, which smooths the edges."""
        height, width = self.size
        blocks = self.colour.reshape(height // fold, fold, width // fold, fold, 4)
        opacity = blocks[..., 3:].mean(axis=(1, 3))
        colour = (blocks[..., :3] * blocks[..., 3:]).mean(axis=(1, 3)) / np.maximum(opacity, 1e-9)
        return np.clip(np.concatenate([colour, opacity], axis=-1), 0, 1)
