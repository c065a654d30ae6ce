"""What FreeCAD's Addon Index asks of package.xml: it shows and offers nothing that lacks a part."""

import datetime
import re
import xml.etree.ElementTree
from pathlib import Path

import evenload
import pytest

ROOT = Path(evenload.__file__).resolve().parents[2]  # as it is installed
NAMESPACE = "{https://wiki.freecad.org/Package_Metadata}"


@pytest.fixture(scope="module")
def package():
    return xml.etree.ElementTree.parse(ROOT / "package.xml").getroot()


def text(package, name):
    (element,) = package.findall(NAMESPACE + name)
    return element.text.strip()


def test_it_is_of_the_known_format(package):
    assert package.tag == NAMESPACE + "package" and package.get("format") == "1"


def test_it_has_each_required_part(package):
    assert text(package, "name") == "EvenLoad"
    assert re.fullmatch(r"\d+\.\d+\.\d+", text(package, "version"))
    assert datetime.date.fromisoformat(text(package, "date"))
    assert 40 < len(text(package, "description")) < 400
    assert re.fullmatch(r"\d+\.\d+\.\d+", text(package, "freecadmin"))
    (maintainer,) = package.findall(NAMESPACE + "maintainer")
    assert maintainer.text and re.fullmatch(r"[^@\s]+@[^@\s]+\.[a-z]+", maintainer.get("email"))


def test_its_files_are_there(package):
    (licence,) = package.findall(NAMESPACE + "license")
    assert licence.text == "LGPL-2.1-or-later" and (ROOT / licence.get("file")).is_file()
    assert (ROOT / text(package, "icon")).suffix == ".svg" and (
        ROOT / text(package, "icon")
    ).is_file()


def test_it_names_the_repository_with_its_branch(package):
    urls = {url.get("type"): url for url in package.findall(NAMESPACE + "url")}
    assert urls["repository"].get("branch") and urls["readme"].text.endswith("README.md")
    assert all(url.text.startswith("https://") for url in urls.values())


def test_its_workbench_lies_in_the_addons_own_folder(package):
    (workbench,) = package.findall("%scontent/%sworkbench" % (NAMESPACE, NAMESPACE))
    assert workbench.find(NAMESPACE + "name").text == "EvenLoad"
    assert workbench.find(NAMESPACE + "subdirectory").text == "./"
    assert (ROOT / "Init.py").is_file() and (ROOT / "InitGui.py").is_file()
