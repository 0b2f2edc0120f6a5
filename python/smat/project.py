"""Projects: models, signatures and settings, and the analyses that can be made of them."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Optional, Union

from smat import _core
from smat._core import (
    Image,
    Model,
    MonteCarloResult,
    Progress,
    Result,
    Scene,
    SensorDescription,
    SensorView,
    SignatureDatabase,
)
from smat._settings import SettingResult, SettingValue, texts, texts_of_options, value_of
from smat.errors import Diagnostic, InputError

Path = Union[str, "os.PathLike[str]"]
#: Called before the first case and after each; False stops the job.
ProgressFunction = Callable[[Progress], Any]


class Project:
    """A project file (.smat), or a bare model with a signature database.

    Settings that are changed here go before those of the file and of its named analyses, as those
    of the command line do. The file stays as it is until save().

    Parameters
    ----------
    file : str or os.PathLike
        A project, or a model.
    database : str or os.PathLike, optional
        The signature database of a bare model; without, one of the same name beside it.

    Raises
    ------
    InputError
        For a file that is missing or wrong, with every key path and line.

    Examples
    --------
    >>> project = smat.Project("samples/sphere/sphere.smat")
    >>> image = project.image(width=64, height=64).image
    """

    def __init__(self, file: Path, database: Optional[Path] = None) -> None:
        self._open = _core.OpenProject(os.fspath(file), os.fspath(database or ""))

    @property
    def file(self) -> str:
        """The file; '' of a bare model."""
        path = os.fspath(self._open.file)
        return "" if path == "." else path

    @property
    def title(self) -> str:
        """Its title."""
        return self._open.title

    @property
    def notes(self) -> str:
        """What its author noted."""
        return self._open.notes

    @property
    def models(self) -> list[str]:
        """Names of the models, the target first."""
        return self._open.models

    @property
    def analyses(self) -> dict[str, str]:
        """Kinds of the named analyses by name."""
        return self._open.analyses

    @property
    def settings(self) -> dict[str, SettingResult]:
        """Everything that the file or the caller has set, by key."""
        return {
            key: value_of(_core.find_setting(key), text) for key, text in self._open.texts.items()
        }

    def __getitem__(self, key: str) -> SettingResult:
        """The value of a setting in effect, its default where it was not set.

        Raises
        ------
        InputError
            For a key that does not exist, with the nearest names.
        """
        return value_of(_core.find_setting(key), self._open.text(key))

    def __setitem__(self, key: str, value: SettingValue) -> None:
        """Set a setting, or 'models.NAME.KEY' of a model beside the target.

        Raises
        ------
        InputError
            For a key that does not exist and a value that it cannot have.
        """
        self._open.set_texts(texts({key: value}))

    def with_settings(self, settings: Mapping[str, SettingValue]) -> Project:
        """A copy with other settings; it shares the models that were loaded.

        Parameters
        ----------
        settings : dict of str to object
            Values by key: ``{'camera.range': 900, 'sensor.band': [(3, 5), (8, 12)]}``.

        Raises
        ------
        InputError
            With everything that is wrong with them.
        """
        copy = self._copy()
        copy._open.set_texts(texts(settings))
        return copy

    def with_database(self, database: SignatureDatabase, model: str = "") -> Project:
        """A copy in which a database in memory stands in for the file of a model.

        Parameters
        ----------
        database : SignatureDatabase
            What is rendered.
        model : str
            The name of the model; the target where it is empty.
        """
        copy = self._copy()
        copy._open.set_database(database, model)
        return copy

    def database(self, model: str = "") -> SignatureDatabase:
        """The signature database of a model, of the target where `model` is empty."""
        return self._open.database(model)

    def model(self, model: str = "") -> Model:
        """The model of that name as its file has it, of the target where `model` is empty."""
        return Model(self._open.model_file(model))

    def save(self, file: Path) -> None:
        """Write the project with the settings in effect, whole or not at all.

        Databases in memory are not written.

        Raises
        ------
        InputError
            Where the file cannot be written.
        """
        self._open.save(os.fspath(file))

    def view(self) -> tuple[Scene, SensorView]:
        """Scene and view of an image with the project's own settings, for render()."""
        return self._open.view()

    def run(
        self,
        kind: str = "",
        *,
        analysis: str = "",
        settings: Optional[Mapping[str, SettingValue]] = None,
        progress: Optional[ProgressFunction] = None,
        **options: SettingValue,
    ) -> Result:
        """Run an analysis, as `smat-batch KIND` does.

        Parameters
        ----------
        kind : str
            'image', 'spectrum', 'polar', 'time', 'range', 'condition' or 'table'.
        analysis : str
            A named analysis of the project, whose settings it takes; `kind` may then be left out.
        settings : dict of str to object, optional
            Settings by key for this run alone.
        progress : callable, optional
            Called with a Progress before the first case and after each; where it returns False the
            job stops and the result holds what was done.
        **options
            The options of the command line with underscores: ``step=10``, ``band=(8, 12)``; words of
            Python with one behind: ``from_=1000``.

        Returns
        -------
        Result
            Equal to the last bit to what the command line gives.

        Raises
        ------
        InputError
            With everything that is wrong, before anything is rendered.
        KeyboardInterrupt
            After Ctrl-C, between two cases.

        Warns
        -----
        SmatWarning
            What the result warns of.
        """
        results = self._run(kind, analysis, settings, progress, options)
        if len(results) != 1:
            raise InputError(
                [
                    Diagnostic(
                        "sensor.band",
                        "",
                        f"{len(results)} bands",
                        "one band for one image; images() gives one for each",
                    )
                ]
            )
        return results[0]

    def _run(
        self,
        kind: str,
        analysis: str,
        settings: Optional[Mapping[str, SettingValue]],
        progress: Optional[ProgressFunction],
        options: Mapping[str, SettingValue],
    ) -> list[Result]:
        effective = kind or self.analyses.get(analysis, "")
        given = {**texts(settings or {}), **texts_of_options(effective, options)}
        project = self._open
        if given:
            project = _core.OpenProject(self._open)
            project.set_texts(given)
        return project.run(kind, analysis, given, progress)

    def image(
        self, *, analysis: str = "", settings: Optional[Mapping[str, SettingValue]] = None,
        progress: Optional[ProgressFunction] = None, **options: SettingValue
    ) -> Result:
        """The image of the sensor: run('image')."""
        return self.run(
            "image", analysis=analysis, settings=settings, progress=progress, **options
        )

    def images(
        self, *, analysis: str = "", settings: Optional[Mapping[str, SettingValue]] = None,
        progress: Optional[ProgressFunction] = None, **options: SettingValue
    ) -> dict[str, Image]:
        """An image for each band of the sensor, by the name of its result: 'image@3-5um'."""
        images: dict[str, Image] = {}
        for result in self._run("image", analysis, settings, progress, options):
            if result.image is not None:
                images[result.name] = result.image
        return images

    def spectrum(
        self, *, analysis: str = "", settings: Optional[Mapping[str, SettingValue]] = None,
        progress: Optional[ProgressFunction] = None, **options: SettingValue
    ) -> Result:
        """Radiant intensity over wavenumber: run('spectrum')."""
        return self.run(
            "spectrum", analysis=analysis, settings=settings, progress=progress, **options
        )

    def polar(
        self, *, analysis: str = "", settings: Optional[Mapping[str, SettingValue]] = None,
        progress: Optional[ProgressFunction] = None, **options: SettingValue
    ) -> Result:
        """Radiant intensity over the aspect angle: run('polar')."""
        return self.run(
            "polar", analysis=analysis, settings=settings, progress=progress, **options
        )

    def time(
        self, *, analysis: str = "", settings: Optional[Mapping[str, SettingValue]] = None,
        progress: Optional[ProgressFunction] = None, **options: SettingValue
    ) -> Result:
        """Radiant intensity over time: run('time')."""
        return self.run(
            "time", analysis=analysis, settings=settings, progress=progress, **options
        )

    def range(
        self, *, analysis: str = "", settings: Optional[Mapping[str, SettingValue]] = None,
        progress: Optional[ProgressFunction] = None, **options: SettingValue
    ) -> Result:
        """Radiant intensity and irradiance over range: run('range')."""
        return self.run(
            "range", analysis=analysis, settings=settings, progress=progress, **options
        )

    def condition(
        self, *, analysis: str = "", settings: Optional[Mapping[str, SettingValue]] = None,
        progress: Optional[ProgressFunction] = None, **options: SettingValue
    ) -> Result:
        """Radiant intensity over engine power, Mach number or altitude: run('condition')."""
        return self.run(
            "condition", analysis=analysis, settings=settings, progress=progress, **options
        )

    def table(
        self, *, analysis: str = "", settings: Optional[Mapping[str, SettingValue]] = None,
        progress: Optional[ProgressFunction] = None, **options: SettingValue
    ) -> Result:
        """Radiant intensity over azimuth and elevation: run('table')."""
        return self.run(
            "table", analysis=analysis, settings=settings, progress=progress, **options
        )

    def detection(
        self,
        sensor: SensorDescription,
        *,
        criterion: str = "point",
        snr: Optional[float] = None,
        point: Optional[str] = None,
        task: Optional[str] = None,
        cycles: Optional[float] = None,
        probability: Optional[float] = None,
        false_alarms: Optional[float] = None,
        clutter_K: Union[float, str, None] = None,
        sensitivity: bool = False,
        cases: str = "aspects",
        against: Optional[str] = None,
        values: Optional[Sequence[Union[float, str]]] = None,
        paint: Optional[str] = None,
        sun_of: Optional[str] = None,
        ranges_m: Optional[Sequence[float]] = None,
        draws: int = 0,
        leave_out: Optional[Sequence[str]] = None,
        scene_contrast_K: Optional[float] = None,
        display_pixel_mrad: Optional[float] = None,
        display_luminance_cd_m2: Optional[float] = None,
        nearest_m: Optional[float] = None,
        farthest_m: Optional[float] = None,
        background_temperature_K: Optional[float] = None,
        settings: Optional[Mapping[str, SettingValue]] = None,
        progress: Optional[ProgressFunction] = None,
        **options: SettingValue,
    ) -> Result:
        """How far a sensor sees the target, as `smat-batch detection` does.

        Parameters
        ----------
        sensor : SensorDescription
            What is to detect the target.
        criterion : {'point', 'johnson', 'ttp'}
            By the signal to noise ratio of the target as a point, or by cycles across it.
        snr : float, optional
            Of a point: the ratio at which it is seen, 5.
        point : {'centre', 'mean', 'corner'}, optional
            Where the image of the point lies on a pixel; 'centre'.
        task : {'detection', 'recognition', 'identification'}, optional
            Of 'johnson' 0.75 (without it), 3 or 6, of 'ttp' 2.7, 14.5 or 18.8 cycles for a
            probability of 50 %.
        cycles : float, optional
            In place of a task: its cycles.
        probability : float, optional
            Of the task, 0 to 1, both exclusive; 0.5. Of a point: that its signal with noise passes
            the threshold, the mean over all places of its image in a pixel.
        false_alarms : float, optional
            Of a point, in place of snr: the probability that noise alone passes the threshold in a
            pixel and a frame.
        clutter_K : float or 'auto', optional
            Of a point: the standard deviation of the background's apparent temperature from pixel
            to pixel, which counts as noise, K; 0. 'auto': that of the rendered background behind
            the target.
        sensitivity : bool
            Adds columns 'sensitivity_NAME', the relative change of the range per relative change
            of each number of sensor, atmosphere and target.
        cases : {'aspects', 'directions'}
            Those of a polar plot, or azimuths and elevations of a signature table.
        against : {'wind', 'visibility', 'humidity', 'hour', 'band', 'paint'}, optional
            A row for each of `values` in place of each case, with the mean, least and greatest
            range of all cases.
        values : sequence of float or str, optional
            Of `against`: m/s, m, %, hours of local solar time, bands such as '3.7-4.2', of paints
            emissivities or names of materials.
        paint : str, optional
            Of 'paint': the material of the target that is replaced.
        sun_of : str, optional
            Of 'hour': the day and the place whose sun is seen, such as '2025-06-21,54.3,10.1'
            (latitude and longitude, deg); without it the sun stays.
        ranges_m : sequence of float, optional
            In place of the search of a range: the table has the probability at these ranges, m.
        draws : int
            With ranges_m: draws of the scaling files beside the models, over which the mean is
            taken as well.
        leave_out : sequence of str, optional
            Of 'johnson' and 'ttp': temperatures and materials by their names whose surfaces are
            not counted, such as hot parts and plumes.
        scene_contrast_K, display_pixel_mrad, display_luminance_cd_m2 : float, optional
            Of 'ttp': the temperature difference that the display shows, 10 K, a pixel on it as the
            observer sees it, 0.8 mrad, and its luminance, 34 cd/m2.
        nearest_m, farthest_m : float, optional
            Where the range is sought, m: 100 and 1e6.
        background_temperature_K : float, optional
            Temperature of the background whose photons cause noise; without, that of the scene.
        settings, progress, **options
            As those of polar() or table(), which place the cases.

        Returns
        -------
        Result
            'detection_range' with its error over aspects, directions or `values`, or 'probability'
            over 'range'.

        Raises
        ------
        InputError
            For values that cannot be, and for arguments that do nothing beside the others.
        """
        kind = "table" if cases == "directions" else "polar"
        given = {**texts(settings or {}), **texts_of_options(kind, options)}
        project = self._open
        if given:
            project = _core.OpenProject(self._open)
            project.set_texts(given)
        request = {
            "criterion": criterion,
            "snr": snr,
            "point": point,
            "task": task,
            "cycles": cycles,
            "probability": probability,
            "false_alarms": false_alarms,
            "clutter_K": clutter_K,
            "sensitivity": sensitivity,
            "ranges_m": None if ranges_m is None else list(ranges_m),
            "cases": cases,
            "against": against,
            "values": None if values is None else list(values),
            "paint": paint,
            "sun_of": sun_of,
            "draws": draws,
            "leave_out": None if leave_out is None else list(leave_out),
            "scene_contrast_K": scene_contrast_K,
            "display_pixel_mrad": display_pixel_mrad,
            "display_luminance_cd_m2": display_luminance_cd_m2,
            "nearest_m": nearest_m,
            "farthest_m": farthest_m,
            "background_temperature_K": background_temperature_K,
            "settings": given,
        }
        return project.detection(sensor, request, progress)

    def monte_carlo(
        self,
        kind: str = "",
        *,
        analysis: str = "",
        samples: int = 1024,
        seed: Optional[int] = None,
        sequence: str = "sobol",
        quantity: str = "contrast_intensity",
        statistic: str = "mean",
        standard_error: Optional[float] = None,
        percentiles: Sequence[float] = (5.0, 25.0, 50.0, 75.0, 95.0),
        subpixel_shifts: int = 4,
        ranking: bool = False,
        ranking_pairs: int = 1024,
        ranking_at: Optional[float] = None,
        settings: Optional[Mapping[str, SettingValue]] = None,
        progress: Optional[ProgressFunction] = None,
    ) -> MonteCarloResult:
        """Repeat an analysis over the scales of the scaling files beside its models.

        Geometry is rendered once for each case; a draw is a few sums.

        Parameters
        ----------
        kind, analysis : str
            As those of run(); no image.
        samples : int
            Draws at most, 2 to 10,000,000.
        seed : int, optional
            In place of the setting scaling.seed.
        sequence : {'sobol', 'plain'}
            How scales are drawn.
        quantity : {'contrast_intensity', 'intensity', 'irradiance'}
            What is looked at.
        statistic : str
            Whose standard error is told: 'mean', 'standard-deviation', 'p95'.
        standard_error : float, optional
            Ends the draws once it is below this fraction of the largest magnitude.
        percentiles : sequence of float
            Columns of the table, 0 to 100.
        subpixel_shifts : int
            Drawings of each case for the numerical error, 1 to 64.
        ranking : bool
            Whether scales are ranked by their first-order Sobol' indices.
        ranking_pairs : int
            Draws of the ranking, 256 to 1,000,000.
        ranking_at : float, optional
            Where the ranking looks, in the unit of the abscissa.
        settings, progress
            As those of run().

        Returns
        -------
        MonteCarloResult
            Equal to the last bit to what `smat-batch montecarlo` gives.

        Raises
        ------
        InputError
            For options that cannot be, and where no model has a scaling file.
        """
        given = {**(settings or {}), **({} if seed is None else {"scaling.seed": seed})}
        project = self.with_settings(given) if given else self
        options = {
            "samples": samples,
            "sequence": sequence,
            "quantity": quantity,
            "statistic": statistic,
            "standard_error": standard_error,
            "percentiles": list(percentiles),
            "subpixel_shifts": subpixel_shifts,
            "ranking": ranking,
            "ranking_pairs": ranking_pairs,
            "ranking_at": ranking_at,
        }
        return project._open.monte_carlo(kind, analysis, options, progress)

    def _copy(self) -> Project:
        copy = Project.__new__(Project)
        copy._open = _core.OpenProject(self._open)
        return copy

    def __copy__(self) -> Project:
        return self._copy()

    def __repr__(self) -> str:
        return f"Project {self.file or self.models[0]!r}: {', '.join(self.models)}"
