#!/usr/bin/env python3
"""Renders a Nori scene with Mitsuba 3 (PyPI: mitsuba), as a peer of `laver chart`.

    mitsuba_peer.py SCENE.xml --variant llvm_ad_rgb --spp 64 -o OUT.exr --stats=OUT.json

Geometry, camera, filter, samples and lights are those of the scene. Supported: triangles and spheres,
diffuse, mirror and dielectric surfaces, point, area and constant lights, by

- `direct_whitted` with point lights and diffuse surfaces. Nori's point light is Mitsuba's: radiance /
  distance^2 arrives. Nori and laver trace a shadow ray to each light; Mitsuba's `direct` picks lights
  at random, which adds noise. So each light is rendered by itself, with the same seed and hence the
  same camera rays, and the pictures are added;
- `path_mis`: Mitsuba's `path`, which also samples lights and BSDFs and weighs them by a heuristic;
  Russian roulette starts after three surfaces, as in laver.

Times: `trace` is a second render in the same process, without start, compilation and scene load;
`process` runs from the start of the process until the first picture is written.

Exit code 69: Mitsuba is not installed, or cannot render this scene; stderr says why, in one line.
"""
import argparse
import glob
import json
import math
import os
import re
import sys
import time
import xml.etree.ElementTree as ElementTree

UNAVAILABLE = 69  # EX_UNAVAILABLE of sysexits.h


class Unsupported(Exception):
    pass


def numbers(text):
    return [float(part) for part in re.split(r"[,\s]+", text.strip())]


def properties(node):
    """The scalar properties of a Nori object by name."""
    readers = {"float": float, "integer": int, "string": str, "boolean": lambda t: t == "true",
               "color": numbers, "point": numbers, "vector": numbers}
    return {child.get("name"): readers[child.tag](child.get("value"))
            for child in node if child.tag in readers}


def refuse_unknown(what, found, known):
    unknown = set(found) - set(known)
    if unknown:
        raise Unsupported(f"{what} has properties without an equivalent here: {sorted(unknown)}")


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def identity():
    return [[float(i == j) for j in range(4)] for i in range(4)]


