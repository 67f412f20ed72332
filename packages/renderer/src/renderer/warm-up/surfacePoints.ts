import { type BufferGeometry, type Object3D, type Sphere, Vector3 } from 'three';
import type { RenderItem } from '../../frame/RenderItem';
import { hasReadableVertices } from '../../three/vertexData';

/** Count of a point's numbers: its position, then the normal there times the area that it stands for (object's own space). */
export const POINT = 6;
/** Maximum number of a geometry's triangles, evenly spread, that points lie on. */
const TRIANGLES = 64;
/** Steps of the low-discrepancy sequence R2: powers of the plastic number (Roberts 2018). */
const STEPS = [0.7548776662466927, 0.5698402909980532];

const known = new WeakMap<object, Float32Array>();
const none = new Float32Array(0);
/** First corner, both edges from there, their cross product, and area of each triangle. */
const origins = new Float64Array(3 * TRIANGLES);
const edges = new Float64Array(6 * TRIANGLES);
const normals = new Float64Array(3 * TRIANGLES);
const areas = new Float64Array(TRIANGLES);
const corners = [new Vector3(), new Vector3(), new Vector3()];
const sphere = new Float32Array(48 * POINT);

/** Number of points on an item's surface. */
export const POINTS = sphere.length / POINT;

/** Points spread evenly over the surface that an item draws; none if the CPU cannot read it. Valid until the next call. */
export function surfacePoints(item: RenderItem): Float32Array {
  // instances, batches and skins have bounds of their own, which three computes to cull them
  const { boundingSphere } = item.object as Object3D & { boundingSphere?: Sphere | null };
  if (boundingSphere === undefined) return geometryPoints(item);
  return boundingSphere === null ? none : pointsOnSphere(boundingSphere);
}

/** Points of an item that is one copy of its geometry. */
export function geometryPoints({ geometry, group }: RenderItem): Float32Array {
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
  let area = 0;
  for (let t = 0; t < count; t++) {
    for (let k = 0; k < 3; k++) {
      const vertex = first + 3 * Math.floor((t * triangles) / count) + k;
      corners[k].fromBufferAttribute(position, index === null ? vertex : index.getX(vertex));
    }
    const [a, b, c] = corners;
    b.sub(a).toArray(edges, 6 * t);
    c.sub(a).toArray(edges, 6 * t + 3);
    a.toArray(origins, 3 * t);
    a.crossVectors(b, c).toArray(normals, 3 * t);
    areas[t] = a.length() / 2;
    area += areas[t];
  }
  const points = new Float32Array(POINTS * POINT);
  let below = 0;
  for (let i = 0, t = 0; i < POINTS; i++) {
    while (t < count - 1 && below + areas[t] < ((i + 0.5) / POINTS) * area) below += areas[t++];
    let u = (i * STEPS[0]) % 1;
    let v = (i * STEPS[1]) % 1;
    if (u + v > 1) [u, v] = [1 - u, 1 - v];
    const share = ((area / POINTS) * (triangles / count)) / (2 * areas[t] || 1);
    for (let axis = 0; axis < 3; axis++) {
      points[POINT * i + axis] = origins[3 * t + axis] + u * edges[6 * t + axis] + v * edges[6 * t + 3 + axis];
      points[POINT * i + 3 + axis] = share * normals[3 * t + axis];
    }
  }
  return points;
}
