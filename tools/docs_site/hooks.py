"""What the pages need to be a site that opens from its folder: MkDocs calls these as it goes."""

import re

REMOTE_SCRIPT = "https://unpkg.com/iframe-worker/shim"  # by which the search works without a server


def on_page_markdown(markdown, page, config, files):
    """Code hosts take a heading's address in any case, MkDocs in lower case alone."""
    return re.sub(r"\]\(#([^)]+)\)", lambda link: f"](#{link[1].lower()})", markdown)


def on_post_page(output, page, config):
    return output.replace(REMOTE_SCRIPT, page.url.count("/") * "../" + "shim.js")


def on_post_template(output, template_name, config):  # 404.html, which is shown at any address
    return output.replace(REMOTE_SCRIPT, "/shim.js")
