# SPDX-License-Identifier: BSD-3-Clause
"""The jet in flight when its tip meets the target: outline, velocity, and the mass that has come by."""

from barreno.runs.plots import plt


def draw(file, title, slugs, start):
    """@param start  distance of the target's face from the launch plane [m]"""
    tip = max(slugs, key=lambda slug: slug.velocity)
    met = tip.time + start / tip.velocity
    ahead = [1e3 * (slug.velocity * (met - slug.time) - start) for slug in slugs]
    figure, (outline, speed) = plt.subplots(2, 1, figsize=(9.0, 5.4), sharex=True, height_ratios=(1, 1.6))
    for x, slug in zip(ahead, slugs):
        half, radius = 5e2 * slug.length, 1e3 * slug.radius
        outline.fill([x - half, x + half, x + half, x - half], [-radius, -radius, radius, radius],
            color="0.55" if slug.piece else "C3", alpha=max(0.15, slug.density / max(one.density for one in slugs)), lw=0.0)
    outline.axvline(0.0, color="k", lw=1.0)
    outline.set_ylabel("radius [mm]")
    mixed = any(slug.piece for slug in slugs) and not all(slug.piece for slug in slugs)
    outline.set_title(title + (" (red: whole, grey: in pieces)" if mixed else ""), fontsize=10, wrap=True)
    speed.plot(ahead, [1e-3 * slug.velocity for slug in slugs], "C0", lw=1.4)
    speed.set_ylabel("velocity [km/s]", color="C0")
    speed.set_ylim(bottom=0.0)
    speed.set_xlabel("distance from the target's face when the tip meets it [mm]")
    behind = speed.twinx()
    whole, mass, part = sum(slug.mass for slug in slugs), 0.0, []
    for slug in slugs:
        mass += slug.mass
        part.append(100.0 * mass / whole)
    behind.plot(ahead, part, "C1", lw=1.4)
    behind.set_ylabel("mass ahead [%]", color="C1")
    behind.set_ylim(0.0, 102.0)
    figure.tight_layout()
    figure.savefig(file, dpi=120, format="png")
    plt.close(figure)
