"""Stores from Python are the program's stores."""

import json
import pickle
import shutil
import warnings

import pytest

import marketgen
from conftest import PROMPT, run
from PIL import Image


def test_the_program_makes_the_same_store(store, tmp_path):
    run("generate", PROMPT, "-o", tmp_path / "shop", "--seed", 5, "--size", "9x7m", "--no-previews", "--quiet")
    made = json.loads((tmp_path / "shop" / "store.json").read_text())
    assert made["scene_hash"] == store.manifest["scene_hash"]
    assert made["look_hash"] == store.manifest["look_hash"]


def test_documents_are_the_files(store):
    folder = store.folder
    for name, document in (("store", store.manifest), ("plan", store.plan), ("report", store.report)):
        with open(f"{folder}/{name}.json", encoding="utf-8") as file:
            assert document == json.load(file)
    assert store.layout["schema"] == "market-layout/1"
    assert marketgen.open_store(folder).manifest == store.manifest


def test_queries_are_the_programs(store):
    for table in ("products", "fixtures", "zones", "prices", "materials", "planogram"):
        assert store.query(table) == json.loads(run("query", store.folder, table, "--format", "json"))
    some = store.query("products", "category=snacks")
    assert 0 < len(some) < len(store.query("products"))
    assert {row["category"] for row in some} == {"snacks"}


@pytest.mark.parametrize(
    ("code", "call"),
    [
        ("store.not_a_store", lambda store, tmp: marketgen.open_store(tmp)),
        ("input.not_found", lambda store, tmp: marketgen.open_store(tmp / "nowhere")),
        ("store.exists", lambda store, tmp: marketgen.generate(PROMPT, store.folder)),
        ("usage.bad_flag", lambda store, tmp: store.query("produce")),
        ("camera.unknown", lambda store, tmp: store.camera("isle")),
        ("input.not_found", lambda store, tmp: marketgen.generate("", tmp / "x", plan=tmp / "no.json")),
    ],
)
def test_errors_have_codes(store, tmp_path, code, call):
    with pytest.raises(marketgen.Error) as caught:
        call(store, tmp_path)
    assert caught.value.code == code
    assert caught.value.message
    again = pickle.loads(pickle.dumps(caught.value))
    assert (again.code, again.where, again.message) == (code, caught.value.where, caught.value.message)


def test_a_failed_generate_leaves_nothing(tmp_path):
    with pytest.raises(marketgen.Error):
        marketgen.generate(PROMPT, tmp_path / "shop", size="2x2m")
    assert list(tmp_path.iterdir()) == []


def test_own_products_stand_in_the_store_or_a_warning_says_why_not(tmp_path):
    rows = tmp_path / "own.csv"
    rows.write_text(
        "sku,ean,name,category,subcategory,archetype,size_mm,mass_kg\n"
        "own-cola,2999999999991,Lemonade,beverages,soft drinks,can,66x66x115,0.35\n"
        "own-giant,2999999999984,Giant,beverages,soft drinks,can,66x66x915,0.35\n"
    )
    with pytest.warns(UserWarning, match="own-giant stands nowhere in the store: it is 915 mm tall"):
        store = marketgen.generate("a kiosk with cold drinks", tmp_path / "shop", seed=2, size="8x7m", catalogs=[rows])
    assert store.query("products", "sku=own-cola")
    assert not store.query("products", "sku=own-giant")


def test_packs_by_their_photographs_need_no_photographs_afterwards(tmp_path):
    rows = tmp_path / "rows" / "own.csv"
    rows.parent.mkdir()
    Image.new("RGB", (132, 230), (200, 30, 40)).save(rows.parent / "front.jpg")
    rows.write_text(
        "sku,ean,name,category,subcategory,archetype,size_mm,mass_kg,faces.front\n"
        "own-cola,2999999999991,Lemonade,beverages,soft drinks,can,66x66x115,0.35,front.jpg\n"
    )
    marketgen.generate("a kiosk with cold drinks", tmp_path / "shop", seed=2, size="8x7m", catalogs=[rows])
    shutil.rmtree(rows.parent)
    store = marketgen.open_store(tmp_path / "shop")
    (own,) = store.manifest["own"]
    assert own["label"]["primary"] in ("#c81e28", "#c81e27", "#c71e28")  # JPEG rounds
    assert (tmp_path / "shop" / "faces" / own["faces"]["front"]).is_file()
    assert store.query("products", "sku=own-cola")
    assert store.renderer().render(store.camera("aisle", 64, 48), quality="fast").rgb.any()


