"""Peers on our sheet: a leaf of office paper clamped level and let go, with the heavy elastica as judge.

Writes the file that `dogleaf cost --peers` draws. Every peer runs on one thread, in this process, from its wheel.

    python sheets.py OUT [EIGEN.json]

What a peer calls a clamp differs: here the first two columns of nodes are held, and the length counts from the
middle between them. Rigidity, mass and length are those of the leaf that `dogleaf cost` lets fall.
"""

import json
import math
import os
import sys
import time

# Before any peer is loaded: its threads are counted when it is.
os.environ["OMP_NUM_THREADS"] = "1"

WIDTH, HEIGHT = 0.15, 0.20
NX, NZ = 11, 8
AREAL, THICKNESS, YOUNG, POISSON, G = 0.080, 0.104e-3, 4.5e9, 0.2, 9.81
RIGIDITY = YOUNG * THICKNESS**3 / 12 / (1 - POISSON**2)
GAMMA = AREAL * G * WIDTH**3 / RIGIDITY
DX, DZ = WIDTH / (NX - 1.5), HEIGHT / (NZ - 1)
REST_S, FALL_S = 12.0, 0.25
STILL = 2e-3


def elastica(gamma, steps=2000):
    """Drop over reach of the heavy elastica, by shooting."""

    def shoot(start):
        h, s, y = 1 / steps, 0.0, [0.0, start, 0.0, 0.0]
        slope = lambda s, y: [y[1], -gamma * (1 - s) * math.cos(y[0]), math.cos(y[0]), math.sin(y[0])]
        for _ in range(steps):
            k1 = slope(s, y)
            k2 = slope(s + h / 2, [a + h / 2 * b for a, b in zip(y, k1)])
            k3 = slope(s + h / 2, [a + h / 2 * b for a, b in zip(y, k2)])
            k4 = slope(s + h, [a + h * b for a, b in zip(y, k3)])
            y = [a + h / 6 * (p + 2 * q + 2 * r + t) for a, p, q, r, t in zip(y, k1, k2, k3, k4)]
            s += h
        return y

    low, high = 0.0, gamma
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if shoot(middle)[1] < 0 else (low, middle)
    y = shoot((low + high) / 2)
    return y[3] / y[2]


