"""Infrared signatures from Python: everything that the command line of SMAT computes.

A project is opened, its settings are changed, and analyses give arrays::

    import smat

    project = smat.Project("samples/ship/ship.smat")
    polar = project.polar(step=10, band=(8, 12)).table
    polar["azimuth"], polar["contrast_intensity"]  # deg, W sr-1

Errors of input are smat.InputError with file, position, value and what was expected. The guide is
docs/python.md.
"""

from smat._core import (
    Band,
    Entity,
    Environment,
    Finding,
    Image,
    MeshPart,
    Model,
    MonteCarloResult,
    ObjectRadiometry,
    Outputs,
    Progress,
    Rendered,
    Renderer,
    RenderReport,
    Result,
    Scenario,
    Scene,
    Sensor,
    SensorDescription,
    SensorResult,
    SensorView,
    SettingInfo,
    SignatureDatabase,
    Spectrum,
    Table,
    Viewpoint,
    __version__,
    analysis_kinds,
    brightness_temperature,
    find_setting,
    planck_derivative,
    planck_radiance,
    render,
    set_threads,
    settings,
)
from smat.errors import Diagnostic, InputError, LogicError, SmatWarning
from smat.project import Project

__all__ = [
    "Band",
    "Diagnostic",
    "Entity",
    "Environment",
    "Finding",
    "Image",
    "InputError",
    "LogicError",
    "MeshPart",
    "Model",
    "MonteCarloResult",
    "ObjectRadiometry",
    "Outputs",
    "Progress",
    "Project",
    "RenderReport",
    "Rendered",
    "Renderer",
    "Result",
    "Scenario",
    "Scene",
    "Sensor",
    "SensorDescription",
    "SensorResult",
    "SensorView",
    "SettingInfo",
    "SignatureDatabase",
    "SmatWarning",
    "Spectrum",
    "Table",
    "Viewpoint",
    "__version__",
    "analysis_kinds",
    "brightness_temperature",
    "find_setting",
    "planck_derivative",
    "planck_radiance",
    "render",
    "set_threads",
    "settings",
]
