"""Errors by mode as an SVG of small plots side by side."""

WIDTH, HEIGHT, LEFT, TOP = 300, 200, 46, 34
COLOURS = ("#1565c0", "#e65100", "#8d6e63", "#9e9d24")


def plot_lines(x0, title, rows, highest):
    """SVG elements of one plot at x0: rows (size, name, elements, errors), errors in percent of modes 1, 2, ..."""
    x = lambda mode: x0 + LEFT + (mode - 1) * (WIDTH - LEFT - 20) / 9
    y = lambda error: TOP + HEIGHT * (1 - max(error, 0) / highest)
    out = [f'<text x="{x0 + LEFT}" y="{TOP - 14}" font-weight="bold">{title}</text>']
    for k in range(6):
        level = highest * k / 5
        out.append(f'<line x1="{x(1)}" x2="{x(10)}" y1="{y(level):.1f}" y2="{y(level):.1f}" stroke="#ccc"/>'
                   f'<text x="{x(1) - 6}" y="{y(level) + 4:.1f}" text-anchor="end">{level:g} %</text>')
    out += [f'<text x="{x(m):.1f}" y="{TOP + HEIGHT + 16}" text-anchor="middle">{m}</text>' for m in range(1, 11)]
    for number, (_, name, elements, errors) in enumerate(rows):
        colour = COLOURS[number % len(COLOURS)]
        points = " ".join(f"{x(m):.1f},{y(e):.1f}" for m, e in enumerate(abs(errors), 1))
        out.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="2"/>')
        out.append(f'<text x="{x(1)}" y="{TOP + HEIGHT + 36 + 15 * number}" fill="{colour}">{name}: {elements} elements</text>')
    return out


def error_plot(path, plots):
    """`plots`: (title, rows); all share one scale. The size of the error counts, without its sign."""
    largest = max(abs(r[3]).max() for _, rows in plots for r in rows)
    highest = next(s for s in (1, 2, 5, 10, 20, 25, 30, 40, 50, 75, 100, 1e9) if s >= largest)
    body = [line for i, (title, rows) in enumerate(plots) for line in plot_lines(i * WIDTH, title, rows, highest)]
    with open(path, "w") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH * len(plots)}" height="{TOP + HEIGHT + 100}" '
                   'font-family="sans-serif" font-size="12">\n<rect width="100%" height="100%" fill="white"/>\n' +
                   "\n".join(body) + "\n</svg>\n")
