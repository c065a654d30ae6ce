"""evenload.inspection: DMIS as it is written, and as programs of CMMs write it."""

import numpy
import pytest
from evenload import inspection

POINTS = numpy.array([[1.5, -2.25, 30], [40, 0.125, 36]])
NORMALS = numpy.array([[0, 0.6, 0.8], [0, 0, 1.0]])
WORDS = {"mm": "MM", "inch": "INCH"}

# A program and its results in one file, as it comes from the offline seat of a CMM.
WITH_PROGRAM = """\
DMISMN/'BRACKET TOP', 04.0
FILNAM/'BRACKET', 04.0
$$
$$ Operator: A. Müller $
$$<MEAS_POINT name = "T1: 10.00,20.00,30.00">
UNITS/MM, ANGDEC, TEMPC
WKPLAN/XYPLAN
V(1)=VFORM/ALL
D(0)=DATSET/MCS
MODE/PROG,MAN
  F(T1)=FEAT/POINT,CART,10.0,20.0,30.0,0.0,0.0,1.0
  MEAS/POINT,F(T1),1
    PTMEAS/CART,10.0,20.0,30.0,0.0,0.0,1.0
  ENDMES
OUTPUT/F(T1)
F(T1)=FEAT/POINT,CART,10.0,20.0,30.0,0.0,0.0,1.0
OUTPUT/FA(T1),TA(PR1)
FA(T1)=FEAT/POINT,CART,10.0001,19.9998,30.0123,$
       0.0,0.0,1.0
TA(PR1)=TOL/PROFP,0.0123,INTOL
F(H1)=FEAT/CIRCLE,INNER,CART,5.0,5.0,0.0,0.0,0.0,1.0,8.0
FA(H1)=FEAT/CIRCLE,INNER,CART,5.01,5.0,0.0,0.0,0.0,1.0,8.02
TEXT/OUTFIL,'FA(T9)=FEAT/POINT,CART,1,2,3,0,0,1'
OUTPUT/FA(T2)
FA(T$
  2)=FEAT/POINT,CART,-1.25E+01,+.5,30.,0.,0.6,0.8
ENDFIL
"""
# Results alone, in lower case, with blanks, without normals of the measured points.
RESULTS = """\
filnam/'lid.dmo',05.2
date=2024/03/18
time=14:07:55
units/inch,angdec
f( P 1 ) = feat / point , cart , 1.0 , 2.0 , 3.0 , 0 , 0 , 2
fa( P 1 ) = feat / point , cart , 1.0002 , 2.0 , 3.0001
f(P2)=feat/point,cart,1.5,2.0,3.0,0,0,1
fa(P2)=feat/point,cart,1.5,2.0,2.9999,0,0,0
units/inch,angdec
endfil
"""


def read(tmp_path, text):
    (tmp_path / "r.dmo").write_bytes(text if isinstance(text, bytes) else text.encode())
    return inspection.read_dmis(tmp_path / "r.dmo")


@pytest.mark.parametrize("unit, scale", [("mm", 1), ("inch", 25.4)])
def test_points_are_written_as_a_program_and_read_as_results(tmp_path, unit, scale):
    inspection.write_dmis(tmp_path / "p.dmi", POINTS, NORMALS, unit)
    text = (tmp_path / "p.dmi").read_text()
    assert text.startswith("DMISMN/'EVENLOAD',05.2\nUNITS/%s,ANGDEC\n" % WORDS[unit])
    assert "F(P2)=FEAT/POINT,CART,40,0.125,36,0,0,1\nMEAS/POINT,F(P2),1\n" in text
    found = read(tmp_path, text.replace("OUTPUT/FA(P1)", "FA(P1)=FEAT/POINT,CART,1.5,-2.25,30"))
    assert list(found) == ["P1"]
    assert found["P1"][0] == pytest.approx(scale * POINTS[0])
    assert found["P1"][1] == pytest.approx(NORMALS[0])


@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_results_among_a_program_are_read_and_all_else_is_passed_over(tmp_path, end):
    text = WITH_PROGRAM.replace("\n", end)
    for data in (text.encode(), text.encode("latin-1"), b"\xef\xbb\xbf" + text.encode()):
        found = read(tmp_path, data)
        assert list(found) == ["T1", "T2"]
        assert found["T1"][0] == pytest.approx([10.0001, 19.9998, 30.0123])
        assert found["T2"][0] == pytest.approx([-12.5, 0.5, 30])
        assert found["T2"][1] == pytest.approx([0, 0.6, 0.8])


def test_a_measured_point_without_a_normal_has_its_nominal_one(tmp_path):
    found = read(tmp_path, RESULTS)
    assert found["P 1"][0] == pytest.approx([25.4 * 1.0002, 50.8, 25.4 * 3.0001])
    assert found["P 1"][1] == pytest.approx([0, 0, 1])
    assert found["P2"][0][2] == pytest.approx(25.4 * 2.9999)
    assert found["P2"][1] == pytest.approx([0, 0, 1])


def test_a_comment_of_no_words_hides_nothing(tmp_path):
    found = read(tmp_path, "$$\nUNITS/MM\n$$ ends in $\nFA(A)=FEAT/POINT,CART,1,2,3,0,0,1\n$$\n")
    assert found["A"][0] == pytest.approx([1, 2, 3])


@pytest.mark.parametrize(
    "text, words",
    [
        ("FA(P1)=FEAT/POINT,CART,1,2,3,0,0,1\n", "no unit"),
        ("UNITS/MM\nUNITS/INCH\n", "mixes"),
        ("UNITS/MM\nFA(P1)=FEAT/POINT,CART,1,2,3,0,0,1\nUNITS/INCH\n", "mixes"),
        ("UNITS/FEET\n", "mm or inch"),
        ("UNITS/MM\n", "no measured points"),
        ("UNITS/MM\nMEAS/PLANE,F(A),3\nPTMEAS/CART,1,2,3,0,0,1\nENDMES\n", "points to measure"),
        ("UNITS/MM\nF(A)=FEAT/POINT,CART,1,2,3,0,0,1\n", "file of results"),
        ("UNITS/MM\nFA(P1)=FEAT/POINT,CART,1,2,3,0,0\n", "six numbers"),
        ("UNITS/MM\nFA(P1)=FEAT/POINT,CART,1,2,3\n", "a normal among them"),
        ("UNITS/MM\nFA(P1)=FEAT/POINT,CART,1,2,3,0,0,0\n", "a normal among them"),
        ("UNITS/MM\nFA(P1)=FEAT/POINT,CART,1,2,x,0,0,1\n", "six numbers"),
        ("UNITS/MM\nFA(P1)=FEAT/POINT,1,2,3,0,0,1\n", "after CART"),
        ("UNITS/MM\nFA(P1)=FEAT/POINT,POL,1,45,3,0,0,1\n", "polar"),
        ("UNITS/MM\n" + 2 * "FA(P1)=FEAT/POINT,CART,1,2,3,0,0,1\n", "twice"),
    ],
)
def test_dmis_that_is_unclear_is_refused(tmp_path, text, words):
    with pytest.raises(ValueError, match=words) as refused:
        read(tmp_path, text)
    assert str(refused.value).endswith(".") and "\n" not in str(refused.value)
