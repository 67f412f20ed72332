import { Box3, Vector3 } from 'three';

/** Boxes that reach into each other by less than this (m) touch. */
const TOUCH = 0.005;

/** How often something is moved on, at most. */
const STEPS = 200;

const size = new Vector3();
const other = new Vector3();
const moved = new Box3();

/** Whether a box has room for another one several times over, as a room has: it is no obstacle. */
function isRoomFor(obstacle: Box3, box: Box3): boolean {
  obstacle.getSize(other);
  box.getSize(size);
  return other.x > 3 * size.x && other.y > 3 * size.y && other.z > 3 * size.z;
}

const overlaps = (a: Box3, b: Box3): boolean =>
  a.min.x < b.max.x - TOUCH &&
  a.max.x > b.min.x + TOUCH &&
  a.min.y < b.max.y - TOUCH &&
  a.max.y > b.min.y + TOUCH &&
  a.min.z < b.max.z - TOUCH &&
  a.max.z > b.min.z + TOUCH;

/** How far (m) a box must go along an axis of the world to be free of all obstacles; null when that has no end. */
function wayOut(box: Box3, obstacles: readonly Box3[], axis: 'x' | 'z', sign: 1 | -1, gap: number): number | null {
  const moved = box.clone();
  let way = 0;
  for (let step = 0; step < STEPS; step++) {
    const obstacle = obstacles.find((each) => overlaps(each, moved));
    if (!obstacle) return way;
    const by = sign > 0 ? obstacle.max[axis] - moved.min[axis] + gap : moved.max[axis] - obstacle.min[axis] + gap;
    way += by;
    moved.min[axis] += sign * by;
    moved.max[axis] += sign * by;
  }
  return null;
}

/** What costs more than any way (m): to be hidden altogether, and to be beside what carries it. */
const [HIDDEN, FALLS] = [1e3, 1e6];

/** A box of which so much (0 to 1) is hidden is found all the same. */
export const HIDDEN_ENOUGH = 0.3;

/**
 * How a box is to be moved sideways so that it stands beside what is there already: the shortest way along an axis of the
 * world that does not end where much of it is hidden, to the right of the picture where two are about as short; not at all where
 * it is free or nothing helps.
 * @param obstacles - boxes of what is there; a room that it is in is none
 * @param right - to the right of the picture, in the world
 * @param support - what it stands on, which it shall stay on; null for the ground
 * @param hiddenShare - how much (0 to 1) of a box would not be seen, for obstacles before it or the picture's edge
 */
export function freePlace(
  box: Box3,
  obstacles: readonly Box3[],
  right: Vector3,
  support: Box3 | null,
  hiddenShare: (box: Box3, obstacles: readonly Box3[]) => number,
): Vector3 {
  const solid = obstacles.filter((each) => !isRoomFor(each, box));
  const shift = new Vector3();
  if (!solid.some((each) => overlaps(each, box))) return shift;
  box.getSize(size);
  const gap = Math.max(0.05, Math.min(0.5, 0.1 * Math.max(size.x, size.z)));
  let best = Infinity;
  const middle = box.getCenter(new Vector3());
  for (const axis of ['x', 'z'] as const) {
    for (const sign of [1, -1] as const) {
      const way = wayOut(box, solid, axis, sign, gap);
      if (way === null) continue;
      const end = middle[axis] + sign * way;
      const falls = support !== null && (end < support.min[axis] || end > support.max[axis]);
      // to the right first, then towards the eye or away, then to the left; off the edge last
      let cost = way * (1.15 - 0.15 * sign * right[axis]) + (falls ? FALLS : 0);
      if (cost >= best) continue;
      moved.copy(box);
      moved.min[axis] += sign * way;
      moved.max[axis] += sign * way;
      const hidden = hiddenShare(moved, solid);
      if (hidden > HIDDEN_ENOUGH) cost += hidden * HIDDEN;
      if (cost >= best) continue;
      best = cost;
      shift.set(0, 0, 0);
      shift[axis] = sign * way;
    }
  }
  return shift;
}
