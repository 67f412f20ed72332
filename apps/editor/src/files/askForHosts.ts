import { formatCount, shortText, t } from '@farol/editing';
import type { FileProblem, ForeignAddress } from '@farol/engine/files';
import type { Dialogs } from '../model/Dialogs';
import { firstNames } from './firstNames';

/** Maximum numbers of assets listed for each host, and of hosts listed. */
const LISTED = 4;
const HOSTS = 30;

/** One line for each host, with the assets that it provides. */
function wants(addresses: readonly ForeignAddress[]): FileProblem[] {
  const byOrigin = new Map<string, string[]>();
  for (const { origin, asset } of addresses) {
    const names = byOrigin.get(origin);
    if (names) names.push(asset);
    else byOrigin.set(origin, [asset]);
  }
  const listed = [...byOrigin].slice(0, HOSTS).map(([origin, list]): FileProblem => {
    return { path: shortText(origin, 120), problem: firstNames(list, LISTED) };
  });
  const count = byOrigin.size - listed.length;
  return count > 0
    ? [...listed, { path: '', problem: t('… and {count} more', { count: formatCount(count) }) }]
    : listed;
}

/**
 * Asks whether a scene may load assets from other hosts. @param name - name of the file or link @returns whether all of
 * them are allowed
 */
export const askForHosts = (dialogs: Dialogs, name: string, addresses: readonly ForeignAddress[]): Promise<boolean> =>
  dialogs.show({
    kind: 'problems',
    title: t('{name} asks for files of other hosts', { name }),
    text: t('The hosts would learn that you open it, and when. Without them the rest of the scene opens. It loads:'),
    problems: wants(addresses),
    action: t('Load from these hosts'),
    refusal: t('Open without them'),
    listLabel: t('Hosts'),
  });
