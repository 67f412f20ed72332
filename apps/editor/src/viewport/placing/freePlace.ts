import { Box3, Vector3 } from 'three';

/** Boxes that overlap by less than this (m) only touch. */
const TOUCH = 0.005;

/** Maximum number of shifts tried along one axis. */
const STEPS = 200;

const size = new Vector3();
const other = new Vector3();
const moved = new Box3();

/** Whether an obstacle, such as a room, is so much larger than a box that the box may be inside. */
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

/** Distance (m) along a world axis after which a box overlaps no obstacle; null when there is none. */
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

/** Costs (m), larger than any distance: of a fully hidden place, and of a place beyond the support's edge. */
const [HIDDEN, FALLS] = [1e3, 1e6];

/** Hidden share of a box (0 to 1) up to which it still counts as visible. */
export const HIDDEN_ENOUGH = 0.3;

/**
 * Shift that frees a box from obstacles: the shortest along a horizontal world axis, preferring visible places, then
 * those to the right on screen. Zero when the box is free, or cannot be freed.
 * @param obstacles - boxes of other objects; a room around the box is ignored
 * @param right - direction to the right on screen (world)
 * @param support - box that it stands on and should stay on; null for the ground
 * @param hiddenShare - share (0 to 1) of a box outside the view or behind obstacles
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
      // preference: right, then towards or away from the eye, then left; beyond the support's edge last
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
