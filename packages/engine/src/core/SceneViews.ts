import { describeValue, type Vector3Tuple } from '@farol/editing/fields';

/** Named camera bookmark of an editor. */
export interface SceneView {
  readonly name: string;
  /** Eye position in world space (m). */
  readonly position: Vector3Tuple;
  /**
   * Point that the camera faces, in world space (m); never the eye. Its distance gives the extent of an orthographic
   * view.
   */
  readonly target: Vector3Tuple;
  /** Vertical field of view, from 0.01 to 3.1 (rad). */
  readonly fov: number;
  readonly orthographic: boolean;
}

/** Number of camera bookmarks of a scene; their places are numbered 1 to this. */
export const MOST_VIEWS = 9;

const isFinite3 = (value: unknown): boolean =>
  Array.isArray(value) && value.length === 3 && value.every(Number.isFinite);

/** Problem of a member of a view, as a sentence without its subject; null for none. */
export function viewProblem(view: Readonly<Record<keyof SceneView, unknown>>, member: keyof SceneView): string | null {
  const value = view[member];
  const not = `, not ${describeValue(value)}.`;
  if (member === 'name') return typeof value === 'string' ? null : `must be text${not}`;
  if (member === 'orthographic') return typeof value === 'boolean' ? null : `must be true or false${not}`;
  if (member === 'fov')
    return typeof value === 'number' && value >= 0.01 && value <= 3.1
      ? null
      : `must be an angle from 0.01 to 3.1 rad${not}`;
  if (!isFinite3(value)) return `must be [x, y, z], each a finite number (m)${not}`;
  const [a, b] = [view.position, view.target] as readonly (readonly number[])[];
  const isSame = member === 'target' && isFinite3(a) && a.every((each, i) => each === b[i]);
  return isSame ? 'must be elsewhere than position.' : null;
}

/** Camera bookmarks of a scene for editors, saved with the scene; the picture does not depend on them. */
export class SceneViews {
  private readonly byPlace = new Map<number, SceneView>();

  /** @param changed - called after a view was set or removed */
  constructor(private readonly changed: (place: number) => void) {}

  /** The bookmarks, each with its place (1 to 9), in the order of the places. */
  get entries(): readonly (readonly [number, SceneView])[] {
    return [...this.byPlace].toSorted(([a], [b]) => a - b);
  }

  get(place: number): SceneView | null {
    return this.byPlace.get(place) ?? null;
  }

  /**
   * Sets or removes (null) the bookmark of a place.
   * @param place - 1 to 9
   * @throws RangeError for another place, or naming what is wrong with the view
   */
  set(place: number, view: SceneView | null): void {
    if (!Number.isInteger(place) || place < 1 || place > MOST_VIEWS)
      throw new RangeError(`A view's place is ${place}; give a whole number from 1 to ${MOST_VIEWS}.`);
    if (view === this.get(place)) return;
    if (view === null) this.byPlace.delete(place);
    else {
      for (const member of ['name', 'position', 'target', 'fov', 'orthographic'] as const) {
        const problem = viewProblem(view, member);
        if (problem !== null) throw new RangeError(`A view's ${member} ${problem}`);
      }
      this.byPlace.set(place, view);
    }
    this.changed(place);
  }
}