def test_a_prompt_of_which_nothing_is_understood_is_a_warning(tmp_path):
    with pytest.warns(marketgen.StoreWarning, match="nothing of the prompt was understood") as caught:
        store = marketgen.generate("xyzzy plugh", tmp_path / "usual", size="9x7m")
    assert store.folder in str(caught[0].message)
    assert caught[0].filename == __file__  # whoever called is named
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        marketgen.generate(PROMPT, tmp_path / "asked", size="9x7m")


def test_pictures_are_saved_by_the_ending_of_their_name(store, renderer, tmp_path):
    frame = renderer.render(store.camera("aisle", 64, 48), quality="fast")
    frame.save(str(tmp_path / "aisle.jpg"))
    assert (tmp_path / "aisle.jpg").read_bytes()[:3] == b"\xff\xd8\xff"
    with pytest.raises(marketgen.Error, match="cannot be written as .gif"):
        frame.save(str(tmp_path / "aisle.gif"))


def test_edits_are_the_programs(store, tmp_path):
    words = "concrete floor, fill the snacks to 50 %"
    edited = store.edit(words, tmp_path / "here")
    run("edit", store.folder, "--say", words, "-o", tmp_path / "there", "--no-previews", "--quiet")
    made = json.loads((tmp_path / "there" / "store.json").read_text())
    assert edited.folder == str(tmp_path / "here")
    assert edited.manifest["scene_hash"] == made["scene_hash"] != store.manifest["scene_hash"]
    assert edited.plan["look"]["floor"].startswith("concrete")
    again = store.edit(patches=store.patches(words), folder=tmp_path / "patched")
    assert again.manifest["scene_hash"] == edited.manifest["scene_hash"]


def test_edits_say_what_they_leave_out(store, tmp_path):
    with pytest.warns(marketgen.StoreWarning, match="zzyzx"):
        patches = store.patches("concrete floor and zzyzx")
    assert [list(patch) for patch in patches] == [["set_look"]]
    with pytest.warns(marketgen.StoreWarning, match="zzyzx"), pytest.raises(marketgen.Error, match="brief.not_understood"):
        store.edit("concrete floor and zzyzx", tmp_path / "shop", strict=True)
    with pytest.warns(marketgen.StoreWarning, match='given up: "oak floor" for "concrete floor"'):
        patches = store.patches("oak floor, concrete floor")
    assert patches[0]["set_look"]["floor"].startswith("concrete")
    with pytest.raises(marketgen.Error, match='brief.contradiction.*"oak floor" and "concrete floor"'):
        store.edit("oak floor, concrete floor", tmp_path / "shop", strict=True)
    with pytest.raises(marketgen.Error, match="plan.unknown_reference"):
        store.edit(patches=[{"drop_zone": {"zone": "nowhere"}}], folder=tmp_path / "shop")
    with pytest.raises(marketgen.Error, match="either words, patches or a planogram"):
        store.edit()
    assert list(tmp_path.iterdir()) == []


def test_zones_stand_where_a_drawing_has_them(tmp_path):
    from PIL import Image, ImageDraw

    picture = Image.new("RGB", (900, 640), "white")
    draw = ImageDraw.Draw(picture)
    draw.rectangle((60, 60, 840, 580), outline="black", width=10)
    for color, box in (("#e57373", (70, 70, 440, 570)), ("#64b5f6", (460, 70, 830, 300)), ("#81c784", (460, 320, 830, 570))):
        draw.rectangle(box, fill=color)
    draw.rectangle((180, 574, 260, 588), fill="white")
    picture.save(tmp_path / "zones.png")
    with pytest.warns(UserWarning):  # nothing is written on them
        made = marketgen.generate("", tmp_path / "shop", image=tmp_path / "zones.png", size="24x16m")
    assert any(entry["path"] == "/nodes" and entry["source"] == "drawing" for entry in made.plan["provenance"])
    assert made.report["metrics"]["NAV"] > 0.99
    with pytest.raises(marketgen.Error) as caught:
        Image.new("RGB", (300, 200), "white").save(tmp_path / "blank.png")
        marketgen.generate("", tmp_path / "none", image=tmp_path / "blank.png")
    assert caught.value.code == "photo.not_a_shop"


