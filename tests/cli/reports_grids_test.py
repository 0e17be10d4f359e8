"""Grids of public reports: the right result, or a refusal that names the right way out. And others of their kinds."""

import shutil
import unittest
from pathlib import Path

from harness import ToolTest

REPORTS = Path(__file__).with_name("reports")
QUICK = ("--control-points", "5x5", "--between", "off")


class Grids(ToolTest):
    def setUp(self):
        super().setUp()
        for path in REPORTS.glob("*.asc"):
            shutil.copy(path, self.folder)

    def heights(self, name):
        """Rows of the points' z, by x and y."""
        text = self.run_tool("convert", name, "-o", "-").stdout
        return {(row["x"], row["y"]): row["z"] for row in self.read_csv(text)}

    def test_counts_written_as_floating_point_numbers(self):
        facts = self.run_json("info", "ncols_float.asc")
        self.assertEqual((facts["columns"], facts["rows"], facts["points"], facts["holes"]), (14, 11, 154, 0))
        self.assertEqual(self.heights("ncols_float.asc"), self.heights("plain.asc"))
        fits = [self.run_json("fit", name, *QUICK)["error"] for name in ("ncols_float.asc", "plain.asc")]
        self.assertEqual(fits[0], fits[1])

    def test_words_for_no_data(self):
        facts = self.run_json("info", "nodata_null.asc")
        self.assertEqual((facts["points"], facts["holes"]), (150, 4))
        plain, holes = self.heights("plain.asc"), self.heights("nodata_null.asc")
        left_out = set(plain) - set(holes)
        text = (self.folder / "nodata_null.asc").read_text().splitlines()[6:]
        self.assertEqual(left_out, {(400005 + 10 * c, 5600105 - 10 * r) for r, line in enumerate(text)
                                    for c, word in enumerate(line.split()) if word == "null"})
        self.assertTrue(all(holes[place] == plain[place] for place in holes))
        report = self.run_json("fit", "nodata_null.asc", *QUICK, "-o", "fitted.asc")
        self.assertEqual((report["input"]["points"], report["input"]["holes"]), (150, 4))
        head, cells = self.read_raster("fitted.asc")
        self.assertEqual(sum(z == head["nodata_value"] for row in cells for z in row), 4)
        for word in ("NULL", "nan", "NA", "N/A", "none", "NODATA", "*", "-"):
            with self.subTest(word=word):
                self.write("word.asc", "\n".join(text_of(self.folder / "nodata_null.asc", word)))
                self.assertEqual(self.heights("word.asc"), holes)

    def test_a_dos_file_that_ends_with_ctrl_z(self):
        data = (self.folder / "plain.asc").read_bytes()
        for end in (b"\x1a", b"\r\n\x1a", b"\x1a\x1a\x1a\x00\x00"):
            (self.folder / "dos.asc").write_bytes(data.replace(b"\n", b"\r\n") + end)
            self.assertEqual(self.heights("dos.asc"), self.heights("plain.asc"))

    def test_a_cloud_named_like_a_grid(self):
        said = self.refused("info", "cloud_in.asc", words=["cloud_in.asc:1", "--input-format csv"])
        self.assertNotIn(" --format", said)
        self.refused("fit", "cloud_in.asc", *QUICK, words=["--input-format csv"])
        # The way out is one.
        facts = self.run_json("info", "cloud_in.asc", "--input-format", "csv", "--columns", "x,y,z,-,-,-")
        lines = (self.folder / "cloud_in.asc").read_text().splitlines()
        self.assertEqual(facts["points"], len(lines))
        z = [float(line.split()[2]) for line in lines]
        self.assertEqual(facts["ranges"]["z"], [min(z), max(z)])

    def test_options_that_do_not_apply_to_a_grid(self):
        for option in (("--base", "plane"), ("--corners", "sharpest"), ("--omega", "1"), ("--largest-part",),
                       ("--columns", "x,y,z"), ("--spacing", "chord"), ("--classes", "2"), ("--correct", "5"),
                       ("--base", "auto"), ("--orient",), ("--drop-degenerate",), ("--rescale-parameters",)):
            with self.subTest(option=option):
                self.refused("fit", "plain.asc", *QUICK, *option, words=[option[0][2:]])
        self.assertEqual(self.run_json("fit", "plain.asc", *QUICK)["input"]["points"], 154)


class OtherFormats(ToolTest):
    """Files that are not read name the command that makes one that is."""

    def test_by_their_first_bytes(self):
        zip_head = b"PK\x03\x04" + bytes(22) + b"\x13\0\0\0"
        for name, data, words in [
            ("a.tif", b"II*\0\x08\0\0\0", ["GeoTIFF", "gdal_translate -of AAIGrid a.tif a.asc"]),
            ("a.laz", b"LASF" + bytes(20) + b"\1\2" + bytes(78) + b"\x83" + bytes(200), ["LAZ", "pdal translate a.laz a.las"]),
            ("a.e57", b"ASTM-E57" + bytes(40), ["E57", "pdal translate a.e57 a.las"]),
            ("a.glb", b"glTF\2\0\0\0", ["glTF", "assimp export a.glb a.obj"]),
            ("a.3mf", zip_head + b"3D/3dmodel.model...", ["3MF", "assimp export a.3mf a.obj"]),
            ("a.xlsx", zip_head + b"xl/workbook.xml....", ["XLSX", "libreoffice --headless --convert-to csv a.xlsx"]),
            ("a.zip", zip_head + b"any other name here", ["ZIP", "unzip a.zip"]),
            ("a.npz", zip_head + b"arr_0.npy..........", ["NumPy", "numpy.load('a.npz')", "numpy.save('a.npy'"]),
        ]:
            for shown in (name, "mistaken.csv", "mistaken", "mistaken.json"):
                (self.folder / shown).write_bytes(data)
                wanted = words if shown == name else words[:1]
                with self.subTest(name=shown, kind=name):
                    self.refused("info", shown, words=[shown, *wanted])
                    self.refused("fit" if not shown.endswith("json") else "eval", shown,
                                 *(QUICK if not shown.endswith("json") else ("--at", "0,0")), words=[shown, *wanted])


def text_of(path, word):
    return [line.replace("null", word) for line in path.read_text().splitlines()]


if __name__ == "__main__":
    unittest.main(verbosity=2)
