"""The commands of the guide in tutorials/README.md run as they are written."""

import re

import pytest
from PIL import Image

from vertexContactTests.caseTools import DEFAULT, checked, root
from vertexContactTests.smallCases import GmshBody, SmallCase

GUIDE = root/"tutorials"/"README.md"
BLOCKS = re.findall(r"(?ms)^```sh\n(.*?)^```$", GUIDE.read_text())
BOX = "blockMesh -region"       # the block with an alternative
# Other versions of gmsh make other tetrahedra
LAST = {"gmsh": (4.7, 0.3), "blockMesh": (4.5, 0.3)}
PEAK = {"gmsh": (3.7, 0.3), "blockMesh": (3.9, 0.3)}


def commands(mesh):
    blocks = [b for b in BLOCKS if mesh == "blockMesh" or BOX not in b]
    assert len(blocks) == len(BLOCKS) - (mesh != "blockMesh")
    return "set -euo pipefail\n" + "".join(blocks)


def number(output, label):
    return float(re.search(rf"{label} ([-\d.e]+)", output).group(1))


@pytest.mark.parametrize("mesh", ("gmsh", "blockMesh"))
def test_guide(tmp_path, figures, mesh):
    output = checked(["bash", "-c", commands(mesh)], tmp_path,
                     OMPI_MCA_mpi_yield_when_idle="1")
    check = (tmp_path/"log.checkContact").read_text()
    with figures(f"guide, pad from {mesh}") as f:
        f.equal("errors of checkContact", check.count("***"), 0)
        first, last = (float(t) for t in re.search(
            r"contact from ([\d.]+) to ([\d.]+) ms", output).groups())
        f.within("first contact [ms]", first, 0.44, 0.1)
        f.within("last contact [ms]", last, *LAST[mesh])
        f.within("peak force [N]", number(output, "peak force"), *PEAK[mesh])
        f.within("impulse / change of momentum",
                 number(output, "impulse / change of momentum"), 1, 1e-6)
        f.atMost("energy at the end / initial",
                 number(output, "energy at the end / initial"), 1)
        f.atMost("largest penetration / face",
                 number(output, "largest penetration / face"), 0.1)
    for name in "ball.png", "decomposed.png":
        with Image.open(tmp_path/name) as image:
            assert image.size[0] == 640


def fenced(kind):
    """The only block of this kind in the guide."""
    block, = re.findall(rf"(?ms)^```{kind}\n(.*?)^```$", GUIDE.read_text())
    return block


class Disc(GmshBody):
    """The disc in two dimensions, as the guide has it."""

    dimensions = 2

    def makeMesh(self, case):
        (case/"disc.geo").write_text(self.geometry)
        checked(["bash", "-ec", fenced("console")], case.path)


def disc(folder, geometry):
    body = Disc(name="disc", geometry=geometry, velocity=(1, 0, 0),
                sides={"rim": "tractionFree",
                       "frontAndBack": {"type": "empty"}})
    return SmallCase(folder, body, 1e-3, preset=DEFAULT)


def test_two_dimensions(tmp_path, figures):
    """gmsh makes prisms if it is told so. Otherwise the error says how to do
    it."""
    geometry = fenced("geo")
    case = disc(tmp_path/"layer", geometry).run()
    with figures("guide, disc in two dimensions") as f:
        # For a density of one and a thickness of one metre
        f.within("momentum / pi R^2", case.momentumOf()[-1][0]
                 / (3.14159*0.01**2), 1, 0.02)
    code, output = disc(tmp_path/"tetrahedra", geometry.replace(
        "Layers {1}; Recombine;", "")).attempt()
    assert code != 0 and "Layers {1}; Recombine;" in output, output
