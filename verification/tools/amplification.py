# SPDX-License-Identifier: BSD-3-Clause
"""The step of a bar of particles as a matrix, without the code: which steps are stable (h = c = rho = 1, one dimension).

Stress last, FLIP, with P = M^-1 S^T m (nodes from particles) and A = -M^-1 G^T V (acceleration of nodes from stresses):

    v_p' = v_p + dt S A s,    s' = s + dt G (P v_p + dt A s)

The strain has dt A s of this step whole, the particles keep S A s of it, and the next step sees P S A s. A mode of which P S leaves
the part b is stable to (omega dt)^2 = 4 / (2 - b): to omega dt = 2 where particles keep all, to sqrt 2 where they keep nothing, as
a particle that is alone. Places of particles are fixed within a step.
"""
import numpy as np


def hat(d):
    inside = np.abs(d) < 1.0
    return np.maximum(0.0, 1.0 - np.abs(d)), np.where(inside, -np.sign(d), 0.0)


def box_mean(d, half):
    """Mean of the hat over a box and its gradient (GIMP)."""
    c = np.clip(np.stack([d - half, d + half]), -1.0, 1.0)
    integral = np.where(c < 0.0, 0.5 * (1.0 + c) ** 2, 1.0 - 0.5 * (1.0 - c) ** 2)
    ends = 1.0 - np.abs(c)
    return (integral[1] - integral[0]) / (2.0 * half), (ends[1] - ends[0]) / (2.0 * half)


def matrix(x, half, dt, shape="GIMP"):
    """Amplification of (v_p, s) of particles at x with half sizes `half`, in cells; particles have the mass of their length."""
    nodes = np.arange(int(np.floor(x.min())) - 3, int(np.ceil(x.max())) + 4)
    d = x[:, None] - nodes[None, :]
    S, G = box_mean(d, half) if shape == "GIMP" else hat(d)
    V = 2.0 * half
    mass = V * S.sum(axis=0)
    here = mass > 1e-14
    S, G, mass = S[:, here], G[:, here], mass[here]
    P, A, one = (S * V).T / mass[:, None], -(G * V).T / mass[:, None], np.eye(len(x))
    return np.block([[one, dt * S @ A], [dt * G @ P, one + dt * dt * G @ A]])


def growth(x, half, dt, shape="GIMP"):
    """Largest amplification of a step."""
    return float(np.abs(np.linalg.eigvals(matrix(x, half, dt, shape))).max())


def critical(x, half, shape="GIMP"):
    """The largest stable c dt / h. Eigenvalue 1 of rigid motion is defective: its round-off is the square root of that of a double."""
    low, high = 0.0, 3.0
    for _ in range(40):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if growth(x, half, middle, shape) <= 1.0 + 3e-7 else (low, middle)
    return low


def places(count, per_cell, offset):
    return offset + (np.arange(count) + 0.5) / per_cell
