"""Draws what box_volume wrote with VTK's two volume mappers, times them, and prints JSON. Needs a display (Xvfb).

    vtk_volume.py FOLDER RUNS
"""

import json
import math
import os
import sys
import time

import numpy
import vtk
from vtk.util import numpy_support

MAPPERS = {
    "vtk_gpu": vtk.vtkOpenGLGPUVolumeRayCastMapper,
    "vtk_cpu": vtk.vtkFixedPointVolumeRayCastMapper,
}


def image_of(folder, scene):
    """The voxels with VTK's axes: ours are left-handed, so depth is negated."""
    width, height, layers = scene["voxels"]
    raw = numpy.fromfile(os.path.join(folder, "volume.raw"), numpy.uint8).reshape(layers, height, width)
    voxels = numpy.ascontiguousarray(raw.transpose(2, 1, 0)[::-1])  # z, y, x of P-space: x_C, y_C, t_C
    low, high = scene["low"], scene["high"]
    counts = (layers, height, width)
    spacing = [(high[i] - low[i]) / counts[i] for i in range(3)]
    corner = [low[0], low[1], -high[2]]
    image = vtk.vtkImageData()
    image.SetDimensions(*counts)
    image.SetSpacing(*spacing)
    image.SetOrigin(*[corner[i] + spacing[i] / 2 for i in range(3)])
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(voxels.ravel(), deep=True))
    return image


def look_of(scene):
    colour, opacity = vtk.vtkColorTransferFunction(), vtk.vtkPiecewiseFunction()
    for value, (red, green, blue, extinction) in enumerate(scene["colours"]):
        colour.AddRGBPoint(value, red, green, blue)
        opacity.AddPoint(value, 1 - math.exp(-extinction * scene["step"]))
    look = vtk.vtkVolumeProperty()
    look.SetColor(colour)
    look.SetScalarOpacity(opacity)
    look.SetScalarOpacityUnitDistance(scene["step"])
    look.SetInterpolationTypeToLinear()
    look.ShadeOff()
    return look


def camera_of(scene):
    eye, forward = numpy.array(scene["eye"]), numpy.array(scene["forward"])
    mirror = numpy.array([1, 1, -1])
    camera = vtk.vtkCamera()
    camera.SetPosition(*(eye * mirror))
    camera.SetFocalPoint(*((eye + forward) * mirror))
    camera.SetViewUp(0, 1, 0)
    camera.SetViewAngle(math.degrees(2 * math.atan(1 / scene["scale"])))
    camera.SetWindowCenter(*[-shift for shift in scene["shift"]])
    return camera


def mapper_of(kind, image, step):
    mapper = kind()
    mapper.SetInputData(image)
    mapper.SetBlendModeToComposite()
    mapper.AutoAdjustSampleDistancesOff()
    mapper.SetSampleDistance(step)
    if hasattr(mapper, "SetInteractiveSampleDistance"):
        mapper.SetInteractiveSampleDistance(step)
        mapper.SetImageSampleDistance(1)
    return mapper


def draw(folder, scene, image, name, kind, runs):
    volume = vtk.vtkVolume()
    volume.SetMapper(mapper_of(kind, image, scene["step"]))
    volume.SetProperty(look_of(scene))
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddVolume(volume)
    renderer.SetActiveCamera(camera_of(scene))
    renderer.ResetCameraClippingRange()
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*scene["size"])
    window.AddRenderer(renderer)
    window.Render()
    seconds = []
    for _ in range(runs):
        begin = time.monotonic()
        window.Render()
        window.WaitForCompletion()
        seconds.append(time.monotonic() - begin)
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(os.path.join(folder, name + ".png"))
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()
    return seconds


def main():
    folder, runs = sys.argv[1], int(sys.argv[2])
    with open(os.path.join(folder, "scene.json"), encoding="utf-8") as file:
        scene = json.load(file)
    image = image_of(folder, scene)
    report = {"version": vtk.vtkVersion.GetVTKVersion()}
    for name, kind in MAPPERS.items():
        report[name] = draw(folder, scene, image, name, kind, runs)
    print(json.dumps(report))


if __name__ == "__main__":
    main()
