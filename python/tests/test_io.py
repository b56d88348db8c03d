"""Cone penetration tests, correlations, models of inversions."""

import groundwave as gw
import numpy as np
import pytest
import xarray as xr
from groundwave import io

HALF_SPACE = {"shear_speed": 250.0, "poisson": 0.45, "density": 2000.0, "damping_ratio": 0.02}
DEPTH = np.arange(0.25, 8.0, 0.25)
RESISTANCE = np.where(DEPTH < 3.0, 0.6e6, 6.0e6)
FRICTION = np.where(DEPTH < 3.0, 20e3, 40e3)

GEF = """#GEFID= 1, 1, 0
#COLUMNINFO= 1, m, sondeerlengte, 1
#COLUMNINFO= 2, MPa, conusweerstand, 2
#COLUMNINFO= 3, MPa, wrijvingsweerstand, 3
#COLUMNINFO= 4, MPa, waterspanning u2, 6
#REPORTCODE= GEF-CPT-Report, 1, 1, 2, -
#MEASUREMENTVAR= 3, 0.75, -, netto oppervlaktequotient
#XYID= 31000, 79578.38, 424838.97, 0.02, 0.02
#ZID= 31000, -0.09, 0.05
#EOH=
"""
COLUMNS = 25
XML = """<?xml version="1.0" encoding="UTF-8"?>
<dispatchDataResponse xmlns="http://www.broservices.nl/xsd/dscpt/1.1" xmlns:swe="http://www.opengis.net/swe/2.0"
 xmlns:brocom="http://www.broservices.nl/xsd/brocommon/3.0" xmlns:cptcommon="http://www.broservices.nl/xsd/cptcommon/1.1"
 xmlns:gml="http://www.opengis.net/gml/3.2"><dispatchDocument><CPT_O gml:id="BRO_0007">
<brocom:broId>CPT000000000001</brocom:broId>
<researchReportDate><brocom:date>2019-04-23</brocom:date></researchReportDate>
<deliveredLocation><cptcommon:location srsName="urn:ogc:def:crs:EPSG::28992" gml:id="a"><gml:pos>170112.2 486406.5</gml:pos>
</cptcommon:location></deliveredLocation>
<standardizedLocation><brocom:location srsName="urn:ogc:def:crs:EPSG::4258" gml:id="b"><gml:pos>52.36 5.6</gml:pos>
</brocom:location></standardizedLocation>
<deliveredVerticalPosition><cptcommon:localVerticalReferencePoint>maaiveld</cptcommon:localVerticalReferencePoint>
<cptcommon:offset uom="m">4.41</cptcommon:offset><cptcommon:verticalDatum>NAP</cptcommon:verticalDatum></deliveredVerticalPosition>
<conePenetrometerSurvey gml:id="c"><cptcommon:dissipationTestPerformed>nee</cptcommon:dissipationTestPerformed>
<cptcommon:qualityClass>klasse2</cptcommon:qualityClass>
<cptcommon:trajectory><cptcommon:predrilledDepth uom="m">0.0</cptcommon:predrilledDepth>
<cptcommon:finalDepth uom="m">8.0</cptcommon:finalDepth></cptcommon:trajectory>
<cptcommon:conePenetrometer><cptcommon:description>cone</cptcommon:description>
<cptcommon:coneSurfaceQuotient uom="1">0.75</cptcommon:coneSurfaceQuotient></cptcommon:conePenetrometer>
<cptcommon:parameters>{parameters}</cptcommon:parameters><cptcommon:conePenetrationTest gml:id="d"><cptcommon:cptResult><swe:encoding>
<swe:TextEncoding decimalSeparator="." tokenSeparator="," blockSeparator=";"/></swe:encoding>
<cptcommon:values>{values}</cptcommon:values></cptcommon:cptResult></cptcommon:conePenetrationTest>
</conePenetrometerSurvey></CPT_O></dispatchDocument></dispatchDataResponse>
"""
AGS = '''"GROUP","LOCA"
"HEADING","LOCA_ID"
"UNIT",""
"TYPE","ID"
"DATA","CPT-07"

"GROUP","SCPT"
"HEADING","LOCA_ID","SCPG_TESN","SCPT_DPTH","SCPT_RES","SCPT_FRES"
"UNIT","","","m","MN/m2","kN/m2"
"TYPE","ID","X","2DP","3DP","1DP"
'''


def file_of(kind, folder):
    """The same test in each format."""
    path = folder / f"test.{kind}"
    rows = list(zip(DEPTH, RESISTANCE, FRICTION))
    if kind == "gef":
        path.write_text(GEF + "".join(f"{z} {q / 1e6} {f / 1e6} 0.0\n" for z, q, f in rows))
    elif kind == "xml":
        # length, depth, time, resistance, …, local friction is the nineteenth
        blank = ["-999999"] * COLUMNS
        lines = []
        for z, q, f in rows:
            fields = list(blank)
            fields[0], fields[1], fields[3], fields[18] = f"{z}", f"{z}", f"{q / 1e6}", f"{f / 1e6}"
            lines.append(",".join(fields))
        measured = {0: "penetrationLength", 1: "depth", 3: "coneResistance", 18: "localFriction"}
        names = [(measured.get(i, f"other{i}"), "ja" if i in measured else "nee") for i in range(COLUMNS)]
        parameters = "".join(f"<cptcommon:{name}>{there}</cptcommon:{name}>" for name, there in names)
        path.write_text(XML.format(parameters=parameters, values=";".join(lines) + ";"))
    else:
        path.write_text(AGS + "".join(f'"DATA","CPT-07","1","{z}","{q / 1e6}","{f / 1e3}"\n' for z, q, f in rows))
    return path