def watch(step, tip, rate, broken=lambda: False):
    """Steps a peer: drop at the end of the fall, drop over reach at rest, median time of a step."""
    times, fall, last, ratio = [], None, None, None
    for n in range(1, int(REST_S * rate) + 1):
        start = time.perf_counter()
        step()
        times.append(time.perf_counter() - start)
        x, drop = tip()
        if broken() or not (math.isfinite(x) and math.isfinite(drop) and abs(drop) < 10 * WIDTH):
            return None, None, 1e6 * sorted(times)[len(times) // 2]
        if fall is None and n >= FALL_S * rate - 0.5:
            fall = drop
        if n >= (REST_S - 0.5) * rate and last is None:
            last = drop
        ratio = drop / (x - DX / 2) if x > DX else None
    still = last is not None and abs(drop - last) < STILL * WIDTH
    return fall, ratio if still else None, 1e6 * sorted(times)[len(times) // 2]


def mujoco_rows():
    import mujoco

    pins = " ".join(str(i * NZ + k) for i in range(2) for k in range(NZ))
    young = YOUNG / (1 - POISSON**2)
    mass = AREAL * DX * (NX - 1) * HEIGHT
    for integrator, rate, damping in [
        ("discrete", 60, 0.0),
        ("discrete", 240, 0.0),
        ("discrete", 960, 0.0),
        ("discrete", 240, 0.05),
        ("Euler", 960, 0.0),
    ]:
        xml = f"""<mujoco><option timestep="{1 / rate}" gravity="0 0 -{G}" integrator="{integrator}"/>
<worldbody><flexcomp name="leaf" type="grid" dim="2" count="{NX} {NZ} 1" spacing="{DX} {DZ} 0.01" mass="{mass}" radius="0.0001"
 pos="{DX * (NX - 1) / 2} 0 0"><contact selfcollide="none" contype="0" conaffinity="0"/>
<elasticity young="{young}" poisson="0" thickness="{THICKNESS}" elastic2d="both" damping="{damping}"/>
<pin id="{pins}"/></flexcomp></worldbody></mujoco>"""
        model = mujoco.MjModel.from_xml_string(xml)
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
        edge = slice((NX - 1) * NZ, NX * NZ)

        def tip():
            points = data.flexvert_xpos[edge]
            return float(points[:, 0].mean()), -float(points[:, 2].mean())

        def broken():
            return data.warning[mujoco.mjtWarning.mjWARN_BADQACC].number > 0

        fall, ratio, us = watch(lambda: mujoco.mj_step(model, data), tip, rate, broken)
        dials = f"{integrator}, {NX}x{NZ}, {rate}/s" + (f", damping {damping}" if damping else "")
        yield row(f"MuJoCo {mujoco.__version__} flex", dials, fall, ratio, us, rate)


def pbd_rows():
    import importlib.metadata

    import numpy
    import pypbd

    version = importlib.metadata.version("pyPBD")
    for iterations, substeps in [(5, 1), (20, 1), (100, 1), (5, 5), (1, 20), (1, 50)]:
        simulation = pypbd.Simulation.getCurrent()
        simulation.initDefault()
        model = simulation.getModel()
        points = [[DX * i, 0.0, DZ * k] for i in range(NX) for k in range(NZ)]
        at = lambda i, k: i * NZ + k
        faces = []
        for i in range(NX - 1):
            for k in range(NZ - 1):
                a, b, c, d = at(i, k), at(i + 1, k), at(i, k + 1), at(i + 1, k + 1)
                faces += [a, b, c, c, b, d] if (i + k) % 2 else [a, b, d, a, d, c]
        leaf = model.addTriangleModel(points, faces, testMesh=False)
        particles = model.getParticles()
        cell = AREAL * DX * DZ
        for i in range(NX):
            for k in range(NZ):
                share = (0.5 if i in (0, NX - 1) else 1) * (0.5 if k in (0, NZ - 1) else 1)
                particles.setMass(at(i, k), 0.0 if i < 2 else cell * share)
        # Compliance in its own terms: edges as stiff as paper, bending by the rigidity.
        model.addClothConstraints(leaf, 4, YOUNG * THICKNESS, 1, 1, 1, POISSON, POISSON, False, False)
        model.addBendingConstraints(leaf, 3, RIGIDITY)
        controller = simulation.getTimeStep()
        controller.setValueUInt(pypbd.TimeStepController.NUM_SUB_STEPS, substeps)
        controller.setValueUInt(pypbd.TimeStepController.MAX_ITERATIONS, iterations)
        pypbd.TimeManager.getCurrent().setTimeStepSize(1 / 60)

        def tip():
            end = numpy.array([particles.getPosition(at(NX - 1, k)) for k in range(NZ)])
            return float(end[:, 0].mean()), -float(end[:, 1].mean())

        fall, ratio, us = watch(lambda: controller.step(model), tip, 60)
        yield row(f"pyPBD {version} XPBD", f"{iterations} iterations x {substeps} substeps, {NX}x{NZ}, 60/s", fall, ratio, us, 60)
        simulation.reset()


def row(name, config, fall, ratio, us, rate):
    return {
        "name": name,
        "config": config,
        "gamma": GAMMA,
        "ratio": ratio,
        "elastica": elastica(GAMMA),
        "step_us": us,
        "rate": rate,
        "fall_m": fall,
    }


def main():
    out, rest = sys.argv[1], sys.argv[2:]
    rows, omissions, linear = [], [], []
    for name, peer in [("MuJoCo", mujoco_rows), ("pyPBD", pbd_rows)]:
        try:
            for one in peer():
                rows.append(one)
                ratio = "no rest" if one["ratio"] is None else f"{one['ratio']:.3f}"
                fall = "ran away" if one["fall_m"] is None else f"{one['fall_m']:.4f} m"
                print(f"{one['name']:24} {one['config']:44} drop/reach {ratio:8} (elastica {one['elastica']:.3f})  fall {fall:10} {one['step_us']:8.0f} us")
                if one["ratio"] is None:
                    omissions.append(f"{one['name']}, {one['config']}: did not come to rest in {REST_S:.0f} s" if one["fall_m"] else f"{one['name']}, {one['config']}: ran away")
        except Exception as why:
            omissions.append(f"{name}: {type(why).__name__}: {why}")
            print(omissions[-1])
    if rest:
        with open(rest[0]) as file:
            found = json.load(file)
        linear = [[r["name"], r["total_us"]] for r in found["rows"] if "total_us" in r]
    with open(out, "w") as file:
        json.dump({"rows": rows, "linear": linear, "omissions": omissions}, file, indent=1)


if __name__ == "__main__":
    main()
