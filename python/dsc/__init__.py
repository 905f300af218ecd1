"""Moving interfaces with topology changes.

Space or the plane is divided into cells with labels. The interface consists of the facets between
different labels. It moves with velocities or to destinations. Components merge and split, and the cells
stay well-shaped.

    import dsc, numpy as np
    c = dsc.Complex3.from_function(lambda p: (np.linalg.norm(p, axis=1) < .5).astype(int),
                                   box=[(-1, -1, -1), (1, 1, 1)], edge=.1)
    report = c.offset(.02)
"""

from ._complex import (
    Complex,
    Complex2,
    Complex3,
    Density,
    LabelFunction,
    PairFunction,
    Progress,
    Scheme,
    Topology,
    Velocity,
)
from ._errors import (
    BusyError,
    Error,
    FileError,
    FluidStepError,
    Interrupted,
    InvalidCellsError,
    InvalidDestinationError,
    InvalidPointsError,
    InvalidSolidError,
    InvalidSurfaceError,
    TetrahedralizationError,
    VolumeWarning,
)
from ._film import Film
from ._fluid import (
    Balance,
    Field,
    Fluid,
    FluidReport,
    Gas,
    Liquid,
    Region,
    Side,
    Source,
    Tension,
)
from ._grains import GrainGrowth, GrainStep, Orientations, Voronoi
from ._labels import Label
from ._progress import ProgressLine
from ._report import Cells, Changes, Grain, Interface, LabelChange, Report, TopologyEvent
from ._segmentation import Boundary, Phase, Segmentation, segment
from ._solids import Body, Motion
from ._surfaces import CutLocus, Reconstruction, Sheet, cut_locus, reconstruct, reconstruct_sheet
from ._tori import Torus, Torus2, Torus3
from ._values import Values

__all__ = [
    "Balance",
    "Body",
    "Boundary",
    "BusyError",
    "Cells",
    "Changes",
    "Complex",
    "Complex2",
    "Complex3",
    "CutLocus",
    "Density",
    "Error",
    "Field",
    "FileError",
    "Film",
    "Fluid",
    "FluidReport",
    "FluidStepError",
    "Gas",
    "Grain",
    "GrainGrowth",
    "GrainStep",
    "Interface",
    "Interrupted",
    "InvalidCellsError",
    "InvalidDestinationError",
    "InvalidPointsError",
    "InvalidSolidError",
    "InvalidSurfaceError",
    "Label",
    "LabelChange",
    "LabelFunction",
    "Liquid",
    "Motion",
    "Orientations",
    "PairFunction",
    "Phase",
    "Progress",
    "ProgressLine",
    "Reconstruction",
    "Region",
    "Report",
    "Scheme",
    "Segmentation",
    "Sheet",
    "Side",
    "Source",
    "Tension",
    "TetrahedralizationError",
    "Topology",
    "TopologyEvent",
    "Torus",
    "Torus2",
    "Torus3",
    "Values",
    "Velocity",
    "VolumeWarning",
    "Voronoi",
    "cut_locus",
    "reconstruct",
    "reconstruct_sheet",
    "segment",
]
