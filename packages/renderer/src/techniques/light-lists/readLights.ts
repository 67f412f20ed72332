import { type Light, Object3D, type PointLight, type SpotLight } from 'three';
import { fetching } from '../../lights/fetching';
import { type FoundLights, POSE } from '../../lights/FoundLights';
import { isPlainPoint, POINT, writePoint } from '../../lights/plainPoints';

/** Objects whose data are fetched together; few enough for the caches of a processor's core. */
const FETCHED = 32;
/** Number of objects from which on they are fetched: fewer stay in the caches from frame to frame. */
const FETCHED_FROM = 64;

const HINT =
  'the CPU reads 2,000 lights or more in each frame, every one an object; a LightField (@farol/renderer/light-field) holds them in arrays';

const { updateMatrix, updateMatrixWorld } = Object3D.prototype;

/** Keeps engines from leaving reads out whose values are not used. */
const sums = new Float64Array(1);

/** Lets later frames of all renderers read lights by the thousand. */
export function readLightsInRows(): void {
  fetching.reader = { readPoints, fetchEmissions, hintFor: (singles) => (singles < 2000 ? null : HINT) };
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
    if (all[count] === light && isTurnedAs(light, poses, count * POSE, local[10], world[10])) {
      // other elements lie in other lines of the cache, which are waited for
      local[12] = world[12] = x;
      local[13] = world[13] = y;
      local[14] = world[14] = z;
    } else {
      light.updateMatrix();
      matrixWorld.copy(matrix);
      keepPose(light, poses, count * POSE);
      all[count] = light;
    }
    if (light.matrixWorldNeedsUpdate) light.matrixWorldNeedsUpdate = false;
    count++;
  }
  found.count = count;
  return i;
}

/** Whether three makes the light's matrices of position, quaternion and scale alone. */
function composes(light: PointLight): boolean {
  const { pivot } = light as PointLight & { pivot?: unknown };
  if (pivot !== undefined && pivot !== null) return false;
  if (light.updateMatrixWorld !== updateMatrixWorld || light.updateMatrix !== updateMatrix) return false;
  return light.matrixAutoUpdate && light.matrixWorldAutoUpdate;
}

/**
 * Whether quaternion and scale are those that the matrices were last composed of. A host that wrote to matrices which three
 * composes shows by element 10, beside the place in memory; a rotation about z written there does not, and nothing is lit by it.
 */
function isTurnedAs({ quaternion, scale }: PointLight, poses: Float64Array, at: number, local: number, world: number) {
  const known = poses[at + 7];
  if (local !== known || world !== known) return false;
  if (quaternion.x !== poses[at] || quaternion.y !== poses[at + 1]) return false;
  if (quaternion.z !== poses[at + 2] || quaternion.w !== poses[at + 3]) return false;
  return scale.x === poses[at + 4] && scale.y === poses[at + 5] && scale.z === poses[at + 6];
}

function keepPose({ quaternion, scale, matrix }: PointLight, poses: Float64Array, at: number): void {
  // typed arrays are arrays to three
  quaternion.toArray(poses as ArrayLike<number> as number[], at);
  scale.toArray(poses as ArrayLike<number> as number[], at + 4);
  poses[at + 7] = matrix.elements[10];
}

// Lights lie scattered in memory. Reads without work between them wait for it together; those of code that works light
// after light wait one after the other.

function fetchPlaces(objects: readonly Object3D[], first: number): number {
  if (objects.length < FETCHED_FROM) return objects.length;
  const end = Math.min(objects.length, first + FETCHED);
  let sum = 0;
  for (let i = first; i < end; i++) {
    const light = objects[i];
    if (!isLocal(light)) continue;
    const { position, quaternion, scale, matrix, matrixWorld, layers, children } = light;
    // a vector's numbers are objects of their own, a matrix's lie in three lines of the cache
    sum += position.x + position.z + quaternion.x + quaternion.w + scale.x + scale.z;
    sum += matrix.elements[12] + matrixWorld.elements[12] + layers.mask + children.length + emissionSum(light);
  }
  sums[0] = sum;
  return end;
}

function fetchEmissions(lights: readonly Light[], first: number): number {
  if (lights.length < FETCHED_FROM) return lights.length;
  const end = Math.min(lights.length, first + FETCHED);
  let sum = 0;
  for (let i = first; i < end; i++) {
    const light = lights[i];
    if (!isLocal(light)) continue;
    sum += emissionSum(light);
  }
  sums[0] = sum;
  return end;
}

function emissionSum({ color, intensity, distance, decay, userData }: PointLight): number {
  return color.r + color.g + color.b + intensity + distance + decay + (userData.farol === undefined ? 0 : 1);
}

function isLocal(object: Object3D): object is PointLight {
  return (object as PointLight).isPointLight === true || (object as object as SpotLight).isSpotLight === true;
}
