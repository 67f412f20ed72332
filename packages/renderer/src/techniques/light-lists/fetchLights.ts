import type { Light, Object3D, PointLight, SpotLight } from 'three';
import { fetching } from '../../lights/fetching';

/** Number of objects whose data are fetched together; few enough for a core's caches. */
const FETCHED = 32;
/** Number of objects from which on they are fetched: fewer stay in the caches from frame to frame. */
const FETCHED_FROM = 64;

const HINT =
  'the CPU reads 2,000 lights or more in each frame, every one an object; a LightField (@farol/renderer/light-field) holds them in arrays';

/** Keeps engines from leaving reads out whose values are not used. */
const sums = new Float64Array(1);

/** Lets later frames of all renderers fetch lights ahead. */
export function fetchLightsAhead(): void {
  fetching.fetcher = { fetchPlaces, fetchEmissions, hintFor: (singles) => (singles < 2000 ? null : HINT) };
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
    const { elements: local } = matrix;
    const { elements: world } = matrixWorld;
    // a vector's numbers are objects of their own, a matrix's lie in three lines of the cache
    sum += position.x + position.y + position.z + quaternion.x + quaternion.y + quaternion.z + quaternion.w;
    sum += scale.x + scale.y + scale.z + local[0] + local[8] + local[15] + world[0] + world[8] + world[15];
    sum += layers.mask + children.length + emissionSum(light);
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
