import { CatmullRomCurve3, Vector3 } from 'three';
import type { Vector3Tuple } from '../../fields/Field';
import type { Surface } from '../../geometry/MeshBuilder';

/** A point of a cross-section for u from 0 to 1 round it and v from 0 to 1 along: offsets to the side and upwards (m). */
export type Section = (u: number, v: number) => readonly [side: number, up: number];

const [aside, tangent, across, upwards] = Array.from({ length: 4 }, () => new Vector3());

/** A round cross-section of a radius (m) that may change along the way. */
export const round =
  (radius: (v: number) => number): Section =>
  (u, v) => {
    const angle = 2 * Math.PI * u;
    return [radius(v) * Math.cos(angle), radius(v) * Math.sin(angle)];
  };

/** A curve through points, and what is swept along it. It may go anywhere but straight to the side (z). */
export class Sweep {
  private readonly curve: CatmullRomCurve3;

  constructor(points: readonly Vector3Tuple[]) {
    this.curve = new CatmullRomCurve3(points.map((point) => new Vector3(...point)));
    this.curve.arcLengthDivisions = 400;
  }

  /** The point of the curve at v from 0 to 1, moved by offsets to the side (z) and upwards, across the curve. */
  at(v: number, side = 0, up = 0): Vector3Tuple {
    this.curve.getTangentAt(v, tangent);
    across.set(0, 0, 1).addScaledVector(tangent, -tangent.z).normalize();
    // above the curve where it goes towards +x
    upwards.crossVectors(across, tangent);
    this.curve.getPointAt(v, aside).addScaledVector(across, side).addScaledVector(upwards, up);
    return [aside.x, aside.y, aside.z];
  }

  /** The surface of a section along the curve, for `MeshBuilder.surface`. */
  surface(section: Section): Surface {
    // facing out: anticlockwise seen from where the curve comes from
    return (u, v) => this.at(v, ...section(1 - u, v));
  }
}
