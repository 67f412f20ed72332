import type { PrefabLink } from '../core/Prefab';
import type { PathLike } from './FilePath';
import { join, type ProblemList } from './ProblemList';

export function readLink(value: unknown, path: PathLike, problems: ProblemList): PrefabLink {
  const record = problems.record(value, path);
  problems.onlyKeys(record, path, ['prefab', 'source', 'pinned']);
  const at = join(path, 'pinned');
  const pinned = record.pinned === undefined ? [] : problems.array(record.pinned, at);
  return {
    prefab: problems.text(record.prefab, join(path, 'prefab')),
    source: problems.text(record.source, join(path, 'source')),
    ...(pinned.length > 0 ? { pinned: pinned.map((each, i) => problems.text(each, join(at, i))) } : {}),
  };
}
