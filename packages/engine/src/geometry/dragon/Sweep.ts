import type { Vector3Tuple } from '@farol/editing/fields';
import { Vector3 } from 'three';
import type { Surface } from '../MeshBuilder';

/**
 * A point of a cross-section for u from 0 to 1 round it and v from 0 to 1 along: offsets to the side and upwards (m).
 */
export type Section = (u: number, v: number) => readonly [side: number, up: number];

const [moved, tangent] = [new Vector3(), new Vector3()];

/** A round cross-section, whose radius (m) may vary along the curve. */
export const round =
  (radius: (v: number) => number): Section =>
  (u, v) => {
    const angle = 2 * Math.PI * u;
    return [radius(v) * Math.cos(angle), radius(v) * Math.sin(angle)];
  };

/** Number of chords by which the length of a curve is measured. */
const PIECES = 400;

/** Half the step of the curve parameter in the finite difference by which the curve's directions are computed. */
const STEP = 1e-4;

/** Value at t of a spline through four points, between the second and third of `knots`. @see Barry and Goldman 1988 */
function between(points: readonly number[], knots: readonly number[], t: number): number {
  let level = points;
  for (let degree = 1; degree < 4; degree++) {
    level = level.slice(1).map((next, i) => {
      // the last level interpolates from the second to the third knot
      const [from, to] = degree === 3 ? [knots[1], knots[2]] : [knots[i], knots[i + degree]];
      return (level[i] * (to - t) + next * (t - from)) / (to - from);
    });
  }
  return level[0];
}

/** A curve through points, for shapes swept along it. The curve must nowhere run straight along z. */
export class Sweep {
  /** Length (m) of the curve from its beginning to the end of each of the `PIECES` chords. */
  private readonly lengths: number[] = [0];
  private readonly points: readonly Vector3Tuple[];
  private readonly point = new Vector3();
  private readonly across = new Vector3();
  private readonly upwards = new Vector3();
  /** Parameter (0 to 1) that `point`, `across` and `upwards` were last computed for; NaN at first. */
  private placed = NaN;

  /** @param through - two points or more; the curve is a centripetal Catmull-Rom spline */
  constructor(through: readonly Vector3Tuple[]) {
    const mirrored = (end: Vector3Tuple, next: Vector3Tuple): Vector3Tuple => [
      2 * end[0] - next[0],
      2 * end[1] - next[1],
      2 * end[2] - next[2],
    ];
    const last = through.length - 1;
    this.points = [mirrored(through[0], through[1]), ...through, mirrored(through[last], through[last - 1])];
    let before = this.pointAt(0, new Vector3());
    for (let i = 1; i <= PIECES; i++) {
      const point = this.pointAt(i / PIECES, new Vector3());
      this.lengths.push(this.lengths[i - 1] + point.distanceTo(before));
      before = point;
    }
  }

  /** Point at t from 0 to 1; each pair of given points spans an equal part of t. */
  private pointAt(t: number, target: Vector3): Vector3 {
    const count = this.points.length - 3;
    const first = Math.min(Math.floor(t * count), count - 1);
    const four = this.points.slice(first, first + 4);
    const knots = [0];
    for (let i = 1; i < 4; i++) {
      const [a, b] = [four[i - 1], four[i]];
      knots.push(knots[i - 1] + Math.sqrt(Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2])));
    }
    const at = knots[1] + (t * count - first) * (knots[2] - knots[1]);
    const [x, y, z] = [0, 1, 2].map((axis) =>
      between(
        four.map((point) => point[axis]),
        knots,
        at,
      ),
    );
    return target.set(x, y, z);
  }

  /** Curve parameter (0 to 1) at a share of the length (0 to 1). */
  private parameterAt(part: number): number {
    const length = part * this.lengths[PIECES];
    let piece = 0;
    while (piece < PIECES - 1 && this.lengths[piece + 1] < length) piece++;
    const [from, to] = [this.lengths[piece], this.lengths[piece + 1]];
    return (piece + (to > from ? (length - from) / (to - from) : 0)) / PIECES;
  }

  /** Point of the curve at v (0 to 1), with offsets perpendicular to the curve: to the side (+z), and upwards. */
  at(v: number, side = 0, up = 0): Vector3Tuple {
    if (v !== this.placed) this.place(v);
    moved.copy(this.point).addScaledVector(this.across, side).addScaledVector(this.upwards, up);
    return [moved.x, moved.y, moved.z];
  }

  /** Computes point and directions at v; cached, since a whole ring of vertices shares v. */
  private place(v: number): void {
    const t = this.parameterAt(Math.min(1, Math.max(0, v)));
    this.pointAt(Math.min(1, t + STEP), tangent)
      .sub(this.pointAt(Math.max(0, t - STEP), moved))
      .normalize();
    this.across.set(0, 0, 1).addScaledVector(tangent, -tangent.z).normalize();
    // points up where the curve runs towards +x
    this.upwards.crossVectors(this.across, tangent);
    this.pointAt(t, this.point);
    this.placed = v;
  }

  /** Surface of a cross-section swept along the curve, for `MeshBuilder.surface`. */
  surface(section: Section): Surface {
    // faces outwards: anticlockwise seen against the curve's direction
    return (u, v) => this.at(v, ...section(1 - u, v));
  }
}