def normalized(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def step_matrix(step):
    """One step of a Nori <transform>."""
    m = identity()
    if step.tag in ("translate", "scale"):
        for i, value in enumerate(numbers(step.get("value"))):
            m[i][3 if step.tag == "translate" else i] = value
    elif step.tag == "rotate":
        x, y, z = normalized(numbers(step.get("axis")))
        angle = math.radians(float(step.get("angle")))
        c, s = math.cos(angle), math.sin(angle)
        t = 1.0 - c
        rows = [[t * x * x + c, t * x * y - s * z, t * x * z + s * y],
                [t * x * y + s * z, t * y * y + c, t * y * z - s * x],
                [t * x * z - s * y, t * y * z + s * x, t * z * z + c]]
        for i in range(3):
            m[i][:3] = rows[i]
    elif step.tag == "matrix":
        values = numbers(step.get("value"))
        m = [values[4 * i:4 * i + 4] for i in range(4)]
    elif step.tag == "lookat":
        origin, target, up = (numbers(step.get(name)) for name in ("origin", "target", "up"))
        forward = normalized([b - a for a, b in zip(origin, target)])
        left = normalized(cross(up, forward))
        columns = [left, cross(forward, left), forward, origin]
        for i in range(3):
            m[i] = [column[i] for column in columns]
    else:
        raise Unsupported(f"transform <{step.tag}>")
    return m


def to_world(node):
    m = identity()
    for transform in node.findall("transform"):
        for step in transform:
            m = product(step_matrix(step), m)
    return m


def has_normals(file):
    with open(file, encoding="utf-8", errors="replace") as lines:
        return any(line.startswith("vn ") for line in lines)


def rgb(value):
    return {"type": "rgb", "value": value}


def surface(node, kinds):
    """A BSDF of one of these kinds."""
    if node is None:
        return {"type": "diffuse", "reflectance": rgb([0.5] * 3)}
    found, kind = properties(node), node.get("type")
    if kind not in kinds or node.find("texture") is not None:
        raise Unsupported(f"a surface of type \"{kind}\" or a texture")
    if kind == "mirror":
        refuse_unknown("a surface", found, [])
        return {"type": "conductor", "material": "none"}
    if kind == "dielectric":
        refuse_unknown("a surface", found, ["intIOR", "extIOR"])
        return {"type": "dielectric", "int_ior": found.get("intIOR", 1.5046),
                "ext_ior": found.get("extIOR", 1.000277)}
    refuse_unknown("a surface", found, ["albedo"])
    return {"type": "diffuse", "reflectance": rgb(found.get("albedo", [0.5] * 3))}


def shape(mi, node, folder, kinds):
    found = properties(node)
    result = {"bsdf": surface(node.find("bsdf"), kinds)}
    light = node.find("emitter")
    if light is not None:
        emitted = properties(light)
        if light.get("type") != "area" or kinds == ["diffuse"]:
            raise Unsupported("a mesh that emits light")
        refuse_unknown("a light", emitted, ["radiance"])
        result["emitter"] = {"type": "area", "radiance": rgb(emitted["radiance"])}
    if node.get("type") == "obj":
        file = os.path.join(folder, found["filename"])
        return {"type": "obj", "filename": file, "face_normals": not has_normals(file),
                "to_world": mi.ScalarTransform4f(to_world(node)), **result}
    if node.get("type") == "sphere" and node.find("transform") is None:
        return {"type": "sphere", "center": found.get("center", [0, 0, 0]),
                "radius": found.get("radius", 1.0), **result}
    raise Unsupported(f"a mesh of type \"{node.get('type')}\"")


def reconstruction(node):
    """Nori's filters and their defaults. Mitsuba's Gaussian ends at 4 stddev, its Mitchell at 2."""
    kind = "gaussian" if node is None else node.get("type")
    found = {} if node is None else properties(node)
    if kind == "gaussian":
        stddev = found.get("stddev", 0.5)
        if found.get("radius", 2.0) != 4.0 * stddev:
            raise Unsupported("a gaussian filter whose radius is not 4 stddev")
        return {"type": "gaussian", "stddev": stddev}
    if kind == "mitchell" and found.get("radius", 2.0) == 2.0:
        return {"type": "mitchell", "B": found.get("B", 1 / 3), "C": found.get("C", 1 / 3)}
    if kind == "tent":
        return {"type": "tent", "radius": found.get("radius", 1.0)}
    if kind == "box":
        return {"type": "box"}
    raise Unsupported(f"the filter \"{kind}\" with {found}")


def sensor(mi, node, size, sampler):
    found = properties(node)
    if node.get("type") != "perspective":
        raise Unsupported(f"a camera of type \"{node.get('type')}\"")
    width, height = size or (found.get("width", 1280), found.get("height", 720))
    return {"type": "perspective", "fov": found.get("fov", 30.0), "fov_axis": "x",
            "near_clip": found.get("nearClip", 1e-4), "far_clip": found.get("farClip", 1e4),
            "to_world": mi.ScalarTransform4f(to_world(node)),
            "sampler": {"type": sampler},
            "film": {"type": "hdrfilm", "width": width, "height": height, "pixel_format": "rgb",
                     "component_format": "float32", "rfilter": reconstruction(node.find("rfilter"))}}


def light_of(node):
    """A light that is not a mesh."""
    found = properties(node)
    if node.get("type") == "constant":
        refuse_unknown("a light", found, ["radiance"])
        return {"type": "constant", "radiance": rgb(found.get("radiance", [1, 1, 1]))}
    if node.get("type") not in ("pointlight", "point"):
        raise Unsupported(f"a light of type \"{node.get('type')}\"")
    refuse_unknown("a light", found, ["position", "radiance"])
    return {"type": "point", "position": found.get("position", [0, 100, 0]),
            "intensity": rgb(found.get("radiance", [1, 1, 1]))}


INTEGRATORS = {
    "direct_whitted": {"type": "direct", "emitter_samples": 1, "bsdf_samples": 0},
    "path_mis": {"type": "path", "max_depth": -1, "rr_depth": 4},
}


def translate(mi, file, size, sampler):
    """Mitsuba's scenes of a Nori file: one, or one for each light."""
    root = ElementTree.parse(file).getroot()
    if root.tag != "scene":
        raise Unsupported("the file holds no <scene>")
    integrator = root.find("integrator")
    kind = None if integrator is None else integrator.get("type")
    if kind not in INTEGRATORS or properties(integrator):
        raise Unsupported(f"only the integrators {' and '.join(INTEGRATORS)}, without properties")
    kinds = ["diffuse"] if kind == "direct_whitted" else ["diffuse", "mirror", "dielectric"]
    folder = os.path.dirname(os.path.abspath(file))
    common = {"type": "scene", "integrator": INTEGRATORS[kind],
              "sensor": mi.load_dict(sensor(mi, root.find("camera"), size, sampler))}
    for i, node in enumerate(root.findall("mesh")):
        common[f"shape{i}"] = mi.load_dict(shape(mi, node, folder, kinds))
    lights = [light_of(node) for node in root.findall("emitter")]
    if kind == "path_mis":
        return [mi.load_dict({**common, **{f"light{i}": light for i, light in enumerate(lights)}})]
    if not lights or any(light["type"] != "point" for light in lights):
        raise Unsupported("direct_whitted without lights, or with others than point lights")
    return [mi.load_dict({**common, "light": light}) for light in lights]


def find_llvm():
    """Dr.Jit loads LLVM by DRJIT_LIBLLVM_PATH; on AVX-512, versions before 19 abort."""
    if "DRJIT_LIBLLVM_PATH" in os.environ:
        return
    found = []
    for file in glob.glob("/usr/lib/*/libLLVM*.so*") + glob.glob("/usr/lib/llvm-*/lib/libLLVM*.so*"):
        version = re.search(r"libLLVM(?:-|\.so\.)(\d+)", file)
        if version:
            found.append((int(version.group(1)), file))
    with open("/proc/cpuinfo", encoding="utf-8") as info:
        needed = 19 if "avx512f" in info.read() else 8
    if not found or max(found)[0] < needed:
        raise Unsupported(f"variant llvm needs LLVM {needed} or newer here: package libllvm19")
    os.environ["DRJIT_LIBLLVM_PATH"] = max(found)[1]


def process_age():
    """Seconds since this process started; the kernel counts in hundredths."""
    with open("/proc/self/stat", encoding="utf-8") as stat:
        started = float(stat.read().rsplit(")", 1)[1].split()[19]) / os.sysconf("SC_CLK_TCK")
    return time.clock_gettime(time.CLOCK_BOOTTIME) - started


def size_of(text):
    width, height = text.split("x")
    return int(width), int(height)


def parse():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("scene")
    parser.add_argument("--variant", default="llvm_ad_rgb", help="llvm_ad_rgb or scalar_rgb")
    parser.add_argument("--sampler", default="independent")
    parser.add_argument("--spp", type=int, default=16)
    parser.add_argument("--size", type=size_of, help="WxH pixels; default: the scene's")
    parser.add_argument("--threads", type=int, default=0, help="0: all")
    parser.add_argument("-o", dest="output", required=True, help="EXR file")
    parser.add_argument("--stats", help="JSON file")
    parser.add_argument("--quiet", action="store_true")
    return parser.parse_args()


def main():
    options = parse()
    try:
        if options.variant.startswith("llvm"):
            find_llvm()
        import drjit
        import mitsuba as mi
    except ImportError:
        raise Unsupported("Mitsuba 3 is not installed: pip install mitsuba")
    mi.set_variant(options.variant)
    if options.threads:
        drjit.set_thread_count(options.threads)
    scenes = translate(mi, options.scene, options.size, options.sampler)

    def render(seed):
        start = time.perf_counter()
        image = sum(mi.render(scene, spp=options.spp, seed=seed) for scene in scenes)
        drjit.eval(image)
        drjit.sync_thread()
        return image, time.perf_counter() - start

    image, _ = render(0)
    mi.Bitmap(image).write(options.output)
    whole = process_age()
    _, seconds = render(1)
    width, height = scenes[0].sensors()[0].film().size()
    stats = {"program": f"Mitsuba {mi.__version__}, {options.variant}",
             "seconds": {"trace": seconds, "process": whole},
             "samples": {"total": options.spp * width * height}}
    if options.stats:
        with open(options.stats, "w", encoding="utf-8") as out:
            json.dump(stats, out)
    if not options.quiet:
        print(f"{stats['program']}: {seconds * 1e3:.1f} ms per render, "
              f"{whole:.2f} s from process start to picture")


if __name__ == "__main__":
    try:
        main()
    except Unsupported as reason:
        print(f"mitsuba_peer.py: {reason}", file=sys.stderr)
        sys.exit(UNAVAILABLE)
