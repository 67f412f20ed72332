import { formatCount, formatTime, t, tCount } from '@farol/editing';
import type { SessionInfo } from '../../model/SessionInfo';

/** Describes a draft by time, file, number of objects and last edit, to tell drafts of one scene apart. */
export function describeSession({ time, fileName, objects, edit }: SessionInfo): string {
  const parts = [formatTime(time, true)];
  if (fileName) parts.push(fileName);
  if (objects !== undefined)
    parts.push(tCount(objects, '{objects} object', '{objects} objects', { objects: formatCount(objects) }));
  if (edit) parts.push(t('last edit: {edit}', { edit }));
  return parts.join(' · ');
}
