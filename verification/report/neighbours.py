"""The picture of a requirement's neighbours: sources above, requirements of the same source beside it, what shows it below. [SRS_VER_095]"""

WIDTH, HEIGHT, GAP, COLUMNS, LETTERS = 172, 26, 8, 2, 23
SIDE, MIDDLE = 104, 136
MOST = 6


class Box:
    def __init__(self, text, href, kind="", title=""):
        self.text = text if len(text) <= LETTERS else text[:LETTERS - 1] + "…"
        self.href, self.kind, self.title = href, kind, title or text
        self.x, self.y, self.width, self.height = 0, 0, WIDTH, HEIGHT

    def at(self, x, y, width=WIDTH, height=HEIGHT):
        self.x, self.y, self.width, self.height = x, y, width, height
        return self

    @property
    def middle(self):
        return self.x + self.width / 2


def shortened(boxes, most, href):
    return boxes if len(boxes) <= most else [*boxes[:most - 1], Box(f"{len(boxes) - most + 1} more", href)]


def rows(boxes, top):
    """Places boxes in two columns; answers where the next thing may stand."""
    for number, box in enumerate(boxes):
        box.at((number % COLUMNS) * (WIDTH + GAP) + GAP / 2, top + (number // COLUMNS) * (HEIGHT + GAP))
    return top + -(-len(boxes) // COLUMNS) * (HEIGHT + GAP)


def picture(uid, above, before, after, below):
    """What the template draws: boxes and lines in a field 360 wide."""
    above, below = shortened(above, MOST, "#sources"), shortened(below, MOST, "#shown")
    top = rows(above, GAP / 2) + 2 * GAP
    tall = 2 * HEIGHT + GAP
    own = Box(uid, "", "own").at(SIDE + GAP, top, MIDDLE, tall)
    sides = []
    for x, boxes in ((GAP / 2, before[-2:]), (SIDE + MIDDLE + 1.5 * GAP, after[:2])):
        for number, box in enumerate(boxes):
            sides.append(box.at(x, top + number * (HEIGHT + GAP), SIDE - 4))
    bottom = top + tall
    end = rows(below, bottom + 3 * GAP)
    lines = [(box.middle, box.y + HEIGHT, own.middle, top) for box in above] + [(own.middle, bottom, box.middle, box.y) for box in below]
    return {"boxes": [*above, *sides, own, *below], "lines": lines, "width": 2 * (WIDTH + GAP), "height": end}
