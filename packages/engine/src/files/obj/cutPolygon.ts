import { ShapeUtils, Vector2 } from 'three';

/** Triangles of a polygon. */
export interface CutPolygon {
  /** Corner indices, three per triangle. */
  readonly triangles: readonly number[];
  /** Whether a concave polygon was cut as if convex. */
  readonly isCoarse: boolean;
}

/**
 * Triangulates a polygon, keeping its winding: a fan from the first corner if it is convex, else by ear clipping.
 * @param points - x, y and z of each corner
 * @param most - greatest number of corners for ear clipping
 */
export function cutPolygon(points: readonly number[], most: number): CutPolygon {
  const count = points.length / 3;
  const fan = Array.from({ length: count - 2 }, (_, i) => [0, i + 1, i + 2]).flat();
  const normal = newellNormal(points);
  // `u` and `v` are the axes of a plane on which the polygon is flattened, its front towards the viewer
  const sizes = normal.map(Math.abs);
  const axis = sizes.indexOf(Math.max(...sizes));
  const [u, v] = normal[axis] >= 0 ? [(axis + 1) % 3, (axis + 2) % 3] : [(axis + 2) % 3, (axis + 1) % 3];
  const flat = Array.from({ length: count }, (_, i) => new Vector2(points[i * 3 + u], points[i * 3 + v]));
  const turn = (a: number, b: number, c: number): number =>
    (flat[b].x - flat[a].x) * (flat[c].y - flat[a].y) - (flat[b].y - flat[a].y) * (flat[c].x - flat[a].x);
  const isConvex = flat.every((_, i) => turn(i, (i + 1) % count, (i + 2) % count) >= 0);
  if (isConvex || count > most) return { triangles: fan, isCoarse: !isConvex };
  const ears = ShapeUtils.triangulateShape(flat, []) as [number, number, number][];
  if (ears.length !== count - 2) return { triangles: fan, isCoarse: false };
  return { triangles: ears.flatMap(([a, b, c]) => (turn(a, b, c) < 0 ? [a, c, b] : [a, b, c])), isCoarse: false };
}

/** @see Sutherland, Sproull and Schumacker 1974: Newell's method */
function newellNormal(points: readonly number[]): [number, number, number] {
  const normal: [number, number, number] = [0, 0, 0];
  for (let i = 0; i < points.length; i += 3) {
    const next = (i + 3) % points.length;
    for (let k = 0; k < 3; k++) {
      const [y, z] = [(k + 1) % 3, (k + 2) % 3];
      normal[k] += (points[i + y] - points[next + y]) * (points[i + z] + points[next + z]);
    }
  }
  return normal;
}
