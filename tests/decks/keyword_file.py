"""A reader of LS-DYNA keyword files, written from the keyword manual (standard format) for the tests alone."""
import collections

Set = collections.namedtuple("Set", "title members")


def fields(line, widths):
    """The columns of a card, blanks cut off; missing ones are empty."""
    out, at = [], 0
    for width in widths:
        out.append(line[at:at + width].strip())
        at += width
    return out


class KeywordFile:
    """Nodes, shells, parts, sections, materials and sets of a file; keywords in their order."""

    def __init__(self, path):
        self.keywords, self.nodes, self.shells = [], {}, {}
        self.parts, self.sections, self.materials = {}, {}, {}
        self.node_sets, self.shell_sets = {}, {}
        keyword, cards = None, []
        with open(path, encoding="ascii") as file:
            for line in file.read().splitlines():
                if line.startswith("$"):
                    continue
                if line.startswith("*"):
                    self.take(keyword, cards)
                    keyword, cards = line.strip().upper(), []
                    self.keywords.append(keyword)
                else:
                    assert len(line) <= 80, line
                    cards.append(line)
        self.take(keyword, cards)
        assert self.keywords[0] == "*KEYWORD" and self.keywords[-1] == "*END"

    def take(self, keyword, cards):
        if keyword == "*NODE":
            for card in cards:
                node, x, y, z = fields(card, (8, 16, 16, 16))
                assert int(node) not in self.nodes
                self.nodes[int(node)] = (float(x), float(y), float(z))
        elif keyword == "*ELEMENT_SHELL":
            for card in cards:
                shell, part, *corners = map(int, fields(card, (8,) * 6))
                assert shell not in self.shells
                self.shells[shell] = (part, corners[:3] if corners[2] == corners[3] else corners)
        elif keyword == "*PART":
            part, section, material = map(int, fields(cards[1], (10,) * 3))
            self.parts[part] = (cards[0].strip(), section, material)
        elif keyword == "*SECTION_SHELL_TITLE":
            section, *_ = fields(cards[1], (10,) * 4)
            self.sections[int(section)] = [float(t) for t in fields(cards[2], (10,) * 4)]
        elif keyword == "*MAT_ELASTIC_TITLE":
            material, density, modulus, poisson = fields(cards[1], (10,) * 4)
            self.materials[int(material)] = (float(density), float(modulus), float(poisson))
        elif keyword in ("*SET_NODE_LIST_TITLE", "*SET_SHELL_LIST_TITLE"):
            members = [int(word) for card in cards[2:] for word in fields(card, (10,) * 8) if word]
            sets = self.node_sets if "NODE" in keyword else self.shell_sets
            sets[int(cards[1][:10])] = Set(cards[0].strip(), members)
