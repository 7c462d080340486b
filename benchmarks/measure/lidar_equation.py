"""The lidar equation of the Python package, for one bottomless layer of Henyey & Greenstein's phase function."""

import sys

import numpy as np

from measure.program import ROOT

sys.path.append(str(ROOT / "python"))

from photic.lens import Lens  # noqa: E402
from photic.rays import LIGHT_M_PER_NS, beam_for  # noqa: E402
from photic.seawater import light_of  # noqa: E402
from photic.single_scattering import Layers, Turned, echo  # noqa: E402


def echo_of(scene, edges_ns):
    """Photons per photon emitted in each gate. `scene`: as `photic show --json` prints it."""
    source, telescope, layer = scene["source"], scene["telescope"][0], scene["sea"]["layer"][0]
    a, b = layer["iop"][0]["a_per_m"], layer["iop"][0]["b_per_m"]
    laser = light_of(scene["sea"], source["wavelength_nm"])
    turned = Turned(laser, [b], lambda _, cosine: henyey_greenstein(cosine, layer["phase_function"]["g"]), [a + b])
    paths = LIGHT_M_PER_NS * np.column_stack([edges_ns[:-1], edges_ns[1:]])
    return echo(beam_for(source, telescope, laser), Lens(telescope), Layers([0, np.inf], [a + b]), turned, paths)


def henyey_greenstein(cosine, g):
    return (1 - g * g) / (1 + g * g - 2 * g * cosine) ** 1.5 / (4 * np.pi)
