import { describeValue } from '@farol/editing/fields';
import { pictureProblem, type ScenePicture } from '../core/ScenePicture';
import { join, type ProblemList } from './ProblemList';

/** Reads the small picture of a scene file. */
export function readPicture(value: unknown, path: string, problems: ProblemList): ScenePicture {
  const record = problems.record(value, path);
  problems.onlyKeys(record, path, ['url', 'chosen']);
  const problem = pictureProblem(record.url);
  if (problem !== null) problems.add(join(path, 'url'), problem);
  if (record.chosen !== undefined && record.chosen !== true)
    problems.add(join(path, 'chosen'), `must be true or absent, not ${describeValue(record.chosen)}.`);
  return { url: record.url as string, ...(record.chosen === true ? { chosen: true } : {}) };
}
