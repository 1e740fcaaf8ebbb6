"""A store's page, served by Python's own process: what a notebook's cell shows."""

import json
import subprocess
import sys
import urllib.error
import urllib.request

import pytest

import marketgen


def answer(address, path):
    with urllib.request.urlopen(address + path, timeout=60) as got:
        return got.read(), got.headers


def test_a_store_shows_its_page(store):
    with store.show(height=480) as view:
        page, headers = answer(view.address, "")
        assert b"<html" in page and "http://localhost:*" in headers["Content-Security-Policy"]
        told = json.loads(answer(view.address, "api/stores")[0])["stores"]
        assert [(one["scene_hash"], one["products"]) for one in told] == [
            (store.manifest["scene_hash"], store.manifest["counts"]["products"])
        ]
        shown = view._repr_html_()
        assert f"<iframe src='{view.address}'" in shown and "height:480px" in shown
        assert not view.closed
    assert view.closed and "closed" in view._repr_html_()
    view.close()
    with pytest.raises(urllib.error.URLError):
        answer(view.address, "")


def test_two_views_are_served_side_by_side(store):
    with store.show() as one, store.show() as other:
        assert one.address != other.address
        assert answer(one.address, "api/stores")[0] == answer(other.address, "api/stores")[0]


@pytest.mark.parametrize(
    "arguments, where", [({"height": 10}, "height"), ({"port": 70000}, "port"), ({"port": "http"}, "port")]
)
def test_what_it_cannot_be_given_is_said(store, arguments, where):
    with pytest.raises(marketgen.Error) as caught:
        store.show(**arguments)
    assert (caught.value.code, caught.value.where) == ("usage.bad_flag", where)


def test_a_port_that_is_taken_is_said(store):
    with store.show() as view:
        port = int(view.address.rstrip("/").rsplit(":", 1)[1])
        with pytest.raises(marketgen.Error) as caught:
            store.show(port=port)
        assert caught.value.code == "server.cannot_listen"


def test_python_ends_with_a_view_open(store):
    script = f"import marketgen; view = marketgen.open_store({store.folder!r}).show(); print(view.address)"
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120)
    assert (run.returncode, run.stderr) == (0, "") and run.stdout.startswith("http://127.0.0.1:")