@pytest.mark.parametrize(("kind", "package"), [("gef", "pygef"), ("xml", "pygef"), ("ags", "python_ags4")])
def test_formats_say_the_same(kind, package, tmp_path):
    pytest.importorskip(package)
    cpt = io.read_cpt(file_of(kind, tmp_path))
    np.testing.assert_allclose(cpt.depth, DEPTH)
    # rounding of decimals
    np.testing.assert_allclose(cpt.cone_resistance, RESISTANCE, rtol=1e-12)
    np.testing.assert_allclose(cpt.sleeve_friction, FRICTION, rtol=1e-12)
    assert cpt.attrs.get("net_area_ratio", 0.75) == 0.75


def test_units_of_gef_files_are_obeyed(tmp_path):
    pytest.importorskip("pygef")
    path = file_of("gef", tmp_path)
    text = path.read_text()
    path.write_text(text.replace("2, MPa", "2, kPa"))
    # 0.6 kPa
    assert io.read_cpt(path).cone_resistance[0].item() == 600.0
    path.write_text(text.replace("3, MPa", "3, bar"))
    with pytest.raises(ValueError, match="localFriction is in 'bar'"):
        io.read_cpt(path)


def cpt(**more):
    columns = {"cone_resistance": RESISTANCE, "sleeve_friction": FRICTION, **more}
    return xr.Dataset({key: ("depth", values) for key, values in columns.items()}, coords={"depth": DEPTH})


def at(correlation, depth, **more):
    return io.shear_speed(cpt(**more), correlation, water_depth=1.0, unit_weight=18e3).sel(depth=depth)


def test_correlations():
    """Numbers worked out one by one from the printed formulas, to the digits written here."""
    # 1.75 · 600^0.627
    assert abs(at("mayne1995", 2.0).shear_speed.item() - 96.5915) < 1e-4
    # 18.4 · 600^0.144 · 20^0.0832 · 2^0.278; ln-scatter 0.162 above 5 m
    shallow = at("mcgann2015", 2.0)
    assert abs(shallow.shear_speed.item() - 71.9124) < 1e-4 and shallow.sigma_ln.item() == 0.162
    # 0.216 − 0.0108 · 7
    assert abs(at("mcgann2015", 7.0).sigma_ln.item() - 0.1404) < 1e-12
    sand = at("robertson2009", 5.0)
    # σ = 90 kPa, σ' = 50.76 kPa: I_c = 1.8536 with n = 0.5816, c_s = √(10^2.699 · 59.1)
    assert abs(sand.behaviour_index.item() - 1.85356) < 1e-5
    assert abs(sand.shear_speed.item() - 171.997) < 1e-3
    # 2.27 · 6000^0.412 · 1.8536^0.989 · 5^0.033
    assert abs(at("andrus2007", 5.0).shear_speed.item() - 158.763) < 1e-3


def test_pore_pressures_correct_the_cone():
    with pytest.raises(ValueError, match="net_area_ratio"):
        at("mayne1995", 2.0, pore_pressure=np.full(DEPTH.shape, 100e3))
    corrected = io.shear_speed(cpt(pore_pressure=np.full(DEPTH.shape, 100e3)), "mayne1995", water_depth=1.0, unit_weight=18e3, net_area_ratio=0.75)
    # q_t = 600 + 0.25 · 100 kPa
    assert abs(corrected.shear_speed.sel(depth=2.0).item() - 1.75 * 625**0.627) < 1e-9


def test_from_a_test_to_a_critical_speed():
    speeds = io.shear_speed(cpt(), "robertson2009", water_depth=1.0, unit_weight=18e3)
    boundaries = [3.0, 7.75]
    soil = io.soil(speeds, boundaries, poisson=0.45, density=[1700.0, 1900.0], damping_ratio=0.03, half_space=HALF_SPACE)
    inside = speeds.shear_speed.values[DEPTH < 3.0]
    assert abs(soil.layers.shear_speed[0].item() - 1 / np.mean(1 / inside)) < 1e-9
    case = gw.Case({
        "soil": soil, "dispersion": {"frequencies": [10.0]}, "study": {"samples": 3, "vary": io.vary(speeds, boundaries)},
    })
    assert case.studies == ["dispersion"]


def test_models_of_inversions(tmp_path):
    path = tmp_path / "models.txt"
    path.write_text("# model 1\n2\n3.0 400 120 1700 50 25\n0 800 300 2000 50 25\n3\n1 300 100 1700\n2 400 150 1800\n0 900 400 2000\n")
    with pytest.raises(ValueError, match="models.txt:6.*damping_ratio"):
        io.read_models(path)
    first, second = io.read_models(path, damping_ratio=0.02)
    # η = 1/Q
    assert first.layers.loss_factor[0].item() == 1 / 25
    np.testing.assert_array_equal(second.layers.thickness, [1, 2, np.inf])
    path.write_text("2\n3.0 400 120 1700\n")
    with pytest.raises(ValueError, match="2 layers are announced, 1 follow"):
        io.read_models(path, damping_ratio=0.02)


def test_what_is_refused(tmp_path):
    with pytest.raises(FileNotFoundError):
        io.read_cpt(tmp_path / "nowhere.gef")
    with pytest.raises(ValueError, match="robertson2009"):
        at("robertson", 2.0)
    with pytest.raises(ValueError, match="N/m³"):
        io.shear_speed(cpt(), "mayne1995", water_depth=0.0, unit_weight=1800.0)
    with pytest.raises(ValueError, match="between 7.8 and 9 m|between 8 and 9 m"):
        io.vary(io.shear_speed(cpt(), "mayne1995", water_depth=1.0, unit_weight=18e3), [8.0, 9.0])
