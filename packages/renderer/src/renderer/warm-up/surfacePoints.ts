import type { BufferGeometry, Object3D, Sphere } from 'three';
import type { RenderItem } from '../../frame/RenderItem';
import { hasReadableVertices } from '../../three/vertexData';

/** Numbers of a point: its place, and the area around it times the normal there, both in the space of the object. */
export const POINT = 6;
/** Number of triangles of a geometry, evenly spread, that points lie on. */
const TRIANGLES = 64;
/** Steps of a sequence in two dimensions that spreads evenly: powers of the plastic number (Roberts, 2018). */
const STEPS = [0.7548776662466927, 0.5698402909980532];

const known = new WeakMap<object, Float32Array>();
const none = new Float32Array(0);
const sphere = new Float32Array(128 * POINT);

/** Number of points on the surface of an item. */
export const POINTS = sphere.length / POINT;

/** Points spread evenly over what an item draws; none where that is not known. Valid until the next call. */
export function surfacePoints({ object, geometry, group }: RenderItem): Float32Array {
  // instances, batches and skins have bounds of their own, which three computes to cull them
  const { boundingSphere } = object as Object3D & { boundingSphere?: Sphere | null };
  if (boundingSphere !== undefined) return boundingSphere === null ? none : pointsOnSphere(boundingSphere);
  const key = group ?? geometry;
  let points = known.get(key);
  if (points === undefined) known.set(key, (points = pointsOn(geometry, group)));
  return points;
}

function pointsOnSphere({ center, radius }: Sphere): Float32Array {
  for (let i = 0; i < POINTS; i++) {
    const y = (2 * i + 1) / POINTS - 1;
    const angle = 2 * Math.PI * STEPS[0] * i;
    const ring = Math.sqrt(1 - y * y);
    const normal = [ring * Math.cos(angle), y, ring * Math.sin(angle)];
    for (let axis = 0; axis < 3; axis++) {
      sphere[POINT * i + axis] = center.getComponent(axis) + radius * normal[axis];
      sphere[POINT * i + 3 + axis] = (4 * Math.PI * radius * radius * normal[axis]) / POINTS;
    }
  }
  return sphere;
}

function pointsOn(geometry: BufferGeometry, group: RenderItem['group']): Float32Array {
  if (!hasReadableVertices(geometry)) return none;
  const { index, attributes, drawRange } = geometry;
  const { position } = attributes;
  const first = Math.max(drawRange.start, group?.start ?? 0);
  const end = Math.min(
    index?.count ?? position.count,
    drawRange.start + drawRange.count,
    group === null ? Infinity : group.start + group.count,
  );
  const triangles = Math.floor((end - first) / 3);
  if (triangles <= 0) return none;
  const count = Math.min(triangles, TRIANGLES);
  const corner = (triangle: number, k: number, axis: number): number => {
    const i = first + 3 * Math.floor((triangle * triangles) / count) + k;
    return position.getComponent(index === null ? i : index.getX(i), axis);
  };
  const edge = (triangle: number, k: number, axis: number) => corner(triangle, k, axis) - corner(triangle, 0, axis);
  const crosses = Array.from({ length: count }, (_, t) =>
    [1, 2, 0].map((a, i) => edge(t, 1, a) * edge(t, 2, (i + 2) % 3) - edge(t, 1, (i + 2) % 3) * edge(t, 2, a)),
  );
  const areas = crosses.map((cross) => Math.hypot(...cross) / 2);
  const area = areas.reduce((sum, one) => sum + one, 0);
  const points = new Float32Array(POINTS * POINT);
  let below = 0;
  for (let i = 0, triangle = 0; i < POINTS; i++) {
    while (triangle < count - 1 && below + areas[triangle] < ((i + 0.5) / POINTS) * area) below += areas[triangle++];
    let [u, v] = STEPS.map((step) => (i * step) % 1);
    if (u + v > 1) [u, v] = [1 - u, 1 - v];
    const share = ((area / POINTS) * (triangles / count)) / (2 * areas[triangle] || 1);
    for (let axis = 0; axis < 3; axis++) {
      points[POINT * i + axis] = corner(triangle, 0, axis) + u * edge(triangle, 1, axis) + v * edge(triangle, 2, axis);
      points[POINT * i + 3 + axis] = share * crosses[triangle][axis];
    }
  }
  return points;
}