def test_shopping_plans_are_the_programs(store):
    words = "cola and crisps, at most 20 euros"
    plan = store.shop(words)
    assert plan == json.loads(run("shop", store.folder, words, "--json")) == store.shop(words)
    assert plan["schema"] == "market-shopping/1"
    assert len(plan["lines"]) == 2 and plan["unmet"] == []
    prices = {row["sku"]: row["price"] for row in store.query("prices")}
    assert all(line["price"] == prices[line["sku"]] for line in plan["lines"])
    assert plan["total"] == pytest.approx(sum(line["count"] * line["price"] for line in plan["lines"]))

    gone = plan["lines"][0]["sku"]
    other = store.shop(words, sold_out=(gone,))
    assert other == json.loads(run("shop", store.folder, words, "--sold-out", gone, "--json"))
    offered = [line["sku"] for line in other["lines"]] + [sub["sku"] for line in other["lines"] for sub in line["substitutes"]]
    assert len(other["lines"]) == 2 and gone not in offered


def test_shopping_knows_a_stores_own_products(tmp_path):
    rows = tmp_path / "own.csv"
    rows.write_text(
        "sku,ean,name,category,subcategory,archetype,size_mm,mass_kg,price\n"
        "own-fizz,2999999999991,Elderflower Fizzle,beverages,soft drinks,can,66x66x115,0.35,0.9\n"
    )
    made = marketgen.generate("a kiosk with cold drinks", tmp_path / "shop", seed=2, size="8x7m", catalogs=[rows])
    wanted = json.loads(run("shop", made.folder, "elderflower fizzle", "--json"))
    assert [line["sku"] for line in wanted["lines"]] == ["own-fizz"]
    assert made.shop("elderflower fizzle") == wanted
    assert marketgen.open_store(made.folder).shop("elderflower fizzle") == wanted


def test_a_model_that_may_not_be_asked_leaves_the_offline_plan(store, tmp_path):
    asked = {"planner": "http:m", "planner_url": "http://127.0.0.1:9/v1", "max_tokens": 0}
    plan = store.shop("cola", **asked, record=tmp_path / "talk")
    shopper = plan.pop("shopper")
    assert (shopper["model"], shopper["kept"], shopper["requests"]) == ("http:m", "offline", 0)
    assert "planners.over_budget" in shopper["why"]
    assert plan == store.shop("cola")
    assert (tmp_path / "talk" / "model.json").is_file()


@pytest.mark.parametrize(
    ("code", "where", "words", "arguments"),
    [
        ("catalog.unknown_sku", "dairy-unicorn-milk", "cola", {"sold_out": ["dairy-unicorn-milk"]}),
        ("shopping.not_understood", "request", "", {}),
        ("shopping.not_understood", "flurbs", "two flurbs", {}),
        ("shopping.other_money", "dollar", "cola for less than 7 dollars", {}),
        ("usage.bad_flag", "planner", "cola", {"planner": "offline", "planner_url": "http://127.0.0.1:9/v1"}),
        ("input.not_found", "nowhere", "cola", {"planner": "replay:/nowhere"}),
    ],
)
def test_shopping_says_what_it_cannot_do(store, code, where, words, arguments):
    with pytest.raises(marketgen.Error) as caught:
        store.shop(words, **arguments)
    assert caught.value.code == code
    assert where in caught.value.where


def test_goods_that_are_let_go_stay_where_they_stand(store):
    items = store.query("products")
    middle = items[len(items) // 2]
    region = (middle["x_m"] - 0.3, middle["y_m"] - 0.3, middle["x_m"] + 0.3, middle["y_m"] + 0.3)
    ends = store.settle(region, seconds=1)
    inside = [row for row, item in enumerate(items) if region[0] <= item["x_m"] <= region[2] and region[1] <= item["y_m"] <= region[3]]
    assert [end["row"] for end in ends] == inside and [end["id"] for end in ends] == [items[row]["id"] for row in inside]
    moved = [abs(end["pose"][2] - items[end["row"]]["z_m"]) for end in ends]
    assert sorted(moved)[len(moved) // 2] < 0.001
    assert store.settle(region, seconds=1) == ends
    falling = store.settle(region, seconds=0.02, lift_m=0.02)  # 2 mm of the 20
    raised = [end["pose"][2] - items[end["row"]]["z_m"] for end in falling]
    assert abs(sorted(raised)[len(raised) // 2] - 0.018) < 0.0005
    assert not any(end["rests"] for end in falling if end["pose"][2] > items[end["row"]]["z_m"] + 0.01)
    assert store.settle((-9, -9, -8, -8)) == []
