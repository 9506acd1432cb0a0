"""A hook of mkdocs: the examples have one page each, which the navigation lists without naming them one by one."""
from pathlib import Path


def on_config(config):
    pages = Path(config["docs_dir"])
    examples = sorted(path.relative_to(pages).as_posix() for path in pages.glob("examples/*.md"))
    if examples:
        config["nav"].insert(2, {"Examples": examples})
    return config
