import { Object3D, type PointLight, type SpotLight } from 'three';
import { fetching } from '../../lights/fetching';
import type { FoundLights } from '../../lights/FoundLights';
import { isPlainPoint, POINT, writePoint } from '../../lights/plainPoints';

/** Number of objects whose data are read ahead together; few enough for a core's caches. */
const FETCHED = 32;
/** Number of objects from which on data are read ahead; fewer stay in the caches from frame to frame. */
const FETCHED_FROM = 64;

const HINT =
  'the CPU reads 2,000 lights or more in each frame, every one an object; a LightField (@farol/renderer/light-field) holds them in arrays';

const { updateMatrix, updateMatrixWorld } = Object3D.prototype;

/** Receives a sum of the values read ahead, so that engines do not optimise the reads away. */
const sums = new Float64Array(1);

/** Installs a faster reader of many lights for later frames of all renderers. */
export function readLightsInRows(): void {
  fetching.reader = { readPoints, hintFor: (singles) => (singles < 2000 ? null : HINT) };
}

function readPoints(parent: Object3D, first: number, mask: number, found: FoundLights): number {
  const { children } = parent;
  let { all, count, points, poses } = found;
  let i = first;
  for (; i < children.length; i++) {
    if (i >= found.fetched) found.fetched = fetchPlaces(children, i);
    const light = children[i] as PointLight;
    if (!isPlainPoint(light) || light.parent !== parent || !light.visible || light.children.length > 0) break;
    if ((light.layers.mask & mask) === 0 || !composes(light)) break;
    if (points.length === count * POINT) {
      found.count = count;
      found.reserve(children.length - i);
      ({ points, poses } = found);
    }
    const { position, matrix, matrixWorld } = light;
    const { x, y, z } = position;
    if (!writePoint(light, x, y, z, points, count * POINT)) break;
    const { elements: local } = matrix;
    const { elements: world } = matrixWorld;
    if (all[count] === light && isTurnedAs(light, poses, count * POINT, local[10], world[10])) {
      // writes only the position: other elements would wait for more cache lines
      local[12] = world[12] = x;
      local[13] = world[13] = y;
      local[14] = world[14] = z;
    } else {
      light.updateMatrix();
      matrixWorld.copy(matrix);
      keepPose(light, poses, count * POINT);
      all[count] = light;
    }
    if (light.matrixWorldNeedsUpdate) light.matrixWorldNeedsUpdate = false;
    count++;
  }
  found.count = count;
  return i;
}

/** Whether three composes the light's matrices from position, quaternion and scale alone. */
function composes(light: PointLight & { pivot?: unknown }): boolean {
  return (
    light.matrixAutoUpdate &&
    light.matrixWorldAutoUpdate &&
    light.updateMatrixWorld === updateMatrixWorld &&
    light.updateMatrix === updateMatrix &&
    (light.pivot ?? null) === null
  );
}

/**
 * Whether quaternion and scale are those of the last composition. If a host wrote to the composed matrices, element 10, in the
 * position's cache line, has changed, except for a rotation about z, which does not change a point light.
 */
function isTurnedAs({ quaternion, scale }: PointLight, poses: Float64Array, at: number, local: number, world: number) {
  return (
    local === poses[at + 7] &&
    world === local &&
    quaternion.x === poses[at] &&
    quaternion.y === poses[at + 1] &&
    quaternion.z === poses[at + 2] &&
    quaternion.w === poses[at + 3] &&
    scale.x === poses[at + 4] &&
    scale.y === poses[at + 5] &&
    scale.z === poses[at + 6]
  );
}

function keepPose({ quaternion, scale, matrix }: PointLight, poses: Float64Array, at: number): void {
  // three writes to typed arrays as to arrays
  quaternion.toArray(poses as ArrayLike<number> as number[], at);
  scale.toArray(poses as ArrayLike<number> as number[], at + 4);
  poses[at + 7] = matrix.elements[10];
}

// Lights are scattered in memory. Reads one after another, without work between them, overlap their cache misses; code
// that works on each light in turn waits for each miss.

function fetchPlaces(objects: readonly Object3D[], first: number): number {
  if (objects.length < FETCHED_FROM) return objects.length;
  const end = Math.min(objects.length, first + FETCHED);
  let sum = 0;
  for (let i = first; i < end; i++) {
    const light = objects[i];
    if (!isLocal(light)) continue;
    const { position, quaternion, scale, matrix, matrixWorld, layers, children } = light;
    // engines may box each number of a vector; a matrix's elements span three cache lines
    sum += position.x + position.z + quaternion.x + quaternion.w + scale.x + scale.z;
    sum += matrix.elements[12] + matrixWorld.elements[12] + layers.mask + children.length;
    const { color, intensity, distance, decay, userData } = light;
    sum += color.r + color.b + intensity + distance + decay + (userData.farol === undefined ? 0 : 1);
  }
  sums[0] = sum;
  return end;
}

function isLocal(object: Object3D): object is PointLight {
  return (object as PointLight).isPointLight === true || (object as object as SpotLight).isSpotLight === true;
}
