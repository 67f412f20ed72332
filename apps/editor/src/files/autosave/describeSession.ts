import { formatCount, formatTime, t, tCount } from '@farol/editing';
import type { SessionInfo } from '../../model/SessionInfo';

/** What tells two drafts of one scene apart: when it was stored, its file, how many objects, the last edit. */
export function describeSession({ time, fileName, objects, edit }: SessionInfo): string {
  const parts = [formatTime(time, true)];
  if (fileName) parts.push(fileName);
  if (objects !== undefined)
    parts.push(tCount(objects, '{objects} object', '{objects} objects', { objects: formatCount(objects) }));
  if (edit) parts.push(t('last edit: {edit}', { edit }));
  return parts.join(' · ');
}
