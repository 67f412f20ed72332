import { formatCount, t } from '@farol/editing';
import type { FileProblem, ForeignAddress } from '@farol/engine/files';
import type { Dialogs } from '../model/Dialogs';

/** Names of assets that are listed for a host. */
const LISTED = 4;

/** What is wanted from each host. */
function wants(addresses: readonly ForeignAddress[]): FileProblem[] {
  return [...new Set(addresses.map(({ origin }) => origin))].map((path) => {
    const list = addresses.filter(({ origin }) => origin === path);
    const names = list.slice(0, LISTED).map(({ asset }) => asset);
    const more = list.length > LISTED ? t(' and {count} more', { count: formatCount(list.length - LISTED) }) : '';
    return { path, problem: `${names.join(', ')}${more}` };
  });
}

/** Asks whether a scene may load from other hosts. @param name - of the file or link @returns whether from all of them */
export const askForHosts = (dialogs: Dialogs, name: string, addresses: readonly ForeignAddress[]): Promise<boolean> =>
  dialogs.show({
    kind: 'problems',
    title: t('{name} asks for files of other hosts', { name }),
    text: t('They would learn that you open it, and when. Without them the rest of the scene opens. It asks for:'),
    problems: wants(addresses),
    action: t('Load from these hosts'),
    refusal: t('Open without them'),
    listLabel: t('Hosts'),
  });
