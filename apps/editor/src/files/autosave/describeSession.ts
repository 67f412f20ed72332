import { formatTime, t, tCount } from '@farol/editing';
import type { SessionInfo } from '../../model/SessionInfo';

const integer = new Intl.NumberFormat('en');

/** What tells two drafts of one scene apart: when it was stored, its file, how many objects, the last edit. */
export function describeSession({ time, fileName, objects, edit }: SessionInfo): string {
  const parts = [formatTime(time, true)];
  if (fileName) parts.push(fileName);
  if (objects !== undefined)
    parts.push(tCount(objects, '{objects} object', '{objects} objects', { objects: integer.format(objects) }));
  if (edit) parts.push(t('last edit: {edit}', { edit }));
  return parts.join(' · ');
}
