import type { ProbeBox } from '@farol/renderer/light-probes';
import { Box3, SphericalHarmonics3, Vector3 } from 'three';
import type { BakeMesh } from './bakeSources';

/** Maximum number of probes along an axis, and in all. */
const MOST_ALONG = 32;
const MOST = 8192;
/** Share of directions that hit back faces, above which a probe counts as inside a solid. */
const WITHIN = 0.25;

const box = new Box3();
const part = new Box3();
const size = new Vector3();

/**
 * Grid of probes for a scene: a box around all static meshes.
 * @param spacing - smallest distance between probes (m)
 * @returns null when nothing is static
 */
export function probeBox(meshes: readonly BakeMesh[], spacing: number): ProbeBox | null {
  box.makeEmpty();
  for (const { mesh } of meshes) {
    mesh.updateWorldMatrix(true, false);
    box.union(part.setFromObject(mesh));
  }
  if (box.isEmpty()) return null;
  box.getSize(size);
  let counts: [number, number, number];
  let step = spacing;
  do {
    const along = (length: number): number => Math.min(Math.max(Math.round(length / step), 2), MOST_ALONG);
    counts = [along(size.x), along(size.y), along(size.z)];
    step *= 1.1;
  } while (counts[0] * counts[1] * counts[2] > MOST);
  return { min: box.min.toArray(), max: box.max.toArray(), counts };
}

/**
 * Gives probes inside solids the light of neighbouring probes, weighted by nearness, so that no darkness leaks out of
 * walls. Changes `coefficients` in place.
 * @param backFaces - for each probe, the share of directions that hit back faces
 */
export function fillBuriedProbes({ counts }: ProbeBox, coefficients: Float32Array, backFaces: Float32Array): void {
  const [nx, ny, nz] = counts;
  let known = Array.from(backFaces, (share) => share <= WITHIN);
  while (known.some(Boolean) && !known.every(Boolean)) {
    const next = [...known];
    for (let i = 0; i < known.length; i++) {
      if (known[i]) continue;
      const [x, y, z] = [i % nx, Math.floor(i / nx) % ny, Math.floor(i / (nx * ny))];
      const sum = new Float32Array(27);
      let weight = 0;
      for (let n = 0; n < 27; n++) {
        const [dx, dy, dz] = [(n % 3) - 1, (Math.floor(n / 3) % 3) - 1, Math.floor(n / 9) - 1];
        const isIn = x + dx >= 0 && x + dx < nx && y + dy >= 0 && y + dy < ny && z + dz >= 0 && z + dz < nz;
        const other = i + dx + nx * (dy + ny * dz);
        if (!isIn || !known[other]) continue;
        const share = 1 / Math.hypot(dx, dy, dz);
        weight += share;
        for (let c = 0; c < 27; c++) sum[c] += share * coefficients[27 * other + c];
      }
      if (weight === 0) continue;
      next[i] = true;
      for (let c = 0; c < 27; c++) coefficients[27 * i + c] = sum[c] / weight;
    }
    known = next;
  }
}

/** Directions in which light may not be negative: to the corners, edges and faces of a cube. */
const directions = Array.from(
  { length: 27 },
  (_, i) => new Vector3((i % 3) - 1, (Math.floor(i / 3) % 3) - 1, Math.floor(i / 9) - 1),
)
  .filter((direction) => direction.lengthSq() > 0)
  .map((direction) => direction.normalize());
const harmonics = new SphericalHarmonics3();
const irradiance = new Vector3();

/**
 * Removes ringing from probes: where second-order harmonics would give negative light opposite a strong light, higher
 * orders are damped just enough. Changes `coefficients` in place.
 * @see Sloan, Stupid Spherical Harmonics Tricks, 2008
 */
export function dampRinging(coefficients: Float32Array): void {
  for (let at = 0; at < coefficients.length; at += 27) {
    const own = coefficients.slice(at, at + 27);
    for (let damping = 0; damping < 1; damping = 1.5 * damping + 0.005) {
      for (let i = 3; i < 27; i++) {
        const order = i < 12 ? 1 : 2;
        coefficients[at + i] = own[i] / (1 + damping * (order * (order + 1)) ** 2);
      }
      harmonics.fromArray([...coefficients.subarray(at, at + 27)]);
      const isPositive = directions.every((direction) => {
        harmonics.getIrradianceAt(direction, irradiance);
        return irradiance.x >= 0 && irradiance.y >= 0 && irradiance.z >= 0;
      });
      if (isPositive) break;
    }
  }
}
