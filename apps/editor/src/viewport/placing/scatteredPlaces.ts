import { createRandom } from '@farol/engine';
import { Quaternion, Vector3 } from 'three';
import { type ArrangedPlace, type Arrangement, MOST_COPIES } from '../../model/arrange/Arrangement';
import type { SurfaceSampler } from './SurfaceSampler';

/** Number of random points tried before the surface counts as full. */
const TRIES = 60;

const UP = new Vector3(0, 1, 0);

/** Points in a hash grid whose cells are as wide as the smallest distance between points. */
class PointGrid {
  private readonly cells = new Map<string, Vector3[]>();

  constructor(private readonly distance: number) {}

  /** Adds a point, unless another one is closer than the smallest distance. @returns whether it was added */
  add(point: Vector3): boolean {
    const { distance, cells } = this;
    if (distance <= 0) return true;
    const [x, y, z] = [point.x, point.y, point.z].map((value) => Math.floor(value / distance));
    for (let i = x - 1; i <= x + 1; i++) {
      for (let j = y - 1; j <= y + 1; j++) {
        for (let k = z - 1; k <= z + 1; k++) {
          for (const other of cells.get(`${i} ${j} ${k}`) ?? []) if (other.distanceTo(point) < distance) return false;
        }
      }
    }
    const key = `${x} ${y} ${z}`;
    const cell = cells.get(key);
    if (cell) cell.push(point.clone());
    else cells.set(key, [point.clone()]);
    return true;
  }
}

/**
 * Places scattered over a surface, determined by the seed; a larger count only adds places.
 * @param feet - for each original, height of its origin above its lowest point (m)
 * @returns fewer than `count` when no more fit at the smallest distance; none without a surface
 */
export function scatteredPlaces(
  arrangement: Arrangement,
  surface: SurfaceSampler,
  feet: readonly number[],
): ArrangedPlace[] {
  const { count, seed, minimumDistance, height, aligns, randomTurn, sizeVariation } = arrangement;
  const places: ArrangedPlace[] = [];
  if (surface.area === 0) return places;
  const random = createRandom(seed);
  surface.setRandomGenerator(random);
  const grid = new PointGrid(minimumDistance);
  const point = new Vector3();
  const normal = new Vector3();
  const turn = new Quaternion();
  const about = new Quaternion();
  const total = Math.min(MOST_COPIES, Math.max(feet.length, Math.round(count)));
  for (let tries = 0; places.length < total && tries < TRIES; tries++) {
    surface.sample(point, normal);
    // rejected points consume random numbers too, so that later ones do not depend on rounding of the distance
    const [angle, size] = [random() * 2 * Math.PI, random()];
    if (!grid.add(point)) continue;
    tries = -1;
    const source = places.length % feet.length;
    const scale = 1 + sizeVariation * (2 * size - 1);
    point.addScaledVector(normal, height).addScaledVector(aligns ? normal : UP, feet[source] * scale);
    turn.identity();
    if (aligns) turn.setFromUnitVectors(UP, normal);
    if (randomTurn) turn.multiply(about.setFromAxisAngle(UP, angle));
    const turned = aligns || randomTurn;
    places.push({
      source,
      position: point.toArray(),
      ...(turned && { turn: turn.toArray() as [number, number, number, number] }),
      ...(sizeVariation > 0 && { scale }),
    });
  }
  return places;
}
