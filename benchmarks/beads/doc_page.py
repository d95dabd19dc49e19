"""Puts what a script prints into a page, between two markers that carry its name."""


def replace_between_markers(path, name, text):
    """Replaces what lies between `<!-- NAME -->` and `<!-- /NAME -->`; ValueError where the markers are not there."""
    with open(path) as file:
        page = file.read()
    start, end = f"<!-- {name} -->\n", f"<!-- /{name} -->"
    if start not in page or end not in page:
        raise ValueError(f"{path}: no markers for {name}")
    head, rest = page.split(start, 1)
    with open(path, "w") as file:
        file.write(head + start + "\n" + text.strip() + "\n\n" + end + rest.split(end, 1)[1])
