import { describeValue } from '@farol/editing/fields';
import { MOST_VIEWS, type SceneView, viewProblem } from '../core/SceneViews';
import type { FileView } from './FarolFile';
import type { PathLike } from './FilePath';
import { join, type ProblemList } from './ProblemList';

const members = ['name', 'position', 'target', 'fov', 'orthographic'] as const;

/** Reads the camera bookmarks of a scene file, each at a distinct place. */
export function readViews(value: unknown, path: PathLike, problems: ProblemList): FileView[] {
  const taken = new Set<unknown>();
  return problems.array(value, path).flatMap((given, i) => {
    const at = join(path, i);
    const record = problems.record(given, at);
    problems.onlyKeys(record, at, ['place', ...members]);
    const { place } = record;
    if (typeof place !== 'number' || !Number.isInteger(place) || place < 1 || place > MOST_VIEWS) {
      problems.add(join(at, 'place'), `must be a whole number from 1 to ${MOST_VIEWS}, not ${describeValue(place)}.`);
    } else if (taken.has(place))
      problems.add(join(at, 'place'), `is ${place} as that of another view: give another one.`);
    taken.add(place);
    let isRight = true;
    for (const member of members) {
      const problem = viewProblem(record as Record<keyof SceneView, unknown>, member);
      if (problem === null) continue;
      problems.add(join(at, member), problem);
      isRight = false;
    }
    return isRight ? [record as unknown as FileView] : [];
  });
}
